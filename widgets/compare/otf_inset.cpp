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

QRect OtfInset::placeOver(const QRect& picture) const { return insetIn(picture).toAlignedRect(); }

void OtfInset::showEvent(QShowEvent* event) {
    OverPicture::showEvent(event);
    place();
}

void OtfInset::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), Qt::black);  // nothing of the picture is seen through a window of its own
    constexpr double halfPixel = 0.5;
    paintInset(painter, QRectF(rect()).adjusted(halfPixel, halfPixel, -halfPixel, -halfPixel), m_face);
}

}  // namespace echolucent
