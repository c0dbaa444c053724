#include "app/window/window_menus.h"

#include <QAction>
#include <QApplication>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenuBar>
#include <QMessageBox>
#include <QProxyStyle>

#include "widgets/key_table.h"
#include "widgets/otf_editor/otf_editor.h"

namespace echolucent {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("menus", text); }

/// Makes the icons of a menu large enough to recognise a picture.
class PictureMenuStyle : public QProxyStyle {
public:
    int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
        constexpr int pictureEdge = 48;
        return metric == PM_SmallIconSize ? pictureEdge : QProxyStyle::pixelMetric(metric, option, widget);
    }
};

QAction* addAction(QMenu* menu, const QString& text, const QString& name, const std::function<void()>& run) {
    QAction* action = menu->addAction(text);
    action->setObjectName(name);
    action->setShortcut(keyOf(name));
    QObject::connect(action, &QAction::triggered, menu, run);
    return action;
}

QAction* addSwitch(QMenu* menu, const QString& text, const QString& name, const std::function<void(bool on)>& run) {
    QAction* action = menu->addAction(text);
    action->setObjectName(name);
    action->setShortcut(keyOf(name));
    action->setCheckable(true);
    QObject::connect(action, &QAction::triggered, menu, run);
    return action;
}

void createFileMenu(QMainWindow& window, OtfEditor& editor, const WindowCommands& commands) {
    QMenu* file = window.menuBar()->addMenu(tr("&File"));
    file->setObjectName("menu.file");
    addAction(file, tr("&Open volume…"), "file.open", commands.openFile);
    addAction(file, tr("Open &folder of DICOM slices…"), "file.openFolder", commands.openFolder);
    addAction(file, tr("Open &raw volume…"), "file.openRaw", commands.openRawFile);
    addAction(file, tr("Other series of t&his folder…"), "file.chooseSeries", commands.chooseSeries);
    QMenu* recent = file->addMenu(tr("Recen&t files"));
    recent->setObjectName("file.recent");
    auto* style = new PictureMenuStyle;
    style->setParent(recent);
    recent->setStyle(style);
    QObject::connect(recent, &QMenu::aboutToShow, recent, [recent, fill = commands.fillRecentFiles] { fill(*recent); });
    addAction(file, tr("Open the simulated scan"), "file.openSimulatedScan", commands.openSimulatedScan);
    QMenu* left = file->addMenu(tr("Left &unsaved"));
    left->setObjectName("file.leftUnsaved");
    QObject::connect(left, &QMenu::aboutToShow, left, [left, fill = commands.fillLeftUnsaved] { fill(*left); });
    file->addSeparator();
    addAction(file, tr("&Save session"), "file.saveSession", commands.saveSession);
    addAction(file, tr("Save session &as…"), "file.saveSessionAs", commands.saveSessionAs);
    file->addSeparator();
    file->addActions({editor.openCurveAction(), editor.saveCurveAction()});
    addAction(file, tr("Save &picture…"), "file.savePicture", commands.savePicture);
    addAction(file, tr("Save &large picture or all panes…"), "file.savePanes", commands.savePanes);
    addAction(file, tr("Save &movie…"), "file.saveMovie", commands.saveMovie);
    addAction(file, tr("Save picture ser&ies…"), "file.savePictureSeries", commands.savePictureSeries);
    addAction(file, tr("Save case r&eport…"), "file.saveReport", commands.saveReport);
    file->addSeparator();
    addAction(file, tr("&Quit"), "file.quit", [&window] { window.close(); });
}

void createViewMenu(QMainWindow& window, const QList<QDockWidget*>& panels, const WindowCommands& commands) {
    QMenu* view = window.menuBar()->addMenu(tr("&View"));
    view->setObjectName("menu.view");
    addAction(view, tr("&Reset view"), "view.resetView", commands.resetView);
    addAction(view, tr("Reset &all"), "view.resetAll", commands.resetAll);
    addAction(view, tr("Smooth &more"), "view.moreReduction", [reduce = commands.reduceSpeckle] { reduce(1); });
    addAction(view, tr("Smooth &less"), "view.lessReduction", [reduce = commands.reduceSpeckle] { reduce(-1); });
    QMenu* sides = view->addMenu(tr("&Sides of the scan"));
    sides->setObjectName("view.menuOfSides");
    sides->addActions(commands.sides);
    addSwitch(view, tr("Strip of si&des"), "view.sides", commands.showSides);
    addAction(view, tr("Fi&nd the front"), "view.findFront", commands.findFront);
    addAction(view, tr("Front from &here"), "view.frontFromHere", commands.frontFromHere);
    addAction(view, tr("N&o front"), "view.noFront", commands.noFront);
    addAction(view, tr("Next l&ight"), "view.nextLighting", commands.nextLighting)
        ->setToolTip(
            tr("Changes the light of the picture: none, on surfaces, or with shadows that tell depth. Each time "
               "the next of the three"));
    addAction(view, tr("&Full screen"), "view.fullScreen", commands.toggleFullScreen);
    addSwitch(view, tr("Large &pointer"), "view.largePointer", commands.largePointer)
        ->setToolTip(tr("A ring around the pointer, which the last row of a class sees"));
    addSwitch(view, tr("Show n&umbers instead of names"), "view.numbersForNames", commands.numbersForNames);
    addSwitch(view, tr("Light &theme"), "view.lightTheme", commands.lightTheme);
    QMenu* docks = view->addMenu(tr("Panels"));
    docks->setObjectName("menu.panels");
    docks->setToolTipsVisible(true);
    for (const QDockWidget* panel : panels) docks->addAction(panel->toggleViewAction());
}

void createOtfMenu(QMainWindow& window, OtfEditor& editor, const WindowCommands& commands) {
    QMenu* otf = window.menuBar()->addMenu(tr("&OTF"));
    otf->setObjectName("menu.otf");
    addAction(otf, tr("C&ompute for this view"), "otf.computeForThisView", commands.computeForThisView);
    otf->addSeparator();
    for (const CurveKind kind : allCurveKinds) otf->addAction(editor.activateAction(kind));
    otf->addSeparator();
    otf->addActions({editor.copyAdaptiveAction(), editor.resetAction()});
    otf->addMenu(editor.presetsMenu());
}

void createMotionMenu(QMainWindow& window, QDockWidget& course, const WindowCommands& commands) {
    QMenu* motion = window.menuBar()->addMenu(tr("&Motion"));
    motion->setObjectName("menu.motion");
    addAction(motion, tr("&Play or pause"), "motion.playOrPause", commands.playOrPause);
    addAction(motion, tr("One degree back"), "motion.back", [turn = commands.turnMotion] { turn(-1); });
    addAction(motion, tr("One degree on"), "motion.on", [turn = commands.turnMotion] { turn(1); });
    addAction(motion, tr("One volume back"), "motion.phaseBack", [step = commands.stepPhase] { step(-1); });
    addAction(motion, tr("One volume on"), "motion.phaseOn", [step = commands.stepPhase] { step(1); });
    motion->addSeparator();
    QAction* map = course.toggleViewAction();
    map->setObjectName("motion.showMap");
    QObject::connect(map, &QAction::triggered, &course, [&course](bool open) {
        if (open) course.raise();
    });
    motion->addAction(map);
}

void showAbout(QMainWindow& window) {
    if (auto* shown = window.findChild<QMessageBox*>("about")) return shown->raise();
    const QString text =
        tr("Echolucent %1\n\nA workstation for 3D ultrasound that computes the opacity transfer function from the "
           "volume, after Petersch, Hadwiger, Hauser and Hönigmann (2005).\n\nNot a medical device: not for "
           "diagnosis or treatment.")
            .arg(QApplication::applicationVersion());
    auto* box = new QMessageBox(QMessageBox::NoIcon, tr("About Echolucent"), text, QMessageBox::Close, &window);
    box->setObjectName("about");
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setModal(false);
    box->show();
}

/// The keys work also while the menu bar is hidden.
void keepKeys(QMainWindow& window) {
    for (const QMenu* menu : window.menuBar()->findChildren<QMenu*>())
        for (QAction* action : menu->actions())
            if (!action->shortcut().isEmpty()) window.addAction(action);
}

}  // namespace

void createMenus(QMainWindow& window, OtfEditor& editor, const QList<QDockWidget*>& panels, QDockWidget& course,
                 const WindowCommands& commands) {
    createFileMenu(window, editor, commands);
    // The editor's actions have their own shortcuts.
    QMenu* edit = window.menuBar()->addMenu(tr("&Edit"));
    edit->setObjectName("menu.edit");
    edit->addActions({editor.undoAction(), editor.redoAction()});
    addAction(edit, tr("&History"), "edit.history", commands.showHistory);
    edit->addSeparator();
    addAction(edit, tr("&Copy picture"), "edit.copyPicture", commands.copyPicture);
    createViewMenu(window, panels, commands);
    createOtfMenu(window, editor, commands);
    createMotionMenu(window, course, commands);
    QMenu* help = window.menuBar()->addMenu(tr("&Help"));
    help->setObjectName("menu.help");
    addAction(help, tr("&What does the picture show?"), "help.explain", commands.explain);
    addAction(help, tr("&About Echolucent"), "help.about", [&window] { showAbout(window); });
    for (QMenu* menu : window.menuBar()->findChildren<QMenu*>()) menu->setToolTipsVisible(true);
    keepKeys(window);
}

}  // namespace echolucent
