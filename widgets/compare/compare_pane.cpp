#include "widgets/compare/compare_pane.h"

#include <QElapsedTimer>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/theme_colours.h"

namespace echolucent {

namespace {

constexpr double wipeOfKey = 0.02;
constexpr double lineReach = 8.0;  // logical pixels to either side of the line of a wipe
constexpr int aroundSign = 5;      // logical pixels

}  // namespace

ComparePane::ComparePane(const QString& name, QWidget* parent) : QWidget(parent) {
    setObjectName(name);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    constexpr int wide = 1000;
    m_caption = captionLayout({}, wide, font());
}

void ComparePane::setFace(const PaneFace& face) {
    if (face == m_face) return;
    m_face = face;
    setAccessibleName(tr("Picture compared: %1").arg(face.name));
    setAccessibleDescription(face.numbers);
    update();
}

void ComparePane::setCaption(const CaptionLayout& caption) {
    if (caption == m_caption) return;
    m_caption = caption;
    update();
}

void ComparePane::setImage(const QImage& image) {
    if (image.cacheKey() == m_image.cacheKey()) return;  // an edit of one pane draws that pane alone
    m_image = image;
    update();
}

void ComparePane::setWipe(const QImage& right, std::optional<double> share) {
    m_right = right;
    m_wipe = share;
    update();
}

void ComparePane::setBusy(bool busy) {
    if (std::exchange(m_busy, busy) != busy) update();
}

void ComparePane::setDimmed(bool dimmed) {
    if (std::exchange(m_dimmed, dimmed) != dimmed) update();
}

QRect ComparePane::pictureRect() const { return pictureIn(rect(), m_caption); }

QSize ComparePane::pictureSize() const {
    const QSizeF size = QSizeF(pictureRect().size()) * devicePixelRatioF();
    return {std::max(1, static_cast<int>(size.width())), std::max(1, static_cast<int>(size.height()))};
}

bool ComparePane::cancelDrag() {
    if (!dragging()) return false;
    m_drag = CameraDrag::none;
    m_wiping = false;
    emit dragCancelled();
    return true;
}

void ComparePane::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    cancelDrag();
}

void ComparePane::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    emit focused();
}

void ComparePane::paintTo(QPainter& painter) const {
    painter.fillRect(rect(), Qt::black);
    paintPicture(painter);
    paintFace(painter, rect(), m_face, m_caption, &m_map);
}

void ComparePane::paintEvent(QPaintEvent*) {
    QElapsedTimer clock;
    clock.start();
    {
        QPainter painter(this);
        paintTo(painter);
        if (m_busy) paintBusy(painter);
        const ThemeColours& colours = coloursOverPictures();
        painter.setBrush(Qt::NoBrush);
        if (hasFocus()) {
            painter.setPen(QPen(m_face.coloured ? colours.text : colours.accent, 1, Qt::DotLine));
            painter.drawRect(rect().adjusted(3, 3, -4, -4));
        }
        if (m_dimmed) painter.fillRect(rect(), oldPictureShadeColour());
    }
    emit painted(static_cast<double>(clock.nsecsElapsed()) * 1e-6);
}

void ComparePane::paintPicture(QPainter& painter) const {
    const QRect place = pictureRect();
    if (m_image.isNull()) return;
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(place, m_image);
    if (!m_wipe) return;
    const double line = place.x() + *m_wipe * place.width();
    painter.save();
    painter.setClipRect(QRectF(line, place.y(), place.right() + 1 - line, place.height()));
    if (!m_right.isNull()) painter.drawImage(place, m_right);
    painter.setClipping(false);
    painter.fillRect(QRectF(line - 1, place.y(), 2, place.height()), coloursOverPictures().accent);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(coloursOverPictures().accent);
    painter.drawEllipse(QPointF(line, place.center().y()), 6, 6);
    painter.restore();
}

/// In the lower right corner of the picture, where no name and no OTF is.
void ComparePane::paintBusy(QPainter& painter) const {
    const QString sign = tr("computing");
    painter.save();
    painter.setFont(m_caption.font);
    const QRect text = painter.fontMetrics().boundingRect(sign);
    QRect place(0, 0, text.width() + 2 * aroundSign, text.height() + 2);
    place.moveBottomRight(pictureRect().bottomRight());
    constexpr int ground = 170;
    painter.fillRect(place, QColor(0, 0, 0, ground));
    painter.setPen(coloursOverPictures().accent);
    painter.drawText(place, Qt::AlignCenter, sign);
    painter.restore();
}

bool ComparePane::onLine(const QPointF& place) const {
    if (!m_wipe) return false;
    const QRect picture = pictureRect();
    return picture.contains(place.toPoint()) &&
           std::abs(place.x() - picture.x() - *m_wipe * picture.width()) <= lineReach;
}

void ComparePane::mousePressEvent(QMouseEvent* event) {
    if (dragging()) return;
    m_wiping = event->button() == Qt::LeftButton && onLine(event->position());
    m_drag = m_wiping ? CameraDrag::none : cameraDragOf(*event);
    if (!dragging()) return;
    m_button = event->button();
    m_last = event->position();
}

void ComparePane::mouseMoveEvent(QMouseEvent* event) {
    if (!dragging()) return setCursor(onLine(event->position()) ? Qt::SplitHCursor : Qt::ArrowCursor);
    const QRect picture = pictureRect();
    const QPointF moved = (event->position() - m_last) / std::max(1, picture.height());
    m_last = event->position();
    if (moved.isNull()) return;
    if (m_wiping)
        return emit wipeMoved(std::clamp((m_last.x() - picture.x()) / std::max(1, picture.width()), 0.0, 1.0));
    switch (m_drag) {
        case CameraDrag::orbit: emit orbited(moved.x(), moved.y()); break;
        case CameraDrag::pan: emit panned(moved.x(), moved.y()); break;
        case CameraDrag::zoom: emit zoomed(zoomOfDrag(moved.y())); break;
        case CameraDrag::light: emit lightMoved(moved.x(), moved.y()); break;
        case CameraDrag::none: break;
    }
}

void ComparePane::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != m_button || !dragging()) return;
    m_drag = CameraDrag::none;
    m_wiping = false;
    emit dragEnded();
}

void ComparePane::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && !onLine(event->position())) emit maximiseRequested();
}

void ComparePane::wheelEvent(QWheelEvent* event) {
    const double factor = zoomOfWheel(*event);
    if (factor == 1.0) return;
    const QRectF picture = pictureRect();
    const QPointF shares = (event->position() - picture.center()) / std::max(1.0, picture.height());
    emit zoomedAbout(shares.x(), shares.y(), factor);
    event->accept();
}

/// The shift of the wipe's line by a key; no value for another key, or without a wipe.
std::optional<double> ComparePane::wipeOf(const QKeyEvent& event) const {
    const std::optional<QPointF> direction = directionOfArrow(event.key());
    const bool held = event.modifiers() & (Qt::AltModifier | Qt::MetaModifier);
    if (!m_wipe || held || !direction || direction->x() == 0.0) return std::nullopt;
    return wipeOfKey * direction->x();
}

bool ComparePane::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        if (!cameraKeyOf(key) && !wipeOf(key)) return QWidget::event(event);
        event->accept();  // the keys of the pane come before those of the window
        return true;
    }
    return QWidget::event(event);
}

void ComparePane::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && cancelDrag()) return;
    const std::optional<CameraKey> key = cameraKeyOf(*event);
    const std::optional<double> wipe = wipeOf(*event);
    if (!key && !wipe) return QWidget::keyPressEvent(event);
    if (dragging()) return;
    if (!key) return emit wipeMoved(std::clamp(*m_wipe + *wipe, 0.0, 1.0));
    switch (key->moves) {
        case CameraDrag::orbit: emit orbited(key->shares.x(), key->shares.y()); break;
        case CameraDrag::pan: emit panned(key->shares.x(), key->shares.y()); break;
        default: emit zoomed(key->factor); break;
    }
}

}  // namespace echolucent
