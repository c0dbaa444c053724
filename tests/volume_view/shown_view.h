// A 3D view on the display with the corner ball in it, and how its picture is measured.
#pragma once

#include <QImage>
#include <QMouseEvent>
#include <QTest>
#include <QWindow>
#include <algorithm>
#include <cmath>
#include <memory>

#include "tests/qt_program/test_classes.h"
#include "tests/volume_view/test_volumes.h"
#include "widgets/threads/works.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent::testing {

inline const OpacityCurve wall = ManualCurve{{{0.4, 0.0}, {0.6, 1.0}}};

/// A view on the display with the corner ball. Its converged picture is there.
struct ShownView {
    explicit ShownView(std::shared_ptr<const Volume> shown = ballInTheCorner(), const Viewpoint& from = {})
        : volume(std::move(shown)) {
        view.resize(330, 250);
        view.setVolume(volume);
        view.setClassification(wall);
        view.resetView(from);
        view.show();
        ready = QTest::qWaitForWindowExposed(&view) && awaitIdle();
    }
    ~ShownView() { keepPictureOfFailure(); }
    ShownView(const ShownView&) = delete;
    ShownView& operator=(const ShownView&) = delete;
    bool awaitIdle() {
        return QTest::qWaitFor([this] { return works.idle() && view.pictureIsFine(); }, patience);
    }
    QWindow* window() {
        // The only native child window of the view's top level.
        return view.windowHandle()->findChild<QWindow*>();
    }
    void drag(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, const QPoint& from, const QPoint& to) {
        QTest::mousePress(window(), button, modifiers, from);
        for (int step = 1; step <= 10; ++step) moveTo(from + (to - from) * step / 10, button, modifiers);
        QTest::mouseRelease(window(), button, modifiers, to);
    }
    void moveTo(const QPoint& to, Qt::MouseButtons buttons = Qt::NoButton, Qt::KeyboardModifiers modifiers = {}) {
        QMouseEvent move(QEvent::MouseMove, QPointF(to), QPointF(window()->mapToGlobal(to)), Qt::NoButton, buttons,
                         modifiers);
        QCoreApplication::sendEvent(window(), &move);
    }
    std::shared_ptr<const Volume> volume;
    Works works;
    VolumeViewWidget view{works};
    bool ready = false;
};

/// The largest difference in levels between the screen and a picture over black, without the corners with marker and
/// bar.
inline int largestDifference(const QImage& screen, const Picture& picture) {
    const std::vector<std::uint8_t> rgb = overBackground(picture, {0, 0, 0});
    int largest = 0;
    for (int y = 0; y < picture.height - 110; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const QRgb seen = screen.pixel(x, y);
            const std::uint8_t* expected =
                &rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                          static_cast<std::size_t>(x))];
            largest = std::max({largest, std::abs(qRed(seen) - expected[0]), std::abs(qGreen(seen) - expected[1]),
                                std::abs(qBlue(seen) - expected[2])});
        }
    }
    return largest;
}

/// The centre of what is brighter than a level, from the picture's centre, in shares of the picture's height.
inline QPointF brightCentre(const Picture& picture) {
    double x = 0, y = 0, weight = 0;
    for (int row = 0; row < picture.height; ++row) {
        for (int column = 0; column < picture.width; ++column) {
            const float value =
                picture.rgba[4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                                  static_cast<std::size_t>(column))];
            x += value * (column + 0.5 - picture.width / 2.0);
            y += value * (row + 0.5 - picture.height / 2.0);
            weight += value;
        }
    }
    return QPointF(x, y) / weight / picture.height;
}

}  // namespace echolucent::testing
