// The widgets of the window and where they stand.
#pragma once

#include <QList>
#include <array>

class QDockWidget;
class QMainWindow;
class QStackedWidget;
class QWidget;

namespace echolucent {

class CompareGrid;
class ComparePanel;
class CurveSliders;
class DesignerPanel;
class DocumentModel;
class ExplainPanel;
class MeasurementsPanel;
class HistoryPanel;
class LessonsPanel;
class MessageBar;
class MethodPanel;
class MotionPanel;
class OpeningLabel;
class OtfCourse;
class OtfCoursePanel;
class OtfEditor;
class PaneGrid;
class PlanePane;
class PresetsPanel;
class RoomPanel;
class RunStatus;
class SideStrip;
class StudyPanel;
class TheoryPanel;
class TubeCorePanel;
class ViewPanel;
class VolumeViewWidget;
class Works;

/// The widgets of the window that others ask for. The window owns them.
struct WindowLayout {
    MessageBar* messages = nullptr;
    OpeningLabel* opening = nullptr;
    SideStrip* sides = nullptr;
    QStackedWidget* rooms = nullptr;  ///< the review room, then the comparison
    PaneGrid* panes = nullptr;
    CompareGrid* compared = nullptr;
    ComparePanel* compare = nullptr;
    std::array<PlanePane*, 3> planes{};  ///< A, B, C
    VolumeViewWidget* picture = nullptr;
    OtfEditor* editor = nullptr;
    MethodPanel* method = nullptr;
    DesignerPanel* designers = nullptr;
    CurveSliders* sliders = nullptr;
    ViewPanel* controls = nullptr;
    PresetsPanel* presets = nullptr;
    RoomPanel* room = nullptr;
    MeasurementsPanel* measurements = nullptr;
    MotionPanel* motion = nullptr;
    OtfCoursePanel* course = nullptr;
    StudyPanel* facts = nullptr;
    ExplainPanel* explain = nullptr;
    TheoryPanel* theory = nullptr;
    HistoryPanel* history = nullptr;
    TubeCorePanel* tubeCores = nullptr;
    LessonsPanel* lessons = nullptr;
    RunStatus* status = nullptr;
    QList<QDockWidget*> docks{};  ///< in the order in which people are shown their names
};

/// Makes the widgets and puts them into the window: planes and picture in the middle, the strip of sides left of them,
/// the panels in one column of tabs right of them, the messages over the picture's lower edge. Works and document must
/// outlive them.
[[nodiscard]] WindowLayout layOut(QMainWindow& window, Works& works, DocumentModel& document, const OtfCourse& course);

/// The dock in which a panel stands. Throws std::invalid_argument if it stands in none.
[[nodiscard]] QDockWidget& dockOf(const QWidget& panel);
/// Shows the dock of `panel` in front of the other docks.
void showDockOf(const QWidget& panel);

}  // namespace echolucent
