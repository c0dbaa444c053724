// Sets up figures of the paper in the window, on the open study or on a simulated scan.
#pragma once

#include <QObject>
#include <deque>
#include <optional>

#include "app/otf/shown_panes.h"
#include "processing/document/study_reference.h"
#include "widgets/threads/works.h"

class QMainWindow;

namespace echolucent {

class MessageBar;
class MotionPlayer;
class OtfEditor;

/// Makes a figure (withFigure()) one step of the document, whose undo and redo bring back the motion's angle too. Then
/// shows the figure's frames one after the other, each once the OTFs of the one before are there: so the panel Motion
/// has their OTFs, and smoothings have their past. A person who moves the motion meanwhile ends this.
class LessonFigures : public QObject {
    Q_OBJECT

public:
    struct Parts {
        QMainWindow& window;  ///< has the docks of figures
        DocumentModel& model;
        OpenStudy& openStudy;
        Works& works;
        PaneOtfs& otfs;
        ShownPanes& panes;
        MotionPlayer& player;
        OtfEditor& editor;
        MessageBar& messages;
    };
    /// What the parameters refer to must outlive this object.
    explicit LessonFigures(const Parts& parts, const Work& work, QObject* parent = nullptr);

    /// Sets up a figure on the open study, or on a simulated scan. If another study is open than the scan, a message
    /// asks first; once a person agrees, the scan is opened, and what is left of the study is kept as ever. Does
    /// nothing if there is no study to set it up on.
    void show(int figure, const std::optional<SimulatedScan>& scan = std::nullopt);
    /// Ends what show() still waits for, and its frames.
    void cancel();

signals:
    /// The document shows a figure.
    void setUp();

private:
    void ask(int figure, const SimulatedScan& scan);
    void open(int figure, const SimulatedScan& scan);
    void setUpFigure(int number);
    void showCurvesOfFigure6();
    void bringToFront(const QString& dock);
    void showNextFrame();

    Parts m_parts;
    int m_waits = 0;  ///< number of the figure that waits for its simulated scan; 0 if none waits
    SimulatedScan m_scan;
    std::deque<int> m_frames;    ///< still to show
    std::optional<int> m_shown;  ///< the last of the frames that was shown
    Works::UnderWay m_underWay;  ///< while frames are shown
};

}  // namespace echolucent
