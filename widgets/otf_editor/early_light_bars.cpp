#include "widgets/otf_editor/early_light_bars.h"

#include <QBrush>
#include <QCoreApplication>
#include <QPen>
#include <algorithm>
#include <cmath>

namespace echolucent {

namespace {
QString tr(const char* text) { return QCoreApplication::translate("early light", text); }
}  // namespace

double earlyLightOfFullHeight(const EarlyLight& light) {
    const double highest = std::ranges::max(light.held);
    for (const double height : {0.1, 0.2, 0.5})
        if (highest <= height) return height;
    return 1.0;
}

std::array<double, EarlyLight::bins> earlyLightHeights(const EarlyLight& light) {
    std::array<double, EarlyLight::bins> heights{};
    const double full = earlyLightOfFullHeight(light);
    std::ranges::transform(light.held, heights.begin(), [full](double held) { return std::min(1.0, held / full); });
    return heights;
}

QString wordsOf(const EarlyLight& light) {
    if (light.rays == 0) return tr("No surface is known in this view");
    const double percent = 100.0 * light.sum();
    if (percent <= 0.0) return tr("Held back early: none of the light");
    const QString height = tr("height: %1 %").arg(std::lround(100.0 * earlyLightOfFullHeight(light)));
    const QString held = percent < 0.5 ? tr("Held back early: below 1 % of the light")
                                       : tr("Held back early: %1 % of the light").arg(std::lround(percent));
    return QStringLiteral("%1, %2").arg(held, height);
}

void paintEarlyLight(QPainter& painter, const PlotAxes& axes, const EarlyLight& light, const QColor& colour) {
    constexpr float ofFill = 0.35F;
    const auto heights = earlyLightHeights(light);
    const auto xOf = [&](std::size_t edge) {
        return axes.positionOf({static_cast<double>(edge) / static_cast<double>(heights.size()), 0.0}).x();
    };
    QColor fill = colour;
    fill.setAlphaF(ofFill);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QPen(colour, 1.0));
    for (std::size_t bin = 0; bin < heights.size(); ++bin) {
        if (heights[bin] <= 0.0) continue;
        const double high = std::max(1.0, heights[bin] * axes.rect.height());
        const QRectF bar(xOf(bin), axes.rect.bottom() - high, xOf(bin + 1) - xOf(bin), high);
        painter.fillRect(bar, fill);
        painter.fillRect(bar, QBrush(colour, Qt::BDiagPattern));
        painter.drawLine(bar.topLeft(), bar.topRight());
    }
    painter.restore();
}

}  // namespace echolucent
