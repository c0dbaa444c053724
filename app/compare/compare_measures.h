// Measures the panes of a comparison in the background.
#pragma once

#include <QObject>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/compare/compared_views.h"
#include "app/motion/motion_player.h"
#include "app/otf/kept_surfaces.h"
#include "processing/pane_picture/pane_measures.h"
#include "widgets/threads/newest_wins_thread.h"

namespace echolucent {

/// Fills the table of the comparison. Each pane is measured as measuresOfPanes() does: on the voxels of its own phase,
/// in the view that is shown, with surfaces that depend on scan and view alone. The panes are measured once the OTFs
/// are there, nothing plays and nothing is dragged, and then their OTFs are timed. The flicker is measured on request.
/// It is 0 if a pane keeps one OTF for every view. If the document says so, the panes are coloured by what is measured,
/// and plain as long as it is not.
class CompareMeasures : public QObject {
    Q_OBJECT

public:
    struct Parts {
        DocumentModel& model;
        OpenStudy& openStudy;
        Works& works;
        PaneOtfs& otfs;
        ComparedViews& views;
        const MotionPlayer& player;
        KeptSurfaces& surfaces;
    };
    /// What the parameters refer to must outlive this object. `work` describes the work of both threads.
    CompareMeasures(const Parts& parts, const Work& work, QObject* parent = nullptr);

    [[nodiscard]] bool busy() const { return m_thread.busy() || m_flickerThread.busy(); }
    [[nodiscard]] const std::vector<CompareRow>& rows() const { return m_rows; }
    void measureFlicker();
    /// An OTF's time is the median of this many runs. If one takes retimedBelow ms or more, it counts alone.
    static constexpr int timedRuns = 3;
    static constexpr double retimedBelow = 50.0;
    /// Ends both threads' work. Cancelled measures begin again once the document asks for something else.
    void cancel();
    /// Lets cancelled measures of panes begin again with the next follow(). The flicker does not begin again.
    void askAgain() { m_asked = m_measured; }
    /// The motion of the flicker: degrees to either side, and degrees from frame to frame.
    static constexpr double flickerDegrees = 10.0, flickerStep = 2.0;
    /// Units between the rays of the pictures for the flicker.
    static constexpr double flickerRaySpacing = 3.0;

public slots:
    /// Measures what the document asks for, if that is not measured yet, and shows the rows. Does nothing while the
    /// comparison is hidden.
    void follow();

signals:
    void rowsChanged(const std::vector<echolucent::CompareRow>& rows);
    void measuringFlicker(bool measuring);
    /// The memory is too small to measure.
    void failed(const QString& sentence);

private:
    /// A pane that is measured. The place in the request is the pane's.
    struct AskedPane {
        std::shared_ptr<const Volume> raw, shown;  ///< of the pane's phase
        Classification classification{};
        std::optional<OtfRequest> otf{};  ///< what is timed; none: a curve that needs no OTF
        friend bool operator==(const AskedPane&, const AskedPane&) = default;
    };
    /// A request for measures of all panes.
    struct Asked {
        SurfaceSource source{};
        std::vector<AskedPane> panes{};
        friend bool operator==(const Asked&, const Asked&) = default;
    };
    /// A pane's answer.
    struct Measured {
        std::optional<PaneMeasures> measures{};  ///< none if no surface is known
        std::shared_ptr<const ColouredRays> colours{};
        std::optional<double> milliseconds{};  ///< of the OTF; none if none is computed
    };
    /// The time of an OTF, measured before.
    struct TimedOtf {
        OtfRequest otf;
        double milliseconds = 0.0;
    };
    /// The choices of a pane that its flicker depends on.
    struct FlickeringPane {
        std::size_t place = 0;
        DesignerConfig config;
        std::shared_ptr<const Volume> raw, shown;
        SpeckleReduction reduction = SpeckleReduction::off;
        AdaptiveOtfConfig method;
        OtfSmoothing smoothing = OtfSmoothing::none;
        bool steady = false;  ///< one OTF for all frames
        friend bool operator==(const FlickeringPane&, const FlickeringPane&) = default;
    };
    struct FlickerAsked {
        Viewpoint start{};
        MotionAxis axis = MotionAxis::screenVertical;
        CurveAdjustment adjustment{};
        std::vector<FlickeringPane> panes{};
        friend bool operator==(const FlickerAsked&, const FlickerAsked&) = default;
    };
    [[nodiscard]] std::optional<FlickerAsked> flickerWanted(const std::optional<Asked>& asked) const;
    [[nodiscard]] static std::optional<double> flickerOf(const FlickerAsked& asked, const FlickeringPane& pane,
                                                         const Progress& progress);
    /// Empty only if the work was cancelled.
    [[nodiscard]] static std::optional<std::vector<Measured>> measured(const Asked& asked,
                                                                       const std::vector<TimedOtf>& timed,
                                                                       KeptSurfaces& kept, const Progress& progress);
    [[nodiscard]] std::vector<TimedOtf> timedBefore(const Asked& asked) const;
    void fail();
    void forgetStudy();
    [[nodiscard]] std::optional<Asked> wanted() const;
    void showRows(const std::optional<Asked>& asked);
    void showColours(bool known);
    void showMeasured() { showRows(wanted()); }

    DocumentModel& m_model;
    OpenStudy& m_openStudy;
    PaneOtfs& m_otfs;
    ComparedViews& m_views;
    const MotionPlayer& m_player;
    KeptSurfaces& m_surfaces;
    std::optional<Asked> m_asked, m_measured;  ///< the newest request; the request of m_measures
    std::vector<Measured> m_measures;          ///< by place
    std::optional<FlickerAsked> m_flickerOf;   ///< the request of m_flickers
    std::map<std::size_t, double> m_flickers;  ///< by place
    std::vector<CompareRow> m_rows;
    // Last, so that their threads have ended before anything above is destroyed.
    NewestWinsThread m_thread;
    NewestWinsThread m_flickerThread;
};

}  // namespace echolucent
