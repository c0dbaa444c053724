#include "app/main_window.h"

#include <QAbstractButton>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QMimeData>
#include <QScrollArea>
#include <QScrollBar>
#include <QStatusBar>
#include <QVBoxLayout>

#include "widgets/motion/otf_course_panel.h"
#include "widgets/otf_editor/canvas/curve_canvas.h"
#include "widgets/otf_editor/otf_editor.h"
#include "widgets/panels/method_panel.h"
#include "widgets/panels/motion_panel.h"
#include "widgets/panels/run_status.h"
#include "widgets/panels/study_panel.h"
#include "widgets/panels/view_panel.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

MainWindow::MainWindow(const QString& settingsFile, QWidget* parent) : QMainWindow(parent), m_settings(settingsFile) {
    setObjectName("mainWindow");
    setWindowTitle(tr("Echolucent"));
    setAcceptDrops(true);
    resize(1440, 920);
    createParts();
    createActions();
    connectSession();
    connectPicture();
    connectMethod();
    connectMotion();
    restoreSettings();
}

MainWindow::~MainWindow() = default;

void MainWindow::createParts() {
    auto* centre = new QWidget(this);
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    // The bar stands above the picture, not on it: a native OpenGL window covers its sibling widgets.
    m_messageBar = new MessageBar(centre);
    m_volumeView = new VolumeViewWidget(centre);
    m_motionPanel = new MotionPanel(centre);
    column->addWidget(m_messageBar);
    column->addWidget(m_volumeView, 1);
    column->addWidget(m_motionPanel);
    setCentralWidget(centre);

    m_otfEditor = new OtfEditor(this);
    m_methodPanel = new MethodPanel(this);
    m_viewPanel = new ViewPanel(this);
    m_studyPanel = new StudyPanel(this);
    m_coursePanel = new OtfCoursePanel(m_course, this);
    QDockWidget* otf = addDock(tr("Opacity transfer function"), "dock.otfEditor", m_otfEditor);
    QDockWidget* picture = addDock(tr("Picture"), "dock.view", m_viewPanel);
    QDockWidget* method = addDock(tr("Adaptive"), "dock.method", m_methodPanel);
    QDockWidget* study = addDock(tr("Study"), "dock.study", m_studyPanel);
    m_courseDock = addDock(tr("OTF over angle"), "dock.motionMap", m_coursePanel);
    splitDockWidget(otf, picture, Qt::Vertical);
    // Behind the editor, so that nothing beside the 3D view grows when it opens.
    tabifyDockWidget(otf, m_courseDock);
    m_courseDock->hide();
    tabifyDockWidget(picture, method);
    tabifyDockWidget(method, study);
    picture->raise();
    resizeDocks({otf, picture}, {560, 300}, Qt::Vertical);
    resizeDocks({otf, picture}, {430, 430}, Qt::Horizontal);

    m_runStatus = new RunStatus(this);
    statusBar()->addWidget(m_runStatus, 1);
    statusBar()->setSizeGripEnabled(false);
}

QDockWidget* MainWindow::addDock(const QString& title, const QString& name, QWidget* content) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    auto* scroll = new QScrollArea(dock);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(content);
    // Panels scroll up and down only, so that nothing at their right edge is ever out of sight.
    scroll->setMinimumWidth(content->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width());
    dock->setWidget(scroll);
    addDockWidget(Qt::RightDockWidgetArea, dock);
    return dock;
}

void MainWindow::connectSession() {
    connect(&m_session, &Session::loadingChanged, this, [this](bool loading) {
        if (loading)
            m_runStatus->beginProgress(tr("loading"));
        else
            m_runStatus->endProgress();
        updateIdle();
    });
    connect(&m_session, &Session::loadingProgressed, m_runStatus, &RunStatus::setProgress);
    connect(m_runStatus, &RunStatus::cancelRequested, this, [this] {
        if (m_session.loading()) return m_session.cancelLoading();
        m_session.cancelComputing();
        computeFor(m_otfView);  // what was being computed for the picture is still wanted
    });
    connect(&m_session, &Session::studyOpened, this, &MainWindow::studyOpened);
    connect(&m_session, &Session::openFailed, this, &MainWindow::openFailed);
    connect(&m_session, &Session::volumeChanged, this, &MainWindow::volumeChanged);
    connect(&m_session, &Session::computingOtfChanged, this, [this](bool computing) {
        if (!computing && std::exchange(m_lookingForNearCut, false) && !m_session.loading()) m_runStatus->endProgress();
        announceShownFrame();
        updateIdle();
    });
    connect(&m_session, &Session::otfComputed, this, &MainWindow::otfComputed);
    connect(&m_session, &Session::nearCutSuggested, this, &MainWindow::takeNearCut);
    connect(&m_session, &Session::otfFailed, this, [this](const QString& sentence) {
        m_motionPlayer.pause();
        m_messageBar->showMessage(MessageKind::error, sentence);
    });
}

void MainWindow::connectMethod() {
    connect(m_otfEditor, &OtfEditor::activeCurveChanged, m_volumeView, &VolumeViewWidget::setCurve);
    connect(m_otfEditor, &OtfEditor::openCurveRequested, this, &MainWindow::chooseAndOpenCurve);
    connect(m_otfEditor, &OtfEditor::saveCurveRequested, this, [this] { chooseAndSaveCurve(); });
    connect(m_methodPanel, &MethodPanel::computeRequested, this, &MainWindow::computeForThisView);
    connect(m_methodPanel, &MethodPanel::configChanged, this, [this] { computeFor(m_otfView); });
    connect(&m_otfEditor->model(), &OtfEditorModel::changed, this, [this] {
        // The tubes multiply the editor's own curve where it was chosen as the initial function.
        const InitialKind kind = m_methodPanel->initialKind();
        if (kind != InitialKind::manual && kind != InitialKind::linear) return;
        if (m_session.otf() && m_session.otf()->config.initial != methodConfig().initial) computeFor(m_otfView);
    });
}

void MainWindow::restoreSettings() {
    restoreLook();
    m_motionPanel->setPingPong(m_settings.motionPingPong());
    m_motionPlayer.setPingPong(m_settings.motionPingPong());
    if (auto* logarithmic = m_otfEditor->findChild<QAbstractButton*>("otfEditor.histogramLog"))
        logarithmic->setChecked(m_settings.histogramLogarithmic());
    if (const QByteArray geometry = m_settings.windowGeometry(); !geometry.isEmpty()) restoreGeometry(geometry);
    if (const QByteArray state = m_settings.windowState(); !state.isEmpty()) restoreState(state);
}

void MainWindow::keepSettings() {
    keepLook();
    m_settings.setMotionPingPong(m_motionPanel->pingPong());
    m_settings.setHistogramLogarithmic(m_otfEditor->canvas().histogramScale() == HistogramScale::logarithmic);
}

bool MainWindow::idle() const {
    return !m_session.loading() && !m_session.computingOtf() && !m_volumeView->busy() && !m_motionPlayer.isPlaying();
}

void MainWindow::updateIdle() {
    if (idle() == m_idle) return;
    m_idle = !m_idle;
    emit idleChanged(m_idle);
}

void MainWindow::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    if (std::exchange(m_shown, true)) return;
    QTimer::singleShot(0, this, &MainWindow::shown);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!mayLoseManualCurve()) {
        event->ignore();
        return;
    }
    m_motionPlayer.pause();
    keepSettings();
    m_settings.setWindowGeometry(saveGeometry());
    m_settings.setWindowState(saveState());
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const auto urls = event->mimeData()->urls();
    if (!urls.isEmpty() && urls.first().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) { open(event->mimeData()->urls().first().toLocalFile()); }

}  // namespace echolucent
