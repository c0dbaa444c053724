// The workstation's one window: joins the picture, the OTF editor, the method, the motion and the study.
#pragma once

#include <QMainWindow>
#include <functional>
#include <memory>

#include "app/motion/motion_frames.h"
#include "app/otf/kept_surfaces.h"
#include "app/picture/document_view.h"
#include "app/picture/picture_caption.h"
#include "app/sessions/shown_study.h"
#include "app/settings/settings.h"
#include "app/study/study_names.h"
#include "app/window/window_layout.h"
#include "widgets/control_keys.h"
#include "widgets/escape_order.h"
#include "widgets/hand_gesture.h"
#include "widgets/large_pointer.h"
#include "widgets/otf_editor/otf_editor.h"
#include "widgets/threads/works.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

struct PictureFacts;
class ComingStudy;
class CompareRoom;
class CurveAndPictureFiles;
class EditorEarlyLight;
class EditorOtfs;
class FullScreen;
class HistoryControls;
class LessonAuthor;
class LessonHandouts;
class LessonPlayer;
class LessonStage;
class LoadingPicture;
class MovieFiles;
class NearCutFinder;
class PanesSaving;
class PictureControls;
class PresetControls;
class RecentPictures;
class ReportSaving;
class ReviewRoom;
class SessionKeeping;
class SideControls;
class StudyOpening;
class StudySides;
class TubeCoreChoice;
class TubeCoreExplaining;
class TubeCorePage;
class TubeCoresInPictures;
class WindowFaces;

/// Owns the document, the threads behind the open study and the widgets, and connects them. Its units hold what happens
/// between them. No unit and no widget keeps what the document holds.
class MainWindow : public QMainWindow {
    Q_OBJECT
    /// True while nothing loads, computes, renders or plays. Scripts wait for it (with idleChanged).
    Q_PROPERTY(bool idle READ idle NOTIFY idleChanged)

public:
    /// `settingsFile` is given to Settings; tests use one of their own. `begin` is called first, so that a study is
    /// read while the window is made.
    explicit MainWindow(const QString& settingsFile = {}, const std::function<void(OpenStudy&)>& begin = {});
    ~MainWindow() override;

    /// As StudyOpening::open().
    void open(const QString& path, const ReadOptions& options = {});
    void openSimulatedScan();
    /// As in CurveAndPictureFiles.
    bool openCurve(const QString& path);
    bool saveCurve(const QString& path);
    bool savePicture(const QString& path);

    /// As ReportSaving::save().
    void saveReport(const QString& path, bool withPatient, bool withAppendix = false);

    [[nodiscard]] bool idle() const { return m_works.idle(); }
    [[nodiscard]] const Works& works() const { return m_works; }
    [[nodiscard]] DocumentModel& document() { return m_document; }
    [[nodiscard]] OpenStudy& openStudy() { return m_openStudy; }
    [[nodiscard]] PaneOtfs& otfs() { return *m_otfs; }
    [[nodiscard]] NearCutFinder& nearCutFinder() { return *m_nearCutFinder; }
    [[nodiscard]] VolumeViewWidget& volumeView() { return *m_widgets.picture; }
    [[nodiscard]] CompareRoom& compareRoom() { return *m_compare; }
    [[nodiscard]] MovieFiles& movieFiles() { return *m_movies; }
    [[nodiscard]] PanesSaving& panesSaving() { return *m_panesSaving; }
    [[nodiscard]] SessionKeeping& sessionKeeping() { return *m_sessions; }
    [[nodiscard]] OtfEditor& otfEditor() { return *m_widgets.editor; }
    [[nodiscard]] MotionPlayer& motionPlayer() { return m_motionPlayer; }
    /// The OTFs of the motion so far.
    [[nodiscard]] const OtfCourse& otfCourse() const { return m_course; }

    /// The surfaces with which panes are measured.
    [[nodiscard]] const KeptSurfaces& surfaces() const { return m_surfaces; }

    [[nodiscard]] TubeCoreChoice& tubeCoreChoice() { return *m_tubeCoreChoice; }
    [[nodiscard]] TubeCoreExplaining& tubeCoreExplaining() { return *m_tubeCoreExplaining; }
    [[nodiscard]] TubeCorePage& tubeCorePage() { return *m_tubeCorePage; }
    [[nodiscard]] TubeCoresInPictures& tubeCoresInPictures() { return *m_tubeCoresInPictures; }

    /// Review and Teach.
    [[nodiscard]] WindowFaces& faces() { return *m_faces; }
    [[nodiscard]] LessonPlayer& lessonPlayer() { return *m_lessons; }
    [[nodiscard]] LessonAuthor& lessonAuthor() { return *m_lessonAuthor; }
    [[nodiscard]] LessonHandouts& lessonHandouts() { return *m_lessonHandouts; }

    /// What Escape ends. A part that begins something that Escape ends adds itself.
    [[nodiscard]] EscapeOrder& escapeOrder() { return m_escapes; }

    /// A few sentences: what the picture shows and why it looks so.
    [[nodiscard]] QString explanation() const;
    /// The same of the pane that is explained: in the comparison the one that had the focus last.
    [[nodiscard]] QString explanationOfPane() const;

    /// None: the menu View holds the panels of the present face.
    QMenu* createPopupMenu() override { return nullptr; }

signals:
    void idleChanged(bool idle);
    /// The window is on the screen for the first time.
    void shown();

protected:
    void showEvent(QShowEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void createUnits();
    void followWorks();
    void connectProgress();
    void arrangeForComparison(bool shown);
    /// The strip of sides is seen if it is wanted, beside the panes of the review room alone.
    void followStrip();
    void createTubeCores();
    void createLessons();
    void connectUnits();
    void connectCaption();
    void connectExplanation();
    void connectResets();
    void connectNames();
    void createActions();
    void countLeftUnsaved();
    void restoreSettings();
    void keepSettings();
    [[nodiscard]] ShownSpeckle shownSpeckle() const;
    /// What `explain` makes of the facts of a pane; nothing without a study. `name` is as in PictureFacts.
    [[nodiscard]] QStringList explained(std::size_t pane, const QString& name,
                                        const std::function<QStringList(const PictureFacts&)>& explain) const;
    /// The place of the side that opening took because a person took it last of such a scan.
    [[nodiscard]] std::optional<std::size_t> rememberedSide() const;
    /// Whether the first pane's OTF is of the kind of designer that the document asks for.
    [[nodiscard]] bool designIsShown() const;

    Works m_works;
    Settings m_settings;
    StudyNames m_names{m_settings};
    DocumentModel m_document;
    HandGesture m_hand;
    LargePointer m_largePointer;
    ControlKeys m_controlKeys;
    EscapeOrder m_escapes;
    OpenStudy m_openStudy{m_works};
    MotionPlayer m_motionPlayer;
    OtfCourse m_course;
    KeptSurfaces m_surfaces;

    WindowLayout m_widgets;
    FullScreen* m_fullScreen = nullptr;

    // These units use the widgets and must not outlive them.
    std::unique_ptr<PaneOtfs> m_otfs;
    std::unique_ptr<ShownPanes> m_panes;
    std::unique_ptr<DocumentView> m_view;
    std::unique_ptr<EditorOtfs> m_editorOtfs;
    std::unique_ptr<EditorEarlyLight> m_earlyLight;
    std::unique_ptr<PictureControls> m_pictureControls;
    std::unique_ptr<StudySides> m_sides;
    std::unique_ptr<SideControls> m_sideControls;
    std::unique_ptr<PresetControls> m_presets;
    std::unique_ptr<MotionFrames> m_motion;
    std::unique_ptr<ShownStudy> m_shownStudy;
    std::unique_ptr<LoadingPicture> m_loadingPicture;
    std::unique_ptr<ComingStudy> m_comingStudy;
    std::unique_ptr<NearCutFinder> m_nearCutFinder;
    std::unique_ptr<RecentPictures> m_recentPictures;
    std::unique_ptr<StudyOpening> m_opening;
    std::unique_ptr<CurveAndPictureFiles> m_files;
    std::unique_ptr<MovieFiles> m_movies;
    std::unique_ptr<ReviewRoom> m_room;
    std::unique_ptr<CompareRoom> m_compare;
    std::unique_ptr<ReportSaving> m_report;
    std::unique_ptr<PanesSaving> m_panesSaving;
    std::unique_ptr<SessionKeeping> m_sessions;
    std::unique_ptr<HistoryControls> m_history;
    std::unique_ptr<TubeCoreChoice> m_tubeCoreChoice;
    std::unique_ptr<TubeCoresInPictures> m_tubeCoresInPictures;
    std::unique_ptr<TubeCoreExplaining> m_tubeCoreExplaining;
    std::unique_ptr<TubeCorePage> m_tubeCorePage;
    std::unique_ptr<WindowFaces> m_faces;
    std::unique_ptr<LessonStage> m_lessonStage;
    std::unique_ptr<LessonPlayer> m_lessons;
    std::unique_ptr<LessonHandouts> m_lessonHandouts;
    std::unique_ptr<LessonAuthor> m_lessonAuthor;
    bool m_idle = true;               ///< as it was told last
    bool m_planesTabWasThere = true;  ///< before the comparison was shown
    bool m_shown = false;
};

}  // namespace echolucent
