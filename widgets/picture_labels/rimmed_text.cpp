#include "widgets/picture_labels/rimmed_text.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <QPixmapCache>
#include <QThread>

namespace echolucent {

namespace {

/// Paints the text's path with its rim, from the left end of its baseline.
void paintPath(QPainter& painter, const QPointF& baseline, const QString& text, const QColor& colour, double rim) {
    QPainterPath path;
    path.addText(baseline, painter.font(), text);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.strokePath(path, QPen(QColor(0, 0, 0, 200), 2.0 * rim, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(path, colour);
    painter.restore();
}

/// The text on a transparent ground, with room for the rim.
QPixmap pixmapOf(const QFont& font, const QString& text, const QColor& colour, double rim, double ratio) {
    const QFontMetricsF metrics(font);
    const QSizeF size(metrics.horizontalAdvance(text) + 4 * rim, metrics.height() + 4 * rim);
    QPixmap pixmap((size * ratio).toSize() + QSize(1, 1));
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setFont(font);
    paintPath(painter, {2 * rim, 2 * rim + metrics.ascent()}, text, colour, rim);
    return pixmap;
}

}  // namespace

void paintRimmedText(QPainter& painter, const QPointF& baseline, const QString& text, const QColor& colour,
                     double rim) {
    // Only the GUI thread may use pixmaps.
    if (QThread::currentThread() != QCoreApplication::instance()->thread())
        return paintPath(painter, baseline, text, colour, rim);
    // Rims take longer to paint than all else in a pane. Most texts stay the same during a drag, so keep them.
    const double ratio = painter.device()->devicePixelRatioF();
    const QString key = QStringLiteral("rimmed/%1/%2/%3/%4/%5")
                            .arg(painter.font().key(), colour.name(QColor::HexArgb))
                            .arg(ratio)
                            .arg(rim)
                            .arg(text);
    QPixmap pixmap;
    if (!QPixmapCache::find(key, &pixmap)) {
        pixmap = pixmapOf(painter.font(), text, colour, rim, ratio);
        QPixmapCache::insert(key, pixmap);
    }
    const QPointF corner = baseline - QPointF(2 * rim, 2 * rim + QFontMetricsF(painter.font()).ascent());
    painter.drawPixmap(corner.toPoint(), pixmap);
}

}  // namespace echolucent
