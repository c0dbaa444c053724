#include "widgets/compare/otf_inset.h"

#include <QPainter>
#include <utility>

namespace echolucent {

OtfInset::OtfInset(QWidget* parent) : OverPicture(parent) {
    setObjectName("view3d.otf");
    setAccessibleName(tr("OTF of the picture"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    hide();
}

void OtfInset::setFace(const PaneFace& face) {
    if (std::exchange(m_face, face) != face) update();
}

/// In the upper right corner: the axes and the scale stand in the lower ones, the caption in the upper left one.
QRect OtfInset::placeOver(const QRect& picture) const {
    QRectF inset = insetIn(picture);
    const double around = inset.left() - picture.left();
    inset.moveTopRight({picture.right() - around, picture.top() + around});
    return inset.toAlignedRect();
}

void OtfInset::showEvent(QShowEvent* event) {
    OverPicture::showEvent(event);
    place();
}

void OtfInset::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), Qt::black);  // nothing of the picture is seen through a window of its own
    constexpr double halfPixel = 0.5;
    paintInset(painter, QRectF(rect()).adjusted(halfPixel, halfPixel, -halfPixel, -halfPixel), m_face, &m_map);
}

}  // namespace echolucent
