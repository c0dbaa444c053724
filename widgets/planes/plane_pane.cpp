#include "widgets/planes/plane_pane.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace echolucent {

namespace {

constexpr double zoomPerNotch = 1.15, leastMagnification = 0.2, largestMagnification = 40.0;
constexpr double degreesOfNotch = 120.0;  // of a wheel, in eighths of a degree
constexpr double pixelsForTwiceTheWindow = 160.0;

}  // namespace

PlanePane::PlanePane(PlaneName plane, QWidget* parent) : QWidget(parent), m_plane(plane) {
    const QString letter = QString::fromUtf8(nameOf(plane).data(), static_cast<qsizetype>(nameOf(plane).size()));
    setObjectName(QStringLiteral("planes.") + letter.toLower());
    setAccessibleName(tr("Plane %1").arg(letter));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    createButtons();
}

void PlanePane::createButtons() {
    const auto create = [this](const QString& text, const QString& name, const QString& words) {
        auto* button = new QToolButton(this);
        button->setObjectName(objectName() + name);
        button->setText(text);
        button->setAccessibleName(words);
        button->setToolTip(words);
        button->setFocusPolicy(Qt::TabFocus);
        button->setAutoRaise(true);
        button->setProperty("overPicture", true);
        button->setFixedSize(24, 22);
        return button;
    };
    m_reset = create(QStringLiteral("⟲"), QStringLiteral(".reset"), tr("Reset this plane (Home)"));
    m_maximise = create(QStringLiteral("⤢"), QStringLiteral(".maximise"),
                        tr("The whole room for this plane, or back (double click)"));
    connect(m_reset, &QToolButton::clicked, this, &PlanePane::reset);
    connect(m_maximise, &QToolButton::clicked, this, &PlanePane::maximiseRequested);
}

void PlanePane::placeButtons() {
    m_maximise->move(width() - m_maximise->width() - 4, 4);
    m_reset->move(m_maximise->x() - m_reset->width() - 2, 4);
}

void PlanePane::setScene(const PlaneScene& scene) {
    if (m_scene == scene) return;
    m_scene = scene;
    m_drawing.reset();
    makeImage();
    update();
}

void PlanePane::setDimmed(bool dimmed) {
    if (std::exchange(m_dimmed, dimmed) != dimmed) update();
}

void PlanePane::clear() {
    cancelDrag();
    m_scene.reset();
    m_drawing.reset();
    m_samples.reset();
    m_image = {};
    m_marking.reset();
    m_drag = Drag::none;
    update();
}

std::optional<PlaneRequest> PlanePane::wanted(const std::shared_ptr<const Volume>& volume) const {
    if (!m_scene || !volume || !isVisible() || size().isEmpty()) return std::nullopt;
    const QSize pixels = size() * devicePixelRatioF();
    return PlaneRequest{volume, mapping().view, pixels.width(), pixels.height()};
}

void PlanePane::setSamples(const std::shared_ptr<const PlaneSamples>& samples) {
    m_samples = samples;
    m_image = {};
    makeImage();
    update();
}

void PlanePane::setMarking(const std::optional<ShownMeasurement>& marking) {
    if (marking == m_marking) return;
    m_marking = marking;
    update();
}

void PlanePane::setToolCursor(std::optional<Qt::CursorShape> cursor) {
    if (cursor == m_toolCursor) return;
    m_toolCursor = cursor;
    if (cursor) setCursor(*cursor);
}

void PlanePane::makeImage() {
    if (!m_scene || !m_samples) return;
    if (!m_image.isNull() && greys() == m_greys) return;
    m_greys = greys();
    m_image = greyImage(*m_samples, m_greys);
}

PlaneMapping PlanePane::mapping() const {
    const double aspect = size().isEmpty() ? 1.0 : static_cast<double>(width()) / height();
    return {planeViewOf(m_scene->planes, m_plane, m_scene->beam, m_scene->data, aspect), size()};
}

const BoxDrawing& PlanePane::drawing() const {
    // Keep the drawing: its line takes hundreds of rays through the start surface, and every move of the cursor needs
    // the drawing.
    if (!m_drawing) m_drawing = boxDrawing(m_scene->box, mapping());
    return *m_drawing;
}

QPointF PlanePane::referencePixel() const { return mapping().seenAt(referencePointOf(m_scene->planes, m_scene->data)); }

bool PlanePane::atRim(const QPointF& pixel) const {
    return std::min({pixel.x(), pixel.y(), width() - pixel.x(), height() - pixel.y()}) < rim;
}

void PlanePane::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    placeButtons();
    m_drawing.reset();
    emit wantsOther();
}

void PlanePane::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    emit wantsOther();
}

void PlanePane::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    cancelDrag();
    emit wantsOther();
}

void PlanePane::ask(const Planes& next, const QString& what) {
    if (next != m_scene->planes) emit changed(next, what);
}

PlanePane::Drag PlanePane::leftDragAt(const QPointF& pixel) {
    if (const auto grip = gripAt(drawing(), pixel)) {
        m_grip = *grip;
        return Drag::grip;
    }
    return atRim(pixel) ? Drag::turn : Drag::reference;
}

QString PlanePane::stepName(const BoxGrip& grip) {
    switch (grip.kind) {
        case BoxGrip::Kind::face:
        case BoxGrip::Kind::corner: return tr("size of the box");
        case BoxGrip::Kind::centre: return tr("move box");
        case BoxGrip::Kind::turn: return tr("turn box");
        case BoxGrip::Kind::bow: return tr("bow the front");
        case BoxGrip::Kind::front: return tr("front");
    }
    return {};
}

void PlanePane::mousePressEvent(QMouseEvent* event) {
    if (!m_scene || m_drag != Drag::none) return;
    const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
    if (event->button() == Qt::RightButton)
        m_drag = Drag::greys;
    else if (event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && shift))
        m_drag = Drag::pan;
    else if (event->button() == Qt::LeftButton)
        m_drag = leftDragAt(event->position());
    m_before = m_scene->planes;
    m_beforeClick = m_before;
    m_boxBefore = m_scene->box;
    m_mappingBefore = mapping();
    m_from = event->position();
    m_what = m_drag == Drag::grip    ? stepName(m_grip)
             : m_drag == Drag::greys ? tr("window and level")
             : m_drag == Drag::pan   ? tr("move plane %1").arg(QLatin1Char(nameOf(m_plane).front()))
             : m_drag == Drag::turn  ? tr("turn planes")
                                     : tr("move reference point");
    if (m_drag == Drag::reference) dragTo(event->position());
}

void PlanePane::mouseMoveEvent(QMouseEvent* event) {
    if (!m_scene) return;
    if (m_drag != Drag::none) return dragTo(event->position());
    showCursor(event->position());
    emit pointed(mapping().gridAt(event->position()));
}

void PlanePane::mouseReleaseEvent(QMouseEvent* event) {
    if (event->buttons() != Qt::NoButton || m_drag == Drag::none) return;
    m_drag = Drag::none;
    emit dragEnded(m_what);
    showCursor(event->position());
}

void PlanePane::mouseDoubleClickEvent(QMouseEvent* event) {
    if (!m_scene || event->button() != Qt::LeftButton) return QWidget::mouseDoubleClickEvent(event);
    if (cancelDrag()) return;
    // The first click has moved the reference point. A person who asks for the whole room does not want that.
    if (m_scene->planes != m_beforeClick) emit clickTakenBack(m_beforeClick, m_what);
    emit maximiseRequested();
}

void PlanePane::passOver() {
    if (m_scene) m_beforeClick = m_scene->planes;
}

bool PlanePane::cancelDrag() {
    if (m_drag == Drag::none || !m_scene) return false;
    m_drag = Drag::none;
    emit dragCancelled();
    return true;
}

void PlanePane::dragTo(const QPointF& pixel) {
    const QPointF moved = pixel - m_from;
    Planes next = m_before;
    switch (m_drag) {
        case Drag::none: return;
        case Drag::grip:
            emit boxDragged(m_grip, dragged(m_boxBefore, m_mappingBefore, m_grip, m_from, pixel), m_what);
            return;
        case Drag::reference: next = withReferencePoint(m_before, m_mappingBefore.gridAt(pixel), m_scene->data); break;
        case Drag::turn: {
            // Count from the beginning of the drag, so that rounding errors do not add up.
            const QPointF centre = referencePixel(), from = m_from - centre, to = pixel - centre;
            const double radians = std::atan2(from.x() * to.y() - from.y() * to.x(), QPointF::dotProduct(from, to));
            next = turned(m_before, m_plane, radians * 180.0 / std::numbers::pi, m_scene->beam);
            break;
        }
        case Drag::pan: {
            PlaneCrop& crop = next.crops[indexOf(m_plane)];
            crop.panRightMm -= moved.x() * mapping().mmPerPixel();
            crop.panDownMm -= moved.y() * mapping().mmPerPixel();
            break;
        }
        case Drag::greys:
            next.window = std::clamp(m_before.window * std::exp2(moved.x() / pixelsForTwiceTheWindow), leastPlaneWindow,
                                     largestPlaneWindow);
            next.level = std::clamp(m_before.level + moved.y() / (2.0 * pixelsForTwiceTheWindow), leastPlaneLevel,
                                    largestPlaneLevel);
            break;
    }
    ask(next, m_what);
}

void PlanePane::wheelEvent(QWheelEvent* event) {
    if (!m_scene) return;
    event->accept();
    const double notches = event->angleDelta().y() / degreesOfNotch;
    if (notches == 0.0) return;
    if (event->modifiers().testFlag(Qt::ControlModifier))
        zoom(std::pow(zoomPerNotch, notches), event->position());
    else if (const auto grip = gripAt(drawing(), event->position()); grip && grip->kind == BoxGrip::Kind::front)
        emit frontWheeled(-notches * m_scene->unitMm, stepName(*grip));
    else
        ask(stepped(m_scene->planes, m_plane, -notches * m_scene->unitMm, m_scene->beam, m_scene->data),
            tr("step through planes"));
}

void PlanePane::zoom(double factor, const QPointF& about) {
    Planes next = m_scene->planes;
    PlaneCrop& crop = next.crops[indexOf(m_plane)];
    const double magnification = std::clamp(crop.magnification * factor, leastMagnification, largestMagnification);
    // The place under `about` stays there.
    const double kept = 1.0 - crop.magnification / magnification;
    crop.panRightMm += (about.x() - width() / 2.0) * mapping().mmPerPixel() * kept;
    crop.panDownMm += (about.y() - height() / 2.0) * mapping().mmPerPixel() * kept;
    crop.magnification = magnification;
    ask(next, tr("zoom plane %1").arg(QLatin1Char(nameOf(m_plane).front())));
}

void PlanePane::turn(double degrees) {
    ask(turned(m_scene->planes, m_plane, degrees, m_scene->beam), tr("turn planes"));
}

void PlanePane::reset() {
    if (!m_scene) return;
    // The reference point, the turn and the greys belong to all planes and are reset too. With the turn go the shifts
    // of the other pictures.
    Planes next = m_scene->planes;
    const Planes start;
    for (PlaneCrop& crop : next.crops) crop = {.magnification = crop.magnification};
    next.crops[indexOf(m_plane)] = start.crops[indexOf(m_plane)];
    next.direction = start.direction;
    next.offsetMm = start.offsetMm;
    next.window = start.window;
    next.level = start.level;
    ask(next, tr("reset plane %1").arg(QLatin1Char(nameOf(m_plane).front())));
}

namespace {

bool isKeyOfPane(const QKeyEvent& event) {
    if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) return false;
    switch (event.key()) {
        case Qt::Key_Left:
        case Qt::Key_Right:
        case Qt::Key_Up:
        case Qt::Key_Down:
        case Qt::Key_PageUp:
        case Qt::Key_PageDown:
        case Qt::Key_Plus:
        case Qt::Key_Equal:
        case Qt::Key_Minus:
        case Qt::Key_Home: return true;
        default: return false;
    }
}

}  // namespace

bool PlanePane::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        if (isKeyOfPane(key) || (key.key() == Qt::Key_Escape && dragging())) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void PlanePane::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && cancelDrag()) return;
    if (!m_scene || !isKeyOfPane(*event)) return QWidget::keyPressEvent(event);
    const double degrees = event->modifiers().testFlag(Qt::ShiftModifier) ? 10.0 : 1.0;
    const auto step = [this](double units) {
        ask(stepped(m_scene->planes, m_plane, units * m_scene->unitMm, m_scene->beam, m_scene->data),
            tr("step through planes"));
    };
    switch (event->key()) {
        case Qt::Key_Left: return turn(-degrees);
        case Qt::Key_Right: return turn(degrees);
        case Qt::Key_Up: return step(-1.0);
        case Qt::Key_Down: return step(1.0);
        case Qt::Key_PageUp: return step(-10.0);
        case Qt::Key_PageDown: return step(10.0);
        case Qt::Key_Plus:
        case Qt::Key_Equal: return zoom(zoomPerNotch, rect().center());
        case Qt::Key_Minus: return zoom(1.0 / zoomPerNotch, rect().center());
        case Qt::Key_Home: return reset();
        default: QWidget::keyPressEvent(event);
    }
}

QString PlanePane::spokenState() const {
    if (!m_scene) return tr("nothing is shown");
    return m_scene->lie.isEmpty() ? offsetWords() : offsetWords() + QStringLiteral(", ") + m_scene->lie;
}

std::vector<SpokenAction> PlanePane::spokenActions() const {
    return {{tr("Step to the plane before"), Qt::Key_Up},
            {tr("Step to the next plane"), Qt::Key_Down},
            {tr("Step back by ten planes"), Qt::Key_PageUp},
            {tr("Step on by ten planes"), Qt::Key_PageDown},
            {tr("Turn to the left"), Qt::Key_Left},
            {tr("Turn to the right"), Qt::Key_Right},
            {tr("Zoom in"), Qt::Key_Plus},
            {tr("Zoom out"), Qt::Key_Minus},
            {tr("Reset the plane"), Qt::Key_Home}};
}

void PlanePane::showCursor(const QPointF& pixel) {
    const std::optional<BoxGrip> grip = gripAt(drawing(), pixel);
    const bool rimmed = !grip && !m_toolCursor && atRim(pixel);
    setCursor(m_toolCursor ? *m_toolCursor : grip ? cursorOf(*grip) : rimmed ? Qt::SizeAllCursor : Qt::CrossCursor);
    if (rimmed == m_pointerAtRim) return;
    m_pointerAtRim = rimmed;
    update();
}

/// The pointer tells what a grip does: a face of the box moves, the box moves or turns, the front moves or bows.
Qt::CursorShape PlanePane::cursorOf(const BoxGrip& grip) const {
    switch (grip.kind) {
        case BoxGrip::Kind::centre: return Qt::SizeAllCursor;
        case BoxGrip::Kind::turn: return Qt::OpenHandCursor;
        case BoxGrip::Kind::bow: return Qt::PointingHandCursor;
        case BoxGrip::Kind::front: {
            const QPointF way = mapping().wayOf(m_scene->box.front->frame.forward);
            return std::abs(way.x()) > std::abs(way.y()) ? Qt::SplitHCursor : Qt::SplitVCursor;
        }
        case BoxGrip::Kind::face: {
            const QPointF way = mapping().wayOf(outwardNormal(*m_scene->box.box, grip.first));
            return std::abs(way.x()) > std::abs(way.y()) ? Qt::SizeHorCursor : Qt::SizeVerCursor;
        }
        case BoxGrip::Kind::corner: {
            const QPointF way = mapping().wayOf(outwardNormal(*m_scene->box.box, grip.first) +
                                                outwardNormal(*m_scene->box.box, grip.second));
            return (way.x() > 0.0) == (way.y() > 0.0) ? Qt::SizeFDiagCursor : Qt::SizeBDiagCursor;
        }
    }
    return Qt::CrossCursor;
}

void PlanePane::leaveEvent(QEvent* event) {
    QWidget::leaveEvent(event);
    m_pointerAtRim = false;
    update();
    emit pointed(std::nullopt);
}

}  // namespace echolucent
