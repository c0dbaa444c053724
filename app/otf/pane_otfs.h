// Decides which OTFs the document asks for, and computes them: the one place that does.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/otf/kept_otfs.h"
#include "app/study/open_study.h"
#include "processing/adaptive/adaptive_otf_result.h"
#include "widgets/document/document_model.h"
#include "widgets/threads/newest_wins_thread.h"

namespace echolucent {

/// Follows document and study, and tells the study which voxels the document wants. Computes missing OTFs in its own
/// thread: the adaptive OTF of the scene, and the OTF of each pane that somebody looks at. Equal requests are computed
/// once, and computed OTFs are kept (KeptOtfs).
///
/// Tube cores look from the document's side (otfViewpointOf()). In a motion with an OTF for each view they look along
/// the last frame, until the side or the beam changes.
///
/// An OTF may wait for quiet voxels of its phase while these are made. It waits if its place has an OTF of the phase
/// already, which is shown meanwhile. It also waits if the study is small (quietFirstVoxels): then one picture follows
/// its opening, not two. A motion that plays never waits for quiet voxels. The first OTF of a phase also waits while
/// strokes are cut out of the phase.
class PaneOtfs : public QObject {
    Q_OBJECT

public:
    /// The place of the scene's adaptive OTF, beside the panes' numbers. This OTF has the phase, view and method of the
    /// first pane, even if that pane is rendered with another OTF.
    static constexpr std::size_t adaptiveOfScene = mostPanes;

    /// What the parameters refer to must outlive this object.
    PaneOtfs(DocumentModel& model, OpenStudy& openStudy, Works& works, QObject* parent = nullptr);

    /// Sets whether somebody looks at all panes, or at the first one alone.
    void setComparing(bool comparing);
    [[nodiscard]] bool comparing() const { return m_comparing; }
    void setPlaying(bool playing);

    /// The OTF that the document asks for at a place. Until it is there, the one before it. Null before the first OTF
    /// of a study, if the pane's picture needs no computed OTF, and if nobody looks at the pane.
    [[nodiscard]] std::shared_ptr<const ComputedOtf> of(std::size_t place) const;
    /// of(pane), but null unless a designer of the pane made it and the document gives the pane a designer.
    [[nodiscard]] std::shared_ptr<const ComputedOtf> designOf(std::size_t pane) const;
    /// The AdaptiveOtf in of(adaptiveOfScene); null if that is null.
    [[nodiscard]] std::shared_ptr<const AdaptiveOtf> adaptive() const;
    /// Whether of(place) is the OTF that the document asks for. False while that OTF waits for voxels.
    [[nodiscard]] bool isNewest(std::size_t place) const;
    /// Whether the requested OTF was cancelled or has failed: it does not come by itself.
    [[nodiscard]] bool isRefused(std::size_t place) const;
    /// Whether the OTF of any place is refused.
    [[nodiscard]] bool isAnyRefused() const { return !m_refused.empty(); }
    [[nodiscard]] bool busy() const { return m_thread.busy(); }
    /// Whether the OTF being computed is not adaptive, so that it may take long.
    [[nodiscard]] bool designing() const;
    /// Ends the computation, for all panes. It begins again only on another request or computeAgain(). The scene's
    /// adaptive OTF is cancelled only if it is the one being computed.
    void cancel();
    /// Computes cancelled and failed OTFs again.
    void computeAgain();
    /// Makes one step: the present direction of view becomes the document's side, and the phase shown becomes the phase
    /// of one OTF for all. Then does as computeAgain(). Does nothing if no study is open.
    void computeForThisView();

    [[nodiscard]] const KeptOtfs& kept() const { return m_kept; }
    /// Forgets kept adaptive OTFs: another loop of a motion does not need them.
    void forgetAdaptive() { m_kept.forgetAdaptive(); }

    /// The default reduction takes 0.08 s per million voxels on two cores (docs/speckle.md): below a second for this
    /// many.
    static constexpr std::int64_t quietFirstVoxels = 10'000'000;

    /// The function that designs. Tests put in one that ends on command. setRun() forgets all kept OTFs.
    using Run = std::function<std::optional<Design>(const DesignerConfig&, const DesignerInput&, const Progress&)>;
    void setRun(Run run);

signals:
    /// of(place) is another.
    void computed(std::size_t place);
    /// The document may ask for other OTFs, or others may be there.
    void followed();
    void failed(std::size_t place, const QString& sentence);
    /// cancel() has ended a computation.
    void cancelled();
    void progressed(double share);

private:
    /// The OTF of a place. A pane that loses its designer keeps the design until its curve is there.
    struct Made {
        std::shared_ptr<const ComputedOtf> otf;
        bool byDesigner = false;  ///< the document gave the pane a designer
    };

    void follow();
    void followView();
    void begin();
    void askForVoxels();
    void giveWhatIsKept();
    void computeNext();
    void stop();
    void compute(const OtfRequest& request);
    void take(const OtfRequest& request, Design design, double milliseconds);
    void fail(const OtfRequest& request, const QString& sentence);
    void give(std::size_t place, std::shared_ptr<const ComputedOtf> otf);
    [[nodiscard]] std::vector<std::size_t> wantedPlaces() const;
    /// No value if no study is open, nobody looks at the place, its picture needs no computed OTF, or its OTF waits for
    /// voxels.
    [[nodiscard]] std::optional<OtfRequest> requestOf(std::size_t place) const;
    [[nodiscard]] Viewpoint viewOf(std::size_t pane) const;
    [[nodiscard]] bool waitsForVoxels(std::size_t place, int phase) const;
    [[nodiscard]] bool refused(const OtfRequest& request) const;
    [[nodiscard]] bool isOfSomePhase(const OtfRequest& request) const;

    DocumentModel& m_model;
    OpenStudy& m_openStudy;
    Run m_run;
    bool m_comparing = false, m_playing = false;
    /// The document's values when the view was followed last.
    struct Followed {
        Viewpoint fromSide{};
        MotionOtf otf = MotionOtf::oneOtf;
        double angle = 0.0;
        int phase = 0;
        Pose pose{};
    };
    Viewpoint m_view;  ///< tube cores of the scene look along it
    Followed m_followed;
    std::map<std::size_t, OtfRequest> m_wanted;  ///< by place
    std::map<std::size_t, Made> m_made;          ///< by place
    KeptOtfs m_kept;
    std::vector<OtfRequest> m_refused;  ///< cancelled or failed, and still wanted
    std::optional<OtfRequest> m_running;
    const Study* m_study = nullptr;  ///< compared by address only
    bool m_following = false, m_stale = false;
    // Last, so that it has ended before anything above is destroyed.
    NewestWinsThread m_thread;
};

}  // namespace echolucent
