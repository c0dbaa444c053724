// The review room in the real main window: what the hand does in its panes.
#pragma once

#include <QMouseEvent>
#include <QWindow>
#include <vector>

#include "app/window/review_room.h"
#include "processing/picture/picture_place.h"
#include "tests/app/window_fixture.h"
#include "widgets/planes/plane_pane.h"

namespace echolucent {

class RoomFixture : public WindowFixture {
public:
    void key(Qt::Key key) { QTest::keyClick(&window(), key); }
    void raise(const char* dock) {
        child(dock)->show();
        child(dock)->raise();
        QTRY_VERIFY(child("room")->isVisible());
    }
    static void moveTo(PlanePane& pane, const QPoint& to) {
        QMouseEvent move(QEvent::MouseMove, to, pane.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&pane, &move);
    }
    /// The mouse moves in whole pixels, as mice do. Tests ask where it ends.
    static void drag(PlanePane& pane, const QPointF& from, const QPointF& to) {
        QMouseEvent press(QEvent::MouseButtonPress, from, pane.mapToGlobal(from), Qt::LeftButton, Qt::LeftButton,
                          Qt::NoModifier);
        QMouseEvent move(QEvent::MouseMove, to, pane.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
        QMouseEvent release(QEvent::MouseButtonRelease, to, pane.mapToGlobal(to), Qt::LeftButton, Qt::NoButton,
                            Qt::NoModifier);
        for (QMouseEvent* event : {&press, &move, &release}) QCoreApplication::sendEvent(&pane, event);
    }
    static void doubleClick(PlanePane& pane) {
        const QPoint at = pane.rect().center() + QPoint(40, 31);
        QTest::mouseClick(&pane, Qt::LeftButton, {}, at);
        QTest::mouseDClick(&pane, Qt::LeftButton, {}, at);
    }
    void moveIn3d(const QPoint& to) {
        QMouseEvent move(QEvent::MouseMove, to, pictureWindow()->mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                         Qt::NoModifier);
        QCoreApplication::sendEvent(pictureWindow(), &move);
    }
    void dragIn3d(const QPoint& from, const QPoint& to) {
        QTest::mousePress(pictureWindow(), Qt::LeftButton, {}, from);
        moveIn3d((from + to) / 2);
        moveIn3d(to);
        QTest::mouseRelease(pictureWindow(), Qt::LeftButton, {}, to);
    }
    QPoint seenIn3d(const Vec3& gridMm) {
        const PicturePlace place = *placeInPicture(window().volumeView().shownCamera(), gridMm);
        const QSize size = window().volumeView().size();
        return QPointF(size.width() / 2.0 + place[0] * size.height(), size.height() / 2.0 + place[1] * size.height())
            .toPoint();
    }
    [[nodiscard]] const Document& document() { return window().document().document(); }
    [[nodiscard]] const Box& box() { return document().scene.box; }
    [[nodiscard]] OrientedBox placed() { return orientedBoxOf(box(), document().beam.axis); }
    [[nodiscard]] const std::vector<ScalpelStroke>& strokes() { return document().scene.strokes; }
    [[nodiscard]] DataBox dataBox() { return window().openStudy().volume()->dataBox(); }
    PlanePane& pane(const char* name) { return *child<PlanePane>(name); }
    PlanePane& anyPane(std::uint32_t number) {
        static constexpr const char* names[] = {"planes.a", "planes.b", "planes.c"};
        return pane(names[number % 3]);
    }
};

}  // namespace echolucent
