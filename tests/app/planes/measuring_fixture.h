// Measuring in the real main window: planes turned to marked points, and what the hand does there.
#pragma once

#include <QListWidget>
#include <vector>

#include "processing/scene/planes_holding.h"
#include "processing/scene/shown_measurement.h"
#include "tests/app/planes/marked_points.h"
#include "tests/app/planes/room_fixture.h"
#include "widgets/controls/message_bar.h"

namespace echolucent {

class MeasuringFixture : public RoomFixture {
public:
    void showWindow() {
        show();
        window().resize(1280, 720);
        useLook(Look{});  // light plays no part here, but takes time
    }
    void openPoints() {
        open(file("points.mha", {markedPoints(obliqueGrid())}));
        key(Qt::Key_F3);
        QTRY_VERIFY(window().idle());
    }
    /// Turns the planes by odd angles until one of them holds the places. Returns its pane.
    PlanePane& turnedToHold(const std::vector<Vec3>& places) {
        Document next = document();
        Planes& planes = next.scene.planes;
        planes.direction = {33.3, -21.7, 71.1};
        planes = planesHolding(planes, places, next.beam.axis, dataBox());
        window().document().edit(next, "turn planes");
        [&] { QTRY_VERIFY(window().idle()); }();
        for (const char* name : {"planes.a", "planes.b", "planes.c"})
            if (liesInPlane(places, pane(name).mapping().view, 1e-9)) return pane(name);
        qFatal("no plane holds the places");
    }
    static void press(PlanePane& pane, const QPointF& at, bool released = true) {
        QMouseEvent press(QEvent::MouseButtonPress, at, pane.mapToGlobal(at), Qt::LeftButton, Qt::LeftButton,
                          Qt::NoModifier);
        QCoreApplication::sendEvent(&pane, &press);
        if (released) release(pane, at);
    }
    static void release(PlanePane& pane, const QPointF& at) {
        QMouseEvent release(QEvent::MouseButtonRelease, at, pane.mapToGlobal(at), Qt::LeftButton, Qt::NoButton,
                            Qt::NoModifier);
        QCoreApplication::sendEvent(&pane, &release);
    }
    void clickIn3d(const QPointF& at) {
        for (const QEvent::Type type : {QEvent::MouseButtonPress, QEvent::MouseButtonRelease}) {
            const bool press = type == QEvent::MouseButtonPress;
            QMouseEvent event(type, at, pictureWindow()->mapToGlobal(at), Qt::LeftButton,
                              press ? Qt::LeftButton : Qt::NoButton, Qt::NoModifier);
            QCoreApplication::sendEvent(pictureWindow(), &event);
        }
    }
    /// The middle of a marked voxel, grid mm.
    Vec3 at(int point) { return geometry().gridMmFromVoxel(markedVoxels[static_cast<std::size_t>(point)]); }
    [[nodiscard]] const std::vector<Measurement>& measurements() { return document().measurements; }
    double value(std::size_t index) { return measuredValue(measurements()[index], geometry()).value(); }
    const VolumeGeometry& geometry() { return window().openStudy().volume()->geometry(); }
    QListWidget& list() { return *child<QListWidget>("measurements.list"); }
    QString message() { return child<MessageBar>("message")->text(); }
};

}  // namespace echolucent
