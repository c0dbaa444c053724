#include "tests/benchmarks_window/open_window.h"

#include <QElapsedTimer>
#include <QEventLoop>
#include <QMouseEvent>
#include <QTest>
#include <QTimer>

namespace echolucent::bench {

namespace {
constexpr int patience = 300000;  // ms, a bound for broken programs
constexpr int askAgain = 5;       // ms
}  // namespace

void await(const char* what, const std::function<bool()>& done) {
    // A loop as the application's own: QTest's sleeps between its rounds.
    QElapsedTimer waited;
    waited.start();
    QEventLoop loop;
    QTimer ask;
    QObject::connect(&ask, &QTimer::timeout, &loop, [&] {
        if (waited.elapsed() > patience) qFatal("%s did not happen", what);
        if (done()) loop.quit();
    });
    ask.start(askAgain);
    loop.exec();
}

OpenWindow::OpenWindow() : m_window(std::make_unique<MainWindow>(m_folder.filePath("settings.ini"))) {}

QWindow* OpenWindow::pictureWindow() const { return m_window->windowHandle()->findChild<QWindow*>("view3d.surface"); }

void OpenWindow::show() {
    m_window->move(0, 0);
    m_window->show();
    if (!QTest::qWaitForWindowExposed(m_window.get())) qFatal("the window does not show");
    QApplication::setActiveWindow(m_window.get());  // a virtual display has nobody who would make it the active one
}

void OpenWindow::openVolume(const QString& path) {
    m_window->open(path);
    await("the volume", [&] { return m_window->otfs().adaptive() != nullptr; });
    waitUntilConverged();
}

void OpenWindow::waitUntilConverged() {
    await("the converged picture",
          [&] { return m_window->idle() && view().pictureIsFine() && view().pictureIsCurrent(); });
}

void OpenWindow::drawStroke() {
    trigger(QStringLiteral("room.scalpel"));
    QWindow* surface = pictureWindow();
    const auto at = [&](double right, double down) {
        return QPointF(right * surface->width(), down * surface->height());
    };
    const auto send = [&](QEvent::Type type, const QPointF& place, Qt::MouseButton button, Qt::MouseButtons held) {
        QMouseEvent event(type, place, surface->mapToGlobal(place), button, held, Qt::NoModifier);
        QCoreApplication::sendEvent(surface, &event);
        QCoreApplication::processEvents();
    };
    const QList<QPointF> corners{at(0.55, 0.35), at(0.7, 0.35), at(0.7, 0.5), at(0.55, 0.5)};
    constexpr int moves = 10;  // along each side
    send(QEvent::MouseButtonPress, corners.first(), Qt::LeftButton, Qt::LeftButton);
    for (qsizetype i = 0; i + 1 < corners.size(); ++i)
        for (int move = 1; move <= moves; ++move)
            send(QEvent::MouseMove, corners[i] + (corners[i + 1] - corners[i]) * (static_cast<double>(move) / moves),
                 Qt::NoButton, Qt::LeftButton);
    send(QEvent::MouseButtonRelease, corners.last(), Qt::LeftButton, Qt::NoButton);
    trigger(QStringLiteral("room.scalpel"));
}

}  // namespace echolucent::bench
