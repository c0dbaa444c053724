// What OTF designers make for panes of the document: the one place where it is computed.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/study/open_study.h"
#include "processing/designers/design.h"
#include "processing/designers/designer_config.h"
#include "widgets/document/document_model.h"
#include "widgets/newest_wins_thread.h"

namespace echolucent {

/// What a designer made for a pane, and of what.
struct ViewDesign {
    Design design;
    double milliseconds = 0.0;
    std::shared_ptr<const Volume> raw, shown;
    DesignerConfig config{};  ///< that it was made with
};

/// Follows document and study, and computes in a thread of its own what is not there yet: what several panes ask for
/// alike is computed once, and what was made before is kept, as long as it is few. Of the phase otfPhaseOf() a designer
/// is given the raw voxels and the newest ones, which are its quiet ones once they are made; while the quiet ones of a
/// study of up to OpenStudy::quietFirstVoxels voxels are being made, it waits for them.
class ViewDesigns : public QObject {
    Q_OBJECT

public:
    /// Both outlive this.
    ViewDesigns(DocumentModel& model, OpenStudy& openStudy, QObject* parent = nullptr);

    /// Panes that somebody looks at, beside the first one if it has a designer. What their designers make is computed
    /// too. If they have none, it is their adaptive OTF as AdaptiveConfig makes it: without the tube cores that are
    /// never placed for them, of their own phases and frames.
    void setExtraPanes(std::vector<std::size_t> panes);

    /// The newest that fits what the document asks; until that is there, the one before it for that pane; null before
    /// the first.
    [[nodiscard]] std::shared_ptr<const ViewDesign> of(std::size_t pane) const;
    /// Whether of(pane) is what the document asks for now.
    [[nodiscard]] bool isNewest(std::size_t pane) const;
    /// Whether what the document asks for was cancelled or has failed: it does not come by itself.
    [[nodiscard]] bool isRefused(std::size_t pane) const;
    /// Whether that is so of any view.
    [[nodiscard]] bool isAnyRefused() const { return !m_refused.empty(); }
    [[nodiscard]] bool busy() const { return m_thread.busy(); }
    /// Ends what is computed, for all views. It is not begun again before something else is asked for, or
    /// computeAgain().
    void cancel();
    /// Computes what was cancelled or has failed.
    void computeAgain();

    /// What is run; tests put one in its place that ends on command.
    using Run = std::function<std::optional<Design>(const DesignerConfig&, const DesignerInput&, const Progress&)>;
    void setRun(Run run) { m_run = std::move(run); }

    /// Of finished designs, so many are kept.
    static constexpr std::size_t keptCount = 32;

signals:
    /// of(pane) is another.
    void computed(std::size_t pane);
    void failed(std::size_t pane, const QString& sentence);
    /// cancel() has ended what was computed.
    void cancelled();
    void busyChanged(bool busy);
    void progressed(double share);

private:
    /// What is asked of a designer. The same request has the same answer, bit for bit.
    struct Request {
        DesignerConfig config;
        std::shared_ptr<const Volume> raw{}, shown{};
        SpeckleReduction reduction = SpeckleReduction::off;
        Viewpoint view{};            ///< the default where no tube cores are read
        AdaptiveOtfConfig method{};  ///< the same
        friend bool operator==(const Request&, const Request&) = default;
    };
    /// A finished one. It keeps no voxels alive.
    struct Kept {
        Request request;  ///< without its volumes
        std::weak_ptr<const Volume> raw, shown;
        Design design;
        double milliseconds = 0.0;
    };
    /// What a view has, and what it was asked for with.
    struct Made {
        Request request;
        std::shared_ptr<const ViewDesign> design;
    };

    void follow();
    void giveWhatIsKept();
    void computeNext();
    void compute(const Request& request);
    void take(const Request& request, Design design, double milliseconds);
    void fail(const Request& request, const QString& sentence);
    void give(std::size_t pane, const Request& request, std::shared_ptr<const ViewDesign> design);
    [[nodiscard]] const DesignerConfig* configFor(std::size_t pane) const;
    /// No value where the view has no design and is no extra one, nothing is open, or voxels are waited for.
    [[nodiscard]] std::optional<Request> requestOf(std::size_t pane) const;
    [[nodiscard]] std::vector<std::size_t> wantedPanes() const;
    [[nodiscard]] const Kept* kept(const Request& request) const;
    [[nodiscard]] bool refused(const Request& request) const;
    [[nodiscard]] bool isOfSomePhase(const Request& request) const;

    DocumentModel& m_model;
    OpenStudy& m_openStudy;
    Run m_run;
    std::vector<std::size_t> m_extraPanes;
    std::map<std::size_t, Request> m_wanted;  ///< by pane
    std::map<std::size_t, Made> m_made;       ///< by pane
    std::vector<Kept> m_kept;                 ///< the newest last
    std::vector<Request> m_refused;           ///< were cancelled or have failed, and are wanted still
    std::optional<Request> m_running;
    const Study* m_study = nullptr;  ///< told apart by address only
    bool m_following = false, m_stale = false;
    // Last, so that it has ended before anything above is destroyed.
    NewestWinsThread m_thread;
};

}  // namespace echolucent
