#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QMenuBar>
#include <QMessageBox>

#include "app/main_window.h"
#include "widgets/otf_editor/otf_editor.h"
#include "widgets/panels/motion_panel.h"

namespace echolucent {

QAction* MainWindow::addAction(QMenu* menu, const QString& text, const QString& name, const QKeySequence& shortcut,
                               std::function<void()> run) {
    QAction* action = menu->addAction(text);
    action->setObjectName(name);
    action->setShortcut(shortcut);
    connect(action, &QAction::triggered, this, std::move(run));
    return action;
}

void MainWindow::createActions() {
    QMenu* file = menuBar()->addMenu(tr("&File"));
    addAction(file, tr("&Open volume…"), "file.open", QKeySequence::Open, [this] { chooseAndOpen(); });
    addAction(file, tr("Open &folder of DICOM slices…"), "file.openFolder", {}, [this] { chooseAndOpenFolder(); });
    addAction(file, tr("Open &raw volume…"), "file.openRaw", {}, [this] { chooseAndOpenRaw(); });
    m_recentMenu = file->addMenu(tr("Recent files"));
    m_recentMenu->setObjectName("file.recent");
    connect(m_recentMenu, &QMenu::aboutToShow, this, &MainWindow::showRecentFiles);
    addAction(file, tr("Open the simulated scan"), "file.openSimulatedScan", {}, [this] { openSimulatedScan(); });
    file->addSeparator();
    file->addActions({m_otfEditor->openCurveAction(), m_otfEditor->saveCurveAction()});
    addAction(file, tr("Save &picture…"), "file.savePicture", Qt::Key_P, [this] { chooseAndSavePicture(); });
    file->addSeparator();
    addAction(file, tr("&Quit"), "file.quit", QKeySequence::Quit, [this] { close(); });

    // The editor's actions carry their own shortcuts, so they stand here as they are.
    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    edit->addActions({m_otfEditor->undoAction(), m_otfEditor->redoAction()});

    QMenu* view = menuBar()->addMenu(tr("&View"));
    addAction(view, tr("&Reset view"), "view.resetView", Qt::Key_R, [this] { resetView(); });
    addAction(view, tr("&Full screen"), "view.fullScreen", Qt::Key_F,
              [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
    m_docksMenu = view->addMenu(tr("Panels"));
    for (QDockWidget* dock : findChildren<QDockWidget*>()) m_docksMenu->addAction(dock->toggleViewAction());

    QMenu* otf = menuBar()->addMenu(tr("&OTF"));
    addAction(otf, tr("C&ompute for this view"), "otf.computeForThisView", Qt::Key_A, [this] { computeForThisView(); });
    otf->addSeparator();
    for (const CurveKind kind : allCurveKinds) otf->addAction(m_otfEditor->activateAction(kind));
    otf->addSeparator();
    otf->addActions({m_otfEditor->copyAdaptiveAction(), m_otfEditor->resetAction()});
    otf->addMenu(m_otfEditor->presetsMenu());

    QMenu* motion = menuBar()->addMenu(tr("&Motion"));
    addAction(motion, tr("&Play or pause"), "motion.playOrPause", Qt::Key_Space,
              [this] { m_motionPlayer.togglePlaying(); });
    addAction(motion, tr("One degree back"), "motion.back", Qt::Key_Left, [this] { m_motionPlayer.stepBy(-1); });
    addAction(motion, tr("One degree on"), "motion.on", Qt::Key_Right, [this] { m_motionPlayer.stepBy(1); });
    motion->addSeparator();
    QAction* map = m_courseDock->toggleViewAction();
    map->setObjectName("motion.showMap");
    connect(map, &QAction::triggered, m_courseDock, [dock = m_courseDock](bool open) {
        if (open) dock->raise();
    });
    motion->addAction(map);

    QMenu* help = menuBar()->addMenu(tr("&Help"));
    addAction(help, tr("&What does the picture show?"), "help.explain", QKeySequence::HelpContents,
              [this] { showExplanation(); });
    addAction(help, tr("&About Echolucent"), "help.about", {}, [this] { showAbout(); });
}

void MainWindow::showExplanation() {
    auto* box = new QMessageBox(QMessageBox::NoIcon, tr("What does the picture show?"), explanation(),
                                QMessageBox::Close, this);
    box->setObjectName("explanation");
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setModal(false);
    box->show();
}

void MainWindow::showAbout() {
    auto* box = new QMessageBox(
        QMessageBox::NoIcon, tr("About Echolucent"),
        tr("Echolucent %1\n\nA workstation for 3D ultrasound that computes the opacity transfer function from the "
           "volume, "
           "after Petersch, Hadwiger, Hauser and Hönigmann (2005).\n\nNot a medical device: not for diagnosis or "
           "treatment.")
            .arg(QApplication::applicationVersion()),
        QMessageBox::Close, this);
    box->setObjectName("about");
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setModal(false);
    box->show();
}

}  // namespace echolucent
