// echolucent-pictures FOLDER [FILE [--beam-axis AXIS] [--near MM] NAME]...: opens each volume (the word "simulated" for
// the built-in scan) in the real window and saves what is on the screen with the linear, the parabolic and the adaptive
// OTF; and what is on it with the adaptive one while a hand turns the volume.
// echolucent-pictures --untouched FOLDER FILE...: the 3D view of each volume as it opens, with nothing touched.
// echolucent-pictures --sheet FILE.png FOLDER...: one sheet with a column a folder of such pictures and a row a volume.
#include <QApplication>
#include <QCoreApplication>
#include <QEventLoop>
#include <QFileInfo>
#include <QScreen>
#include <QTemporaryDir>
#include <QTest>
#include <QWindow>
#include <cstdio>

#include "app/window/main_window.h"
#include "app/window/theme.h"
#include "tests/pictures/contact_sheet.h"
#include "widgets/otf_editor/otf_editor.h"
#include "widgets/panels/view_panel.h"
#include "widgets/volume_view/volume_view_widget.h"

using namespace echolucent;

namespace {

struct Wanted {
    QString file, name;
    QString beamAxis = "+z";
    double nearMm = 0;
};

QList<Wanted> parse(const QStringList& arguments) {
    QList<Wanted> wanted;
    Wanted next;
    for (int i = 2; i < arguments.size(); ++i) {
        const QString& argument = arguments[i];
        if (argument == "--beam-axis")
            next.beamAxis = arguments.value(++i);
        else if (argument == "--near")
            next.nearMm = arguments.value(++i).toDouble();
        else if (next.file.isEmpty())
            next.file = argument;
        else {
            next.name = argument;
            wanted << next;
            next = {};
        }
    }
    return wanted;
}

void waitUntilIdle(MainWindow& window) {
    while (!(window.idle() && window.volumeView().pictureIsFine()))
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents);
    QCoreApplication::processEvents();
}

void save(MainWindow& window, const QString& path) {
    QGuiApplication::primaryScreen()->grabWindow(0, window.x(), window.y(), window.width(), window.height()).save(path);
    std::printf("%s\n", qPrintable(path));
}

/// Twelve moves of the mouse, each when the picture of the one before is on the screen.
void takeInMotion(MainWindow& window, const QString& path) {
    auto* picture = window.windowHandle()->findChild<QWindow*>("view3d.surface");
    QPoint hand(picture->width() / 2, picture->height() / 2);
    QTest::mousePress(picture, Qt::LeftButton, {}, hand);
    for (int i = 0; i < 12; ++i) {
        bool drawn = false;
        QObject context;
        QObject::connect(&window.volumeView(), &VolumeViewWidget::pictureDrawn, &context, [&] { drawn = true; });
        hand += QPoint(4, 1);
        QTest::mouseMove(picture, hand);
        while (!drawn) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents);
    }
    save(window, path);
    QTest::mouseRelease(picture, Qt::LeftButton, {}, hand);
    waitUntilIdle(window);
}

void open(MainWindow& window, const QString& file) {
    bool opened = false;
    QObject::connect(
        &window.otfs(), &PaneOtfs::computed, &window, [&] { opened = true; }, Qt::SingleShotConnection);
    if (file == "simulated")
        window.openSimulatedScan();
    else
        window.open(file);
    while (!opened) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents);
    waitUntilIdle(window);
}

void take(MainWindow& window, const Wanted& wanted, const QString& folder) {
    open(window, wanted.file);
    auto* panel = window.findChild<ViewPanel*>();
    if (const auto axis = beamAxisFromName(wanted.beamAxis.toStdString()); axis && *axis != BeamAxis::plusZ) {
        panel->setBeamAxis(*axis);
        emit panel->beamAxisChanged(*axis);
    }
    if (wanted.nearMm > 0) {
        panel->setFrontMm(wanted.nearMm);
        emit panel->frontChanged(wanted.nearMm);
    }
    const std::pair<CurveKind, const char*> kinds[] = {
        {CurveKind::linear, "linear"}, {CurveKind::parabolic, "parabolic"}, {CurveKind::adaptive, "adaptive"}};
    for (const auto& [kind, name] : kinds) {
        window.otfEditor().setActive(kind);
        waitUntilIdle(window);
        save(window, QString("%1/%2-%3.png").arg(folder, wanted.name, name));
    }
    takeInMotion(window, QString("%1/%2-motion.png").arg(folder, wanted.name));
}

}  // namespace

int main(int count, char** arguments) {
    VolumeViewWidget::prepareApplication();
    QApplication application(count, arguments);
    wearTheme(Theme::dark);
    const QStringList words = QCoreApplication::arguments();
    if (words.value(1) == "--sheet") return writeContactSheet(words[2], words.mid(3)) ? 0 : 1;
    const QTemporaryDir settings;
    MainWindow window(settings.filePath("settings.ini"));
    window.show();
    if (words.value(1) == "--untouched") {
        for (const QString& file : words.mid(3)) {
            open(window, file);
            const QString path = QString("%1/%2.png").arg(words[2], QFileInfo(file).completeBaseName());
            window.volumeView().screenImage().save(path);
            std::printf("%s\n", qPrintable(path));
        }
        return 0;
    }
    for (const Wanted& wanted : parse(words)) take(window, wanted, words[1]);
    return 0;
}
