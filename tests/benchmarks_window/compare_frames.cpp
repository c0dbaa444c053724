// echolucent-bench-compare measures the comparison in the workstation's real window: frames a second of four panes of
// 400 x 400 while the hand orbits, with light and without. A frame is the pictures of all panes together.
#include <QApplication>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QTemporaryDir>
#include <QTest>
#include <QTextStream>
#include <cmath>

#include "app/compare/compare_room.h"
#include "app/window/main_window.h"
#include "app/window/theme.h"
#include "widgets/compare/compare_grid.h"

using namespace echolucent;

namespace {

constexpr int edge = 400;  // of a pane's picture

void move(QWidget& pane, const QPointF& place) {
    QMouseEvent event(QEvent::MouseMove, place, pane.mapToGlobal(place), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&pane, &event);
}

/// Orbits for so many seconds and says what came.
void orbit(MainWindow& window, CompareGrid& grid, const QString& words, double seconds) {
    int frames = 0, rows = 0;
    QSize rays;
    const auto counting = QObject::connect(&window.compareRoom().views(), &ComparedViews::frameShown, &grid, [&] {
        const auto frame = window.compareRoom().views().frame();
        rays = QSize(frame->settings.width, frame->settings.height);
        ++frames;
    });
    const auto painting = QObject::connect(&grid, &CompareGrid::painted, &grid, [&] { ++rows; });
    ComparePane& pane = grid.pane(0);
    const QPoint middle = pane.pictureRect().center();
    QTest::mousePress(&pane, Qt::LeftButton, {}, middle);
    QElapsedTimer clock;
    clock.start();
    for (int step = 1; clock.elapsed() < seconds * 1000; ++step) {
        move(pane, middle + QPointF(80 * std::sin(0.03 * step), 30 * std::sin(0.017 * step)));
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 8);
        QTest::qWait(4);  // as often as a mouse tells that it was moved
    }
    const double taken = static_cast<double>(clock.elapsed()) * 1e-3;
    QTest::mouseRelease(&pane, Qt::LeftButton, {}, middle);
    QObject::disconnect(counting);
    QObject::disconnect(painting);
    QTextStream(stdout) << words << ": " << QString::number(frames / taken, 'f', 1) << " frames a second cast, "
                        << QString::number(rows / 4.0 / taken, 'f', 1) << " painted, last of " << rays.width() << " x "
                        << rays.height() << " rays a pane\n";
}

}  // namespace

int main(int count, char** arguments) {
    VolumeViewWidget::prepareApplication();
    QApplication application(count, arguments);
    wearTheme(Theme::dark);
    const double seconds = count > 1 ? QString(arguments[1]).toDouble() : 5.0;
    const QTemporaryDir folder;
    MainWindow window(folder.filePath("settings.ini"));
    window.show();
    window.openSimulatedScan();
    const auto rest = [&] { return QTest::qWaitFor([&] { return window.idle(); }, 120000); };
    if (!rest()) return 1;
    window.compareRoom().setShown(true);
    auto& grid = *window.findChild<CompareGrid*>("compare.panes");
    for (int turn = 0; turn < 3; ++turn) {
        const QSize missing = QSize(edge, edge) - grid.pane(0).pictureRect().size();
        window.resize(window.size() + 2 * missing);
        if (!rest()) return 1;  // it is laid out anew
    }
    if (!rest()) return 1;
    QTextStream(stdout) << "panes of " << grid.pictureSize().width() << " x " << grid.pictureSize().height() << "\n";
    for (const Lighting lighting : {Lighting::flat, Lighting::surface, Lighting::depth}) {
        Document next = window.document().document();
        next.scene.look.lighting = lighting;
        window.document().edit(next, "light");
        if (!rest()) return 1;
        const auto name = nameOf(lighting);
        const QString words = QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
        orbit(window, grid, "light " + words + ", first turn", seconds);  // costs are learnt
        orbit(window, grid, "light " + words, seconds);
        if (!rest()) return 1;
    }
    return 0;
}
