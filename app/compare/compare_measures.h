// What is measured of the panes of a comparison, computed in the background.
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

/// Fills the table: CNR_S and share of light by measuresOf(), as the command line does, once the OTFs are there and
/// nothing plays; the flicker when it is asked for, of the panes whose OTF changes with the view (what is the same for
/// every view has none). A pane of another phase than the tube cores' has no measures, as these compare on one volume.
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
    /// All of them must outlive this. `work` is what both threads do.
    CompareMeasures(const Parts& parts, const Work& work, QObject* parent = nullptr);

    [[nodiscard]] bool busy() const { return m_thread.busy() || m_flickerThread.busy(); }
    [[nodiscard]] const std::vector<CompareRow>& rows() const { return m_rows; }
    void measureFlicker();
    /// Ends both. What was cancelled is measured again once the document asks for something else.
    void cancel();
    /// What was cancelled is measured again with the next frame.
    void askAgain() { m_asked = m_measured; }
    /// The frames of the flicker's motion: so many degrees to either side, in steps of as many.
    static constexpr double flickerDegrees = 10.0, flickerStep = 2.0;
    /// Units between its rays: it is measured on pictures as coarse as these.
    static constexpr double flickerRaySpacing = 3.0;

public slots:
    /// Measures what the document says now, where that was not measured yet.
    void follow();

signals:
    void rowsChanged(const std::vector<echolucent::CompareRow>& rows);
    void measuringFlicker(bool measuring);
    /// There is not memory enough to measure.
    void failed(const QString& sentence);

private:
    /// What is measured, by pane of those that can be.
    struct Asked {
        std::shared_ptr<const Volume> raw, shown;
        SpeckleReduction reduction = SpeckleReduction::off;
        std::shared_ptr<const AdaptiveOtf> otf;
        std::vector<Classification> classifications{};
        std::vector<std::size_t> places{};
        friend bool operator==(const Asked&, const Asked&) = default;
    };
    /// A pane as its flicker is measured.
    struct FlickeringPane {
        std::size_t place = 0;
        DesignerConfig config;
        AdaptiveOtfConfig method;
        OtfSmoothing smoothing = OtfSmoothing::none;
        bool steady = false;  ///< it shows one OTF for all frames
        friend bool operator==(const FlickeringPane&, const FlickeringPane&) = default;
    };
    /// What flickers are measured of.
    struct FlickerAsked {
        std::shared_ptr<const Volume> raw, shown;
        SpeckleReduction reduction = SpeckleReduction::off;
        Viewpoint start{};
        MotionAxis axis = MotionAxis::y;
        CurveAdjustment adjustment{};
        std::vector<FlickeringPane> panes{};
        friend bool operator==(const FlickerAsked&, const FlickerAsked&) = default;
    };
    /// Of the panes in what wanted() gave.
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
    std::optional<Asked> m_asked, m_measured;  ///< asked for last, and those of m_measures
    std::vector<ClassificationMeasures> m_measures;
    std::optional<FlickerAsked> m_flickerOf;   ///< what the flickers were measured of
    std::map<std::size_t, double> m_flickers;  ///< by place
    std::vector<CompareRow> m_rows;
    // Last, so that their threads have ended before anything above is destroyed.
    NewestWinsThread m_thread;
    NewestWinsThread m_flickerThread;
};

}  // namespace echolucent
