// The workstation's one window: puts the picture, the OTF editor, the method, the motion and the study together.
#pragma once

#include <QElapsedTimer>
#include <QMainWindow>
#include <QTimer>
#include <optional>

#include "app/motion_player.h"
#include "app/session.h"
#include "app/settings.h"
#include "processing/viewpoint.h"
#include "widgets/motion/otf_course.h"
#include "widgets/panels/message_bar.h"
#include "widgets/volume_view/volume_view_widget.h"

class QAction;
class QDockWidget;
class QMenu;

namespace echolucent {

class MethodPanel;
class MotionPanel;
class OtfCoursePanel;
class OtfEditor;
class RunStatus;
class StudyPanel;
class ViewPanel;

class MainWindow : public QMainWindow {
    Q_OBJECT
    /// True while nothing loads, computes, renders or plays: what a script waits for (with idleChanged).
    Q_PROPERTY(bool idle READ idle NOTIFY idleChanged)

public:
    /// settingsFile: as in Settings; tests give one of their own.
    explicit MainWindow(const QString& settingsFile = {}, QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Opens a file or a DICOM folder; asks for the layout where the file has no header and none is remembered.
    void open(const QString& path, const ReadOptions& options = {});
    void openSimulatedScan();
    /// Opens a manual curve (JSON) and makes it active; the edit can be undone. False, with a message, where it cannot.
    bool openCurve(const QString& path);
    bool saveCurve(const QString& path);
    /// Saves what the 3D view shows, without any name of a patient or file in it.
    bool savePicture(const QString& path);

    [[nodiscard]] bool idle() const;
    [[nodiscard]] Session& session() { return m_session; }
    [[nodiscard]] VolumeViewWidget& volumeView() { return *m_volumeView; }
    [[nodiscard]] OtfEditor& otfEditor() { return *m_otfEditor; }
    [[nodiscard]] MotionPlayer& motionPlayer() { return m_motionPlayer; }
    /// The OTFs of the motion so far.
    [[nodiscard]] const OtfCourse& otfCourse() const { return m_course; }

    /// What the picture shows and why it looks as it does, in a few sentences.
    [[nodiscard]] QString explanation() const;

signals:
    void idleChanged(bool idle);
    /// The window is on the screen for the first time.
    void shown();

protected:
    void showEvent(QShowEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    // main_window.cpp: the parts and how they hang together
    void createParts();
    QDockWidget* addDock(const QString& title, const QString& name, QWidget* content);
    void connectSession();
    void connectMethod();
    void restoreSettings();
    void keepSettings();
    void updateIdle();

    // main_window_picture.cpp: the 3D view and its panel
    void connectPicture();
    void connectLook();
    void takeRenderer();
    void restoreLook();
    void keepLook();

    // main_window_study.cpp: what follows when something was opened, computed or turned
    void studyOpened();
    void volumeChanged();
    void otfComputed();
    void showNearCutRange();
    void computeFor(const Viewpoint& view);
    void computeForThisView();
    void setNearCut(double mm);
    void suggestNearCut();
    void takeNearCut(const NearCutSuggestion& suggestion);
    void setBeamAxis(BeamAxis axis);
    void resetView();
    [[nodiscard]] AdaptiveOtfConfig methodConfig() const;

    // main_window_motion.cpp: the motion of probe and object, frame by frame
    void connectMotion();
    void connectMotionPanel();
    void showMotionFrame(double angle, int phase);
    void showFrameWithItsOtf();
    void announceShownFrame();
    void cameraMovedByPerson();
    void showFrameRate();
    void beginMotionAtRest();
    [[nodiscard]] Viewpoint motionView() const;
    [[nodiscard]] SampledCurve curveToShow(const AdaptiveOtf& otf);
    void keepCourseOf(const AdaptiveOtfConfig& config);
    [[nodiscard]] CourseFrame courseFrame() const;

    // main_window_files.cpp: files in and out
    void chooseAndOpen();
    void chooseAndOpenFolder();
    void chooseAndOpenRaw();
    void openRaw(const QString& path);
    void openFailed(const QString& path, const Failure& failure);
    void showRecentFiles();
    void chooseAndOpenCurve();
    bool chooseAndSaveCurve();
    void chooseAndSavePicture();
    bool mayLoseManualCurve();
    /// Fails where `path` is a file of the open study.
    [[nodiscard]] Result<void> mayOverwrite(const QString& path) const;
    bool report(const Result<void>& written);

    // main_window_actions.cpp: menus and shortcuts
    void createActions();
    QAction* addAction(QMenu* menu, const QString& text, const QString& name, const QKeySequence& shortcut,
                       std::function<void()> run);
    void showExplanation();
    void showAbout();

    Settings m_settings;
    Session m_session;
    MotionPlayer m_motionPlayer;
    OtfCourse m_course;

    MessageBar* m_messageBar = nullptr;
    VolumeViewWidget* m_volumeView = nullptr;
    OtfEditor* m_otfEditor = nullptr;
    MethodPanel* m_methodPanel = nullptr;
    ViewPanel* m_viewPanel = nullptr;
    MotionPanel* m_motionPanel = nullptr;
    OtfCoursePanel* m_coursePanel = nullptr;
    QDockWidget* m_courseDock = nullptr;
    StudyPanel* m_studyPanel = nullptr;
    RunStatus* m_runStatus = nullptr;
    QMenu* m_recentMenu = nullptr;
    QMenu* m_docksMenu = nullptr;

    Viewpoint m_otfView;      ///< the view of the newest OTF asked for
    Viewpoint m_motionStart;  ///< the view at angle 0 of the motion
    Viewpoint m_nearCutView;  ///< the view for which a near cut is looked for
    bool m_lookingForNearCut = false;
    std::shared_ptr<const AdaptiveOtf> m_shownOtf;  ///< of the adaptive curve shown; null before a study's first
    bool m_frameWaits = false;                      ///< the present frame of the motion is shown once its OTF is there
    /// What the course's rows have in common; another one begins a new course.
    struct CourseKey {
        const Study* study = nullptr;
        Viewpoint start;
        MotionAxis axis = MotionAxis::y;
        AdaptiveOtfConfig config;
        OtfCourse::Rows rows = OtfCourse::Rows::angles;
        int fixed = 0;  ///< the phase or the angle that stays; 0 where both change
        friend bool operator==(const CourseKey&, const CourseKey&) = default;
    };
    std::optional<CourseKey> m_courseKey;
    std::optional<PictureReport> m_movement;  ///< of the newest picture that followed the hand
    bool m_newStudy = false;                  ///< the next OTF is the first of a study: the camera is set with it
    const Study* m_shownStudy = nullptr;      ///< told apart by address only
    QElapsedTimer m_frameClock;               ///< since the frame of the motion shown last
    double m_frameSeconds = 0;                ///< running mean; 0: none yet
    bool m_idle = true;
    bool m_shown = false;
};

}  // namespace echolucent
