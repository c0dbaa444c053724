#include "widgets/large_pointer.h"

#include <QGuiApplication>
#include <QPainter>
#include <QPixmap>
#include <cmath>

#include "widgets/theme_colours.h"

namespace echolucent {

QCursor largePointer(double pixelRatio) {
    constexpr double ring = 5.0, rim = 2.0, dot = 5.0;
    const int pixels = static_cast<int>(std::ceil(largePointerSize * pixelRatio));
    QPixmap picture(pixels, pixels);
    picture.setDevicePixelRatio(pixelRatio);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF middle(largePointerSize / 2.0, largePointerSize / 2.0);
    const double radius = largePointerSize / 2.0 - rim - ring / 2;
    const ThemeColours& colours = coloursOverPictures();
    for (const auto& [colour, more] : {std::pair{colours.background, rim}, std::pair{colours.warning, 0.0}}) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colour, ring + 2 * more));
        painter.drawEllipse(middle, radius, radius);
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        painter.drawEllipse(middle, dot + more, dot + more);
    }
    painter.end();
    return QCursor(picture, largePointerSize / 2, largePointerSize / 2);
}

void LargePointer::show(bool shown) {
    if (shown == m_shown) return;
    m_shown = shown;
    if (shown)
        QGuiApplication::setOverrideCursor(largePointer(qGuiApp->devicePixelRatio()));
    else
        QGuiApplication::restoreOverrideCursor();
}

}  // namespace echolucent
