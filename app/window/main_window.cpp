#include "app/window/main_window.h"

#include <QAbstractButton>
#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QStackedWidget>
#include <QUrl>

#include "app/compare/compare_room.h"
#include "app/explain/tube_core_explaining.h"
#include "app/explain/tube_core_page.h"
#include "app/explain/tube_cores_in_pictures.h"
#include "app/lesson/lesson_author.h"
#include "app/lesson/lesson_handouts.h"
#include "app/lesson/lesson_player.h"
#include "app/lesson/lesson_stage.h"
#include "app/motion/movie_files.h"
#include "app/otf/editor_early_light.h"
#include "app/otf/editor_otfs.h"
#include "app/otf/near_cut_finder.h"
#include "app/picture/coming_study.h"
#include "app/picture/explanation.h"
#include "app/picture/loading_picture.h"
#include "app/picture/panes_saving.h"
#include "app/picture/picture_controls.h"
#include "app/picture/preset_controls.h"
#include "app/picture/side_controls.h"
#include "app/report/report_saving.h"
#include "app/sessions/history_controls.h"
#include "app/sessions/session_keeping.h"
#include "app/study/recent_pictures.h"
#include "app/study/study_opening.h"
#include "app/study/study_sides.h"
#include "app/window/curve_and_picture_files.h"
#include "app/window/full_screen.h"
#include "app/window/review_room.h"
#include "app/window/theme.h"
#include "app/window/window_faces.h"
#include "app/window/window_menus.h"
#include "app/window/window_place.h"
#include "app/window/window_tool_bar.h"
#include "widgets/accessibility/spoken_widget.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/opening_label.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/controls/run_status.h"
#include "widgets/controls/side_strip.h"
#include "widgets/controls/tool_tips.h"
#include "widgets/motion/otf_course_panel.h"
#include "widgets/otf_editor/curve_canvas.h"
#include "widgets/panels/explain_panel.h"
#include "widgets/panels/history_panel.h"
#include "widgets/panels/method_panel.h"
#include "widgets/panels/motion_panel.h"
#include "widgets/panels/view_panel.h"

namespace echolucent {

namespace {
constexpr int layoutVersion = 4;  // of the docks; an arrangement of an older version is not restored
}  // namespace

MainWindow::MainWindow(const QString& settingsFile, const std::function<void(OpenStudy&)>& begin)
    : m_settings(settingsFile) {
    m_openStudy.setSidesTaken([this] {
        SidesByKind taken;
        for (const auto& [kind, word] : m_settings.sidesTaken().asKeyValueRange())
            taken.emplace(kind.toStdString(), word.toStdString());
        return taken;
    });
    if (begin) begin(m_openStudy);
    watchSpokenWidgets();
    wearTheme(m_settings.theme());  // before there are widgets, which would be styled twice
    setObjectName("mainWindow");
    setWindowTitle(tr("Echolucent"));
    setAcceptDrops(true);
    new ToolTips(this);
    resize(roomySize);
    m_document.setHand([this] { return m_hand.current(); });
    m_widgets = layOut(*this, m_works, m_document, m_course);
    m_fullScreen = new FullScreen(*this, {m_widgets.motion});
    m_escapes.add(EscapeStep::drag, [this] { return m_widgets.picture->cancelDrag(); });
    connect(m_fullScreen, &FullScreen::changed, this, &MainWindow::followStrip);
    m_escapes.add(EscapeStep::fullScreen, [this] { return m_fullScreen->leave(); });
    createUnits();
    m_room->addTo(m_escapes);
    m_compare->addTo(m_escapes);
    connectProgress();
    connectUnits();
    connectExplanation();
    connectResets();
    connectNames();
    createActions();
    connectCaption();
    restoreSettings();
    followWorks();
}

MainWindow::~MainWindow() {
    hide();  // a half-typed number is taken while there is a document
    // Nobody can act any more on the signals of widgets that are being destroyed.
    m_works.disconnect();
    m_openStudy.disconnect(this);
    m_otfs->disconnect(this);
    m_motionPlayer.disconnect(this);
    m_compare->disconnect(this);
    m_widgets.picture->disconnect(this);
    m_earlyLight.reset();  // it asks the editor
    // The editor edits the document, which is destroyed before the window's children.
    delete m_widgets.editor;
}

void MainWindow::createUnits() {
    m_otfs = std::make_unique<PaneOtfs>(m_document, m_openStudy, m_works);
    m_panes = std::make_unique<ShownPanes>(m_document, m_openStudy, *m_otfs, m_course);
    m_view = std::make_unique<DocumentView>(m_document, m_openStudy, *m_panes, *m_widgets.picture);
    m_editorOtfs = std::make_unique<EditorOtfs>(
        EditorOtfs::Parts{m_document, *m_otfs, *m_panes, *m_widgets.editor, *m_widgets.designers, *m_widgets.messages});
    m_earlyLight = std::make_unique<EditorEarlyLight>(EditorEarlyLight::Parts{
        m_document, m_openStudy, m_works, *m_panes, *m_widgets.editor, *m_widgets.messages, m_surfaces});
    // A dock below another tab counts as visible, but nobody sees it.
    connect(&dockOf(*m_widgets.editor), &QDockWidget::visibilityChanged, m_earlyLight.get(),
            &EditorEarlyLight::setSeen);
    m_widgets.method->showDocument(m_document);
    m_pictureControls = std::make_unique<PictureControls>(
        PictureControls::Parts{m_document, m_openStudy, *m_widgets.picture, *m_widgets.controls, *m_widgets.editor,
                               *m_widgets.status, m_settings});
    m_sides = std::make_unique<StudySides>(m_document, m_openStudy, m_works);
    m_sideControls = std::make_unique<SideControls>(SideControls::Parts{
        m_document, m_openStudy, *m_sides, *m_widgets.picture, *m_widgets.sides, m_settings, m_works});
    connect(m_sideControls.get(), &SideControls::taking, &m_motionPlayer, &MotionPlayer::pause);
    m_presets = std::make_unique<PresetControls>(PresetControls::Parts{
        *this, m_document, m_openStudy, m_works, *m_widgets.presets, m_settings, *m_widgets.messages, m_names});
    m_motion = std::make_unique<MotionFrames>(MotionFrames::Parts{m_document, m_openStudy, m_works, *m_otfs, *m_panes,
                                                                  *m_view, *m_widgets.picture, m_motionPlayer,
                                                                  *m_widgets.motion, *m_widgets.course});
    m_shownStudy = std::make_unique<ShownStudy>(ShownStudy::Parts{
        *this, m_document, m_openStudy, *m_otfs, *m_panes, *m_widgets.picture, *m_motion, m_motionPlayer,
        *m_widgets.editor, *m_widgets.method, *m_widgets.controls, *m_widgets.facts, *m_widgets.status,
        *m_widgets.designers, *m_widgets.sliders, *m_widgets.course, *m_widgets.messages, m_names});
    m_loadingPicture = std::make_unique<LoadingPicture>(
        LoadingPicture::Parts{m_document, m_openStudy, m_works, *m_view, *m_widgets.picture});
    m_comingStudy = std::make_unique<ComingStudy>(ComingStudy::Parts{m_openStudy, m_works, *m_view, *m_widgets.picture,
                                                                     m_widgets.planes, *m_widgets.compared,
                                                                     *m_widgets.rooms, *m_widgets.opening, m_names});
    connect(m_loadingPicture.get(), &LoadingPicture::shown, m_widgets.opening, &OpeningLabel::place);
    m_nearCutFinder =
        std::make_unique<NearCutFinder>(NearCutFinder::Parts{m_document, m_openStudy, m_works, *m_widgets.messages});
    m_recentPictures = std::make_unique<RecentPictures>(m_settings, m_works, *m_widgets.picture);
    m_opening = std::make_unique<StudyOpening>(
        StudyOpening::Parts{*this, m_openStudy, m_works, m_settings, *m_widgets.messages, m_names, *m_recentPictures});
    m_files = std::make_unique<CurveAndPictureFiles>(
        CurveAndPictureFiles::Parts{*this, m_document, m_openStudy, *m_widgets.editor, *m_widgets.picture, m_settings,
                                    *m_widgets.messages, m_names, *m_view, [this]() -> std::optional<QImage> {
                                        if (!m_compare->shown()) return std::nullopt;
                                        return m_compare->image();
                                    }});
    m_movies = std::make_unique<MovieFiles>(MovieFiles::Parts{
        *this, m_document, m_openStudy, m_works, m_settings, *m_widgets.messages, m_names, *m_sides,
        [this] { return QSize(m_widgets.picture->settings().width, m_widgets.picture->settings().height); },
        [this](const QString& what) { return m_files->proposedName(what); },
        [this] { return m_compare->shown() ? m_widgets.compared->faces() : std::vector<PaneFace>{}; }});
    m_room = std::make_unique<ReviewRoom>(ReviewRoom::Parts{
        m_document, m_openStudy, m_works, m_motionPlayer, *m_widgets.panes, m_widgets.planes, *m_widgets.picture,
        *m_widgets.room, *m_widgets.measurements, *m_widgets.messages, m_settings});
    m_compare = std::make_unique<CompareRoom>(
        CompareRoom::Parts{*this, m_document, m_openStudy, m_works, m_motionPlayer, *m_widgets.rooms, *m_otfs, *m_panes,
                           m_surfaces, *m_widgets.compared, *m_widgets.compare, *m_widgets.editor, *m_widgets.messages,
                           m_settings, m_names, [this](const QString& what) { return m_files->proposedName(what); },
                           [this] { return explained(firstPane, {}, &explainView); },
                           [this](std::size_t pane) { return explained(pane, {}, &explainOtf); }});
    connect(m_fullScreen, &FullScreen::changed, m_compare.get(),
            [this] { m_compare->setFullScreen(m_fullScreen->active()); });
    m_report = std::make_unique<ReportSaving>(ReportSaving::Parts{
        *this, m_document, m_openStudy, m_works, *m_otfs, m_motionPlayer, m_widgets.planes, *m_widgets.picture,
        *m_widgets.editor, m_settings, *m_widgets.messages, m_names,
        [this](const QString& what) { return m_files->proposedName(what); }, [this] { return explanation(); }});
    m_panesSaving = std::make_unique<PanesSaving>(PanesSaving::Parts{
        *this, m_document, m_openStudy, m_works, *m_widgets.panes, m_widgets.planes, *m_widgets.picture,
        *m_widgets.compared, *m_panes, m_settings, *m_widgets.messages, m_names, *m_sides, *m_view,
        [this](const QString& what) { return m_files->proposedName(what); }, [this] { return rememberedSide(); }});
    m_sessions = std::make_unique<SessionKeeping>(SessionKeeping::Parts{*this, m_document, m_openStudy, m_works,
                                                                        *m_shownStudy, m_settings, *m_widgets.editor,
                                                                        *m_widgets.messages, m_names});
    connect(m_sessions.get(), &SessionKeeping::saved, this,
            [this] { m_recentPictures->setOpened(m_sessions->file()); });
    m_history =
        std::make_unique<HistoryControls>(m_document, m_sessions->snapshots(), *m_widgets.history, *m_widgets.messages);
}

void MainWindow::connectUnits() {
    connect(m_widgets.method, &MethodPanel::computeRequested, m_otfs.get(), &PaneOtfs::computeForThisView);
    connect(m_widgets.picture, &VolumeViewWidget::pictureFailed, this, [this] {
        m_motionPlayer.pause();
        m_widgets.messages->showMessage(MessageKind::error, tr("The picture needs more memory than this machine has."),
                                        MessageEnd::withStudy("picture"));
    });
    connect(m_widgets.picture, &VolumeViewWidget::pictureDelivered, m_widgets.messages,
            [this] { m_widgets.messages->takeBack("picture"); });
    connect(m_widgets.picture, &VolumeViewWidget::filesDropped, this,
            [this](const QList<QUrl>& files) { m_opening->openDropped(files); });
    connect(m_widgets.controls, &ViewPanel::frontSuggestionRequested, this, [this] {
        m_motionPlayer.pause();
        m_nearCutFinder->find();
    });
    connect(m_widgets.controls, &ViewPanel::frontFromHereRequested, this, [this] {
        m_motionPlayer.pause();
        m_nearCutFinder->fromHere();
    });
    connect(m_widgets.controls, &ViewPanel::noFrontRequested, this, [this] { m_nearCutFinder->takeAway(); });
    connect(m_widgets.controls, &ViewPanel::frontShownIn3d, m_room.get(), &ReviewRoom::showFrontIn3d);
    connect(m_widgets.controls, &ViewPanel::savePictureRequested, m_files.get(),
            &CurveAndPictureFiles::chooseAndSavePicture);
    connect(m_room.get(), &ReviewRoom::nothingToCut, m_widgets.messages, [this] {
        m_widgets.messages->showMessage(MessageKind::info,
                                        tr("Nothing shows where you drew, so nothing was cut. Draw over the picture."),
                                        MessageEnd::soon("scalpel"));
    });
    connect(&m_document, &DocumentModel::strokesChanged, m_widgets.messages,
            [this] { m_widgets.messages->takeBack("scalpel"); });
    connect(m_opening.get(), &StudyOpening::curveChosen, m_files.get(), &CurveAndPictureFiles::openCurveOfPerson);
    connect(m_opening.get(), &StudyOpening::presetsChosen, m_presets.get(), &PresetControls::importFrom);
    connect(m_compare.get(), &CompareRoom::cameraMoved, m_motion.get(), &MotionFrames::endByHand);
    // The next phase would begin the cancelled work anew.
    connect(m_otfs.get(), &PaneOtfs::cancelled, &m_motionPlayer, &MotionPlayer::pause);
    connect(&m_openStudy, &OpenStudy::studyOpened, this, [this] {
        const auto& finds = m_openStudy.finds();
        // A session has its own front.
        if (finds && finds->cut && !m_openStudy.saved()) m_nearCutFinder->tellOpening(*finds->cut);
    });
}

void MainWindow::connectResets() {
    connect(m_widgets.controls, &ViewPanel::resetRequested, this, [this] {
        m_pictureControls->resetView(m_sideControls->directionOfSide(m_shownStudy->opened()));
        m_motion->rewind();
    });
    connect(m_widgets.controls, &ViewPanel::resetAllRequested, this, [this] {
        m_motion->rewind();
        m_pictureControls->resetAll(m_shownStudy->opened());
    });
    connect(m_widgets.controls, &ViewPanel::frontResetRequested, this,
            [this] { m_pictureControls->resetFront(m_sideControls->frontOfSide(m_shownStudy->opened())); });
}

/// The bar of messages shows names as names or as numbers, whoever says the sentence.
void MainWindow::connectNames() {
    const auto read = [this] {
        m_widgets.messages->setReading([this](const QString& sentence) { return m_names.shownOfFile(sentence); },
                                       [this](const QString& sentence) { return m_names.shownBefore(sentence); });
    };
    connect(&m_names, &StudyNames::changed, this, read);
    read();
}

void MainWindow::createActions() {
    WindowCommands commands;
    commands.openFile = [this] { m_opening->chooseFile(); };
    commands.openFolder = [this] { m_opening->chooseFolder(); };
    commands.chooseSeries = [this] { m_opening->chooseSeries(); };
    commands.openRawFile = [this] { m_opening->chooseRawFile(); };
    commands.openSimulatedScan = [this] { openSimulatedScan(); };
    commands.fillRecentFiles = [this](QMenu& menu) { m_opening->fillRecentFiles(menu); };
    commands.savePicture = [this] { m_files->chooseAndSavePicture(); };
    commands.savePanes = [this] { m_panesSaving->choose(); };
    commands.saveMovie = [this] { m_movies->ask(FrameOutput::movie); };
    commands.savePictureSeries = [this] { m_movies->ask(FrameOutput::series); };
    commands.saveReport = [this] { m_report->choose(); };
    commands.numbersForNames = [this](bool numbers) { m_names.showNumbers(numbers); };
    commands.lightTheme = [this](bool light) {
        m_settings.setTheme(light ? Theme::light : Theme::dark);
        wearTheme(m_settings.theme());
    };
    commands.saveSession = [this] { m_sessions->save(); };
    commands.saveSessionAs = [this] { m_sessions->chooseAndSave(); };
    commands.fillLeftUnsaved = [this](QMenu& menu) { m_sessions->leftUnsaved().fillMenu(menu); };
    commands.showHistory = [this] { showDockOf(*m_widgets.history); };
    commands.copyPicture = [this] { m_files->copyPicture(); };
    commands.resetAll = [this] { emit m_widgets.controls->resetAllRequested(); };
    commands.toggleFullScreen = [this] { m_fullScreen->toggle(); };
    commands.largePointer = [this](bool large) { m_largePointer.show(large); };
    commands.resetView = [this] { emit m_widgets.controls->resetRequested(); };
    commands.reduceSpeckle = [this](int levels) { m_pictureControls->reduceSpeckle(levels); };
    commands.frontFromHere = [this] { emit m_widgets.controls->frontFromHereRequested(); };
    commands.findFront = [this] { emit m_widgets.controls->frontSuggestionRequested(); };
    commands.noFront = [this] { emit m_widgets.controls->noFrontRequested(); };
    for (QAction* action : m_sideControls->actions()) commands.sides << action;
    commands.showSides = [this](bool) { followStrip(); };
    commands.nextLighting = [this] { m_pictureControls->nextLighting(); };
    commands.computeForThisView = [this] { m_otfs->computeForThisView(); };
    commands.playOrPause = [this] { m_motionPlayer.togglePlaying(); };
    commands.turnMotion = [this](int degrees) { m_motionPlayer.stepBy(degrees); };
    commands.stepPhase = [this](int step) { m_motion->stepPhase(step); };
    commands.explain = [this] { showDockOf(*m_widgets.explain); };
    createMenus(*this, *m_widgets.editor, m_widgets.docks, dockOf(*m_widgets.course), commands);
    findChild<QAction*>("view.lightTheme")->setChecked(m_settings.theme() == Theme::light);
    findChild<QAction*>("view.numbersForNames")->setChecked(m_names.showsNumbers());
    const auto countSeries = [this] {
        enableOrSayWhy(*findChild<QAction*>("file.chooseSeries"), m_openStudy.seriesBeside() != nullptr,
                       tr("The folder holds no other series."));
    };
    connect(&m_openStudy, &OpenStudy::studyOpened, this, countSeries);
    countSeries();
    const auto offerPanes = [this] {
        const bool pair = m_compare->shown() && m_document.document().comparison.layout != ComparisonLayout::sideBySide;
        enableOrSayWhy(*findChild<QAction*>("file.savePanes"), !pair,
                       tr("A difference or a wipe is saved as it is shown: P saves it."));
    };
    connect(m_compare.get(), &CompareRoom::shownChanged, this, offerPanes);
    connect(&m_document, &DocumentModel::changed, this, offerPanes);
    offerPanes();
    connect(&m_sessions->leftUnsaved(), &LeftUnsaved::listChanged, this, &MainWindow::countLeftUnsaved);
    countLeftUnsaved();
    m_room->createMenu(*this);
    m_compare->createMenu();
    createTubeCores();
    m_faces = std::make_unique<WindowFaces>(
        WindowFaces::Parts{*this, m_settings, *m_widgets.status, *m_widgets.controls, *m_widgets.motion});
    createToolBar({*this, m_document, m_openStudy, *m_faces, dockOf(*m_widgets.editor)});
    createLessons();
}

void MainWindow::countLeftUnsaved() {
    const auto count = m_sessions->leftUnsaved().list().size();
    QAction* menu = findChild<QMenu*>("file.leftUnsaved")->menuAction();
    enableOrSayWhy(*menu, count > 0, tr("Nothing was left unsaved."));
    menu->setText(count > 0 ? tr("Left &unsaved (%1)").arg(count) : tr("Left &unsaved"));
}

void MainWindow::open(const QString& path, const ReadOptions& options) { m_opening->open(path, options); }
void MainWindow::openSimulatedScan() { m_openStudy.openSimulatedScan(); }
bool MainWindow::openCurve(const QString& path) { return m_files->openCurve(path); }
bool MainWindow::saveCurve(const QString& path) { return m_files->saveCurve(path); }
void MainWindow::saveReport(const QString& path, bool withPatient, bool withAppendix) {
    m_report->save(path, {.withPatient = withPatient, .withAppendix = withAppendix});
}
bool MainWindow::savePicture(const QString& path) { return m_files->savePicture(path); }

void MainWindow::restoreSettings() {
    m_pictureControls->restore();
    m_room->restore();
    m_presets->restore();
    Document document = m_document.document();
    document.motion = m_settings.motion();
    document.method = m_settings.method();
    document.panes.at(firstPane).curve = m_settings.activeCurve();
    m_document.begin(document);
    if (auto* logarithmic = m_widgets.editor->findChild<QAbstractButton*>("otfEditor.histogramLog"))
        logarithmic->setChecked(m_settings.histogramLogarithmic());
    m_widgets.editor->setShowsEarlyLight(m_settings.earlyLightShown());
    findChild<QAction*>("view.sides")->setChecked(m_settings.sidesShown());
    followStrip();
    if (const QByteArray geometry = m_settings.windowGeometry(); !geometry.isEmpty()) restoreGeometry(geometry);
    keepOnScreen(*this);
    const QByteArray state = m_settings.windowState();
    m_faces->restore(!state.isEmpty() && restoreState(state, layoutVersion));
}

void MainWindow::keepSettings() {
    m_pictureControls->keep();
    m_room->keep();
    m_presets->keep();
    m_settings.setMotion(m_document.document().motion);
    m_settings.setMethod(m_document.document().method);
    m_settings.setActiveCurve(m_document.document().panes.at(firstPane).curve);
    m_settings.setHistogramLogarithmic(m_widgets.editor->canvas().histogramScale() == HistogramScale::logarithmic);
    m_settings.setEarlyLightShown(m_widgets.editor->showsEarlyLight());
    m_compare->setShown(false);  // the next start begins without the comparison
    m_sideControls->remember();
    m_settings.setSidesShown(findChild<QAction*>("view.sides")->isChecked());
    m_settings.setWindowGeometry(saveGeometry());
    m_settings.setWindowState(saveState(layoutVersion));
    m_settings.save();
}

}  // namespace echolucent
