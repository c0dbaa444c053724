// Measures the panes of a comparison in the background.
#pragma once

#include <QObject>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/compare/compared_views.h"
#include "app/motion/motion_player.h"
#include "processing/comparison/classification_measures.h"
#include "widgets/threads/newest_wins_thread.h"

namespace echolucent {

/// Fills the table of the comparison. measuresOf() gives CNR_S and share of light, as on the command line. They are
/// measured once the OTFs are there, nothing plays and nothing is dragged. The flicker is measured on request. It is 0
/// if a pane keeps one OTF for every view. A pane has no measures if it shows other voxels than those of the tube
/// cores, as another phase does: all panes are compared on one volume.
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
    };
    /// What the parameters refer to must outlive this object. `work` describes the work of both threads.
    CompareMeasures(const Parts& parts, const Work& work, QObject* parent = nullptr);

    [[nodiscard]] bool busy() const { return m_thread.busy() || m_flickerThread.busy(); }
    [[nodiscard]] const std::vector<CompareRow>& rows() const { return m_rows; }
    void measureFlicker();
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
    /// A request for measures of all panes that can be measured.
    struct Asked {
        std::shared_ptr<const Volume> raw, shown;
        SpeckleReduction reduction = SpeckleReduction::off;
        std::shared_ptr<const AdaptiveOtf> otf;
        std::vector<Classification> classifications{};
        std::vector<std::size_t> places{};
        friend bool operator==(const Asked&, const Asked&) = default;
    };
    /// The choices of a pane that its flicker depends on.
    struct FlickeringPane {
        std::size_t place = 0;
        DesignerConfig config;
        AdaptiveOtfConfig method;
        OtfSmoothing smoothing = OtfSmoothing::none;
        bool steady = false;  ///< one OTF for all frames
        friend bool operator==(const FlickeringPane&, const FlickeringPane&) = default;
    };
    struct FlickerAsked {
        std::shared_ptr<const Volume> raw, shown;
        SpeckleReduction reduction = SpeckleReduction::off;
        Viewpoint start{};
        MotionAxis axis = MotionAxis::screenVertical;
        CurveAdjustment adjustment{};
        std::vector<FlickeringPane> panes{};
        friend bool operator==(const FlickerAsked&, const FlickerAsked&) = default;
    };
    [[nodiscard]] std::optional<FlickerAsked> flickerWanted(const std::optional<Asked>& asked) const;
    [[nodiscard]] static std::optional<double> flickerOf(const FlickerAsked& asked, const FlickeringPane& pane,
                                                         const Progress& progress);
    void fail();
    void forgetStudy();
    [[nodiscard]] std::optional<Asked> wanted() const;
    void showRows(const std::optional<Asked>& asked);
    void showMeasured() { showRows(wanted()); }

    DocumentModel& m_model;
    OpenStudy& m_openStudy;
    PaneOtfs& m_otfs;
    ComparedViews& m_views;
    const MotionPlayer& m_player;
    std::optional<Asked> m_asked, m_measured;  ///< the newest request; the request of m_measures
    std::vector<ClassificationMeasures> m_measures;
    std::optional<FlickerAsked> m_flickerOf;   ///< the request of m_flickers
    std::map<std::size_t, double> m_flickers;  ///< by place
    std::vector<CompareRow> m_rows;
    // Last, so that their threads have ended before anything above is destroyed.
    NewestWinsThread m_thread;
    NewestWinsThread m_flickerThread;
};

}  // namespace echolucent
