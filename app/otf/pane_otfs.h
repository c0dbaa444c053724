// What OTFs the document asks for, and the one place where they are computed.
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

/// Follows document and study, tells the study which voxels the document wants, and computes in a thread of its own
/// what is not there yet: the adaptive OTF of the scene, and for each pane that somebody looks at what it is rendered
/// with. Requests that are equal are computed once, and what was computed before is kept (KeptOtfs).
///
/// Tube cores look from the document's side (otfViewpointOf()). In a motion with an OTF for each view they look along
/// the frame that was shown last, until the side or the beam is another.
///
/// While quiet voxels of a phase are being made, an OTF waits for them if something is shown of the phase meanwhile, or
/// if the study is small (quietFirstVoxels), so that one picture and not two follow its opening; what plays never
/// waits. A study whose strokes are being cut for the first time waits too.
class PaneOtfs : public QObject {
    Q_OBJECT

public:
    /// The place, beside the panes' numbers, of the adaptive OTF of the scene: that of the first pane, whether it is
    /// rendered with it or not.
    static constexpr std::size_t adaptiveOfScene = mostPanes;

    /// All outlive this.
    PaneOtfs(DocumentModel& model, OpenStudy& openStudy, Works& works, QObject* parent = nullptr);

    /// Whether somebody looks at all panes, and not at the first one alone.
    void setComparing(bool comparing);
    [[nodiscard]] bool comparing() const { return m_comparing; }
    /// Whether a motion plays.
    void setPlaying(bool playing);

    /// The OTF that the document asks for at a place; until that is there, the one before it; null before the first of
    /// a study, and where a pane's picture depends on no OTF that is computed.
    [[nodiscard]] std::shared_ptr<const ComputedOtf> of(std::size_t place) const;
    /// The same if a designer made it for a pane that the document gives a designer; else null.
    [[nodiscard]] std::shared_ptr<const ComputedOtf> designOf(std::size_t pane) const;
    /// What tube cores saw for of(adaptiveOfScene); null where that is null.
    [[nodiscard]] std::shared_ptr<const AdaptiveOtf> adaptive() const;
    /// Whether of(place) is what the document asks for now.
    [[nodiscard]] bool isNewest(std::size_t place) const;
    /// Whether what the document asks for was cancelled or has failed: it does not come by itself.
    [[nodiscard]] bool isRefused(std::size_t place) const;
    /// Whether that is so of any place.
    [[nodiscard]] bool isAnyRefused() const { return !m_refused.empty(); }
    [[nodiscard]] bool busy() const { return m_thread.busy(); }
    /// Whether what is computed is no adaptive OTF, and so may take long.
    [[nodiscard]] bool designing() const;
    /// Ends what is computed, for all panes. It is not begun again before something else is asked for, or
    /// computeAgain(). The scene's adaptive OTF is ended only if it is what runs.
    void cancel();
    /// Computes what was cancelled or has failed.
    void computeAgain();
    /// Makes the direction in which the view looks now the document's side, and the phase that it shows that of one OTF
    /// for all, as one step.
    void computeForThisView();

    [[nodiscard]] const KeptOtfs& kept() const { return m_kept; }
    /// Forgets adaptive OTFs that were computed before: another loop of a motion has no use for them.
    void forgetAdaptive() { m_kept.forgetAdaptive(); }

    /// The default reduction takes 0.08 s for each million on two cores (docs/speckle.md): less than a second for so
    /// many.
    static constexpr std::int64_t quietFirstVoxels = 10'000'000;

    /// What is run; tests put one in its place that ends on command.
    using Run = std::function<std::optional<Design>(const DesignerConfig&, const DesignerInput&, const Progress&)>;
    void setRun(Run run);

signals:
    /// of(place) is another.
    void computed(std::size_t place);
    /// What the document asks for, or what is there of it, may be another.
    void followed();
    void failed(std::size_t place, const QString& sentence);
    /// cancel() has ended what was computed.
    void cancelled();
    void progressed(double share);

private:
    /// What a place has. A pane that has lost its designer keeps what that made until its curve is there.
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
    /// No value if nothing is open, nobody looks there, or voxels are waited for.
    [[nodiscard]] std::optional<OtfRequest> requestOf(std::size_t place) const;
    [[nodiscard]] Viewpoint viewOf(std::size_t pane) const;
    [[nodiscard]] bool waitsForVoxels(std::size_t place, int phase) const;
    [[nodiscard]] bool refused(const OtfRequest& request) const;
    [[nodiscard]] bool isOfSomePhase(const OtfRequest& request) const;

    DocumentModel& m_model;
    OpenStudy& m_openStudy;
    Run m_run;
    bool m_comparing = false, m_playing = false;
    /// What the document said when the view was followed last.
    struct Followed {
        Viewpoint fromSide{};
        MotionOtf otf = MotionOtf::oneOtf;
        double angle = 0.0;
        int phase = 0;
        Pose pose{};
    };
    Viewpoint m_view;  ///< along which the scene's tube cores look
    Followed m_followed;
    std::map<std::size_t, OtfRequest> m_wanted;  ///< by place
    std::map<std::size_t, Made> m_made;          ///< by place
    KeptOtfs m_kept;
    std::vector<OtfRequest> m_refused;  ///< were cancelled or have failed, and are wanted still
    std::optional<OtfRequest> m_running;
    const Study* m_study = nullptr;  ///< told apart by address only
    bool m_following = false, m_stale = false;
    // Last, so that it has ended before anything above is destroyed.
    NewestWinsThread m_thread;
};

}  // namespace echolucent
