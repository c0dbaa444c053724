#include "widgets/camera_gestures.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "processing/picture/camera_pose.h"

namespace echolucent {

namespace {
constexpr double zoomPerNotch = 1.15;  // also for a key
constexpr double wheelNotch = 120.0;   // Qt's eighths of a degree
constexpr double zoomOverHeight = 12.0;
constexpr double moveOfKey = 0.05;
}  // namespace

CameraDrag cameraDragOf(const QMouseEvent& press) {
    switch (press.button()) {
        case Qt::LeftButton:
            if (press.modifiers().testFlag(Qt::ControlModifier)) return CameraDrag::light;
            return press.modifiers().testFlag(Qt::ShiftModifier) ? CameraDrag::pan : CameraDrag::orbit;
        case Qt::MiddleButton: return CameraDrag::pan;
        case Qt::RightButton: return CameraDrag::zoom;
        default: return CameraDrag::none;
    }
}

double zoomOfDrag(double down) { return std::pow(zoomOverHeight, -down); }

double zoomOfWheel(const QWheelEvent& event) { return std::pow(zoomPerNotch, event.angleDelta().y() / wheelNotch); }

std::optional<QPointF> directionOfArrow(int key) {
    switch (key) {
        case Qt::Key_Left: return QPointF(-1, 0);
        case Qt::Key_Right: return QPointF(1, 0);
        case Qt::Key_Up: return QPointF(0, -1);
        case Qt::Key_Down: return QPointF(0, 1);
        default: return std::nullopt;
    }
}

std::optional<CameraKey> cameraKeyOf(const QKeyEvent& event) {
    const bool control = event.modifiers().testFlag(Qt::ControlModifier);
    const bool shift = event.modifiers().testFlag(Qt::ShiftModifier);
    if (event.modifiers() & (Qt::AltModifier | Qt::MetaModifier)) return std::nullopt;
    if (!control && event.key() == Qt::Key_Plus) return CameraKey{CameraDrag::zoom, {}, zoomPerNotch};
    if (!control && event.key() == Qt::Key_Minus) return CameraKey{CameraDrag::zoom, {}, 1.0 / zoomPerNotch};
    const std::optional<QPointF> direction = directionOfArrow(event.key());
    if (!direction || (!control && !shift)) return std::nullopt;
    if (!control) return CameraKey{CameraDrag::pan, moveOfKey * *direction};
    return CameraKey{CameraDrag::orbit, (shift ? 10.0 : 1.0) / degreesPerHeight * *direction};
}

std::vector<SpokenAction> cameraActions() {
    const auto tr = [](const char* text) { return QCoreApplication::translate("accessibility", text); };
    return {{tr("Turn to the left"), Qt::CTRL | Qt::SHIFT | Qt::Key_Left},
            {tr("Turn to the right"), Qt::CTRL | Qt::SHIFT | Qt::Key_Right},
            {tr("Turn up"), Qt::CTRL | Qt::SHIFT | Qt::Key_Up},
            {tr("Turn down"), Qt::CTRL | Qt::SHIFT | Qt::Key_Down},
            {tr("Move to the left"), Qt::SHIFT | Qt::Key_Left},
            {tr("Move to the right"), Qt::SHIFT | Qt::Key_Right},
            {tr("Move up"), Qt::SHIFT | Qt::Key_Up},
            {tr("Move down"), Qt::SHIFT | Qt::Key_Down},
            {tr("Zoom in"), Qt::Key_Plus},
            {tr("Zoom out"), Qt::Key_Minus}};
}

}  // namespace echolucent
