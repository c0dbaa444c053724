#include "app/window/window_menus.h"

#include <QAction>
#include <QApplication>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenuBar>
#include <QMessageBox>

#include "widgets/otf_editor/otf_editor.h"

namespace echolucent {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("menus", text); }

QAction* addAction(QMenu* menu, const QString& text, const QString& name, const QKeySequence& shortcut,
                   const std::function<void()>& run) {
    QAction* action = menu->addAction(text);
    action->setObjectName(name);
    action->setShortcut(shortcut);
    QObject::connect(action, &QAction::triggered, menu, run);
    return action;
}

void createFileMenu(QMainWindow& window, OtfEditor& editor, const WindowCommands& commands) {
    QMenu* file = window.menuBar()->addMenu(tr("&File"));
    addAction(file, tr("&Open volume…"), "file.open", QKeySequence::Open, commands.openFile);
    addAction(file, tr("Open &folder of DICOM slices…"), "file.openFolder", {}, commands.openFolder);
    addAction(file, tr("Open &raw volume…"), "file.openRaw", {}, commands.openRawFile);
    QMenu* recent = file->addMenu(tr("Recent files"));
    recent->setObjectName("file.recent");
    QObject::connect(recent, &QMenu::aboutToShow, recent, [recent, fill = commands.fillRecentFiles] { fill(*recent); });
    addAction(file, tr("Open the simulated scan"), "file.openSimulatedScan", {}, commands.openSimulatedScan);
    file->addSeparator();
    file->addActions({editor.openCurveAction(), editor.saveCurveAction()});
    addAction(file, tr("Save &picture…"), "file.savePicture", Qt::Key_P, commands.savePicture);
    file->addSeparator();
    addAction(file, tr("&Quit"), "file.quit", QKeySequence::Quit, [&window] { window.close(); });
}

void createViewMenu(QMainWindow& window, const WindowCommands& commands) {
    QMenu* view = window.menuBar()->addMenu(tr("&View"));
    addAction(view, tr("&Reset view"), "view.resetView", Qt::Key_R, commands.resetView);
    addAction(view, tr("Reduce speckle &more"), "view.moreReduction", Qt::Key_Q,
              [reduce = commands.reduceSpeckle] { reduce(1); });
    addAction(view, tr("Reduce speckle &less"), "view.lessReduction", Qt::SHIFT | Qt::Key_Q,
              [reduce = commands.reduceSpeckle] { reduce(-1); });
    addAction(view, tr("&Near cut: find, or take back"), "view.toggleNearCut", Qt::Key_N, commands.toggleNearCut);
    addAction(view, tr("Next &light"), "view.nextLighting", Qt::Key_L, commands.nextLighting);
    addAction(view, tr("&Full screen"), "view.fullScreen", Qt::Key_F,
              [&window] { window.setWindowState(window.windowState() ^ Qt::WindowFullScreen); });
    QMenu* docks = view->addMenu(tr("Panels"));
    for (QDockWidget* dock : window.findChildren<QDockWidget*>()) docks->addAction(dock->toggleViewAction());
}

void createOtfMenu(QMainWindow& window, OtfEditor& editor, const WindowCommands& commands) {
    QMenu* otf = window.menuBar()->addMenu(tr("&OTF"));
    otf->setObjectName("menu.otf");
    addAction(otf, tr("C&ompute for this view"), "otf.computeForThisView", Qt::Key_A, commands.computeForThisView);
    otf->addSeparator();
    for (const CurveKind kind : allCurveKinds) otf->addAction(editor.activateAction(kind));
    otf->addSeparator();
    otf->addActions({editor.copyAdaptiveAction(), editor.resetAction()});
    otf->addMenu(editor.presetsMenu());
}

void createMotionMenu(QMainWindow& window, QDockWidget& course, const WindowCommands& commands) {
    QMenu* motion = window.menuBar()->addMenu(tr("&Motion"));
    addAction(motion, tr("&Play or pause"), "motion.playOrPause", Qt::Key_Space, commands.playOrPause);
    addAction(motion, tr("One degree back"), "motion.back", Qt::Key_Left, [turn = commands.turnMotion] { turn(-1); });
    addAction(motion, tr("One degree on"), "motion.on", Qt::Key_Right, [turn = commands.turnMotion] { turn(1); });
    motion->addSeparator();
    QAction* map = course.toggleViewAction();
    map->setObjectName("motion.showMap");
    QObject::connect(map, &QAction::triggered, &course, [&course](bool open) {
        if (open) course.raise();
    });
    motion->addAction(map);
}

void showAbout(QMainWindow& window) {
    showText(window, "about", tr("About Echolucent"),
             tr("Echolucent %1\n\nA workstation for 3D ultrasound that computes the opacity transfer function from the "
                "volume, after Petersch, Hadwiger, Hauser and Hönigmann (2005).\n\nNot a medical device: not for "
                "diagnosis or treatment.")
                 .arg(QApplication::applicationVersion()));
}

}  // namespace

void showText(QMainWindow& window, const QString& name, const QString& title, const QString& text) {
    auto* box = new QMessageBox(QMessageBox::NoIcon, title, text, QMessageBox::Close, &window);
    box->setObjectName(name);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setModal(false);
    box->show();
}

void createMenus(QMainWindow& window, OtfEditor& editor, QDockWidget& course, const WindowCommands& commands) {
    createFileMenu(window, editor, commands);
    // The editor's actions carry their own shortcuts, so they stand here as they are.
    QMenu* edit = window.menuBar()->addMenu(tr("&Edit"));
    edit->addActions({editor.undoAction(), editor.redoAction()});
    createViewMenu(window, commands);
    createOtfMenu(window, editor, commands);
    createMotionMenu(window, course, commands);
    QMenu* help = window.menuBar()->addMenu(tr("&Help"));
    addAction(help, tr("&What does the picture show?"), "help.explain", QKeySequence::HelpContents, commands.explain);
    addAction(help, tr("&About Echolucent"), "help.about", {}, [&window] { showAbout(window); });
}

}  // namespace echolucent
