#include "widgets/compare/surface_legend.h"

#include <array>
#include <cmath>

#include "widgets/surface_colours.h"
#include "widgets/theme_colours.h"

namespace echolucent {

namespace {

constexpr int sampleGap = 4, entriesApart = 12;  // between a sample and its words, and between entries

enum class Words { percent, number, name };

QString wordsOf(const SurfaceLegendEntry& entry, Words words) {
    const QString name = wordOf(entry.shown);
    if (!entry.percent || words == Words::name) return name;
    const QString number = QStringLiteral("%1 %2").arg(name).arg(*entry.percent);
    return words == Words::number ? number : number + QStringLiteral(" %");
}

int widthOf(const SurfaceLegend& legend, Words words, const QFontMetrics& metrics, int side) {
    int width = -entriesApart;
    for (const SurfaceLegendEntry& entry : legend)
        width += side + sampleGap + metrics.horizontalAdvance(wordsOf(entry, words)) + entriesApart;
    return width;
}

QImage sampleOf(ShownSurface shown, int side) {
    constexpr int white = 255;
    QImage sample(side, side, QImage::Format_RGB32);
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            sample.setPixel(column, row, surfaceShade(shown, white, column, row));
    return sample;
}

}  // namespace

SurfaceLegend surfaceLegend(const std::optional<ShownDepth>& depth) {
    SurfaceLegend legend;
    for (const ShownSurface shown : allShownSurfaces) {
        const auto share = depth ? depth->share(shown) : std::nullopt;
        legend.push_back({shown, share ? std::optional(static_cast<int>(std::lround(100.0 * *share))) : std::nullopt});
    }
    return legend;
}

int surfaceLegendWidth(const SurfaceLegend& legend, const QFontMetrics& metrics) {
    return widthOf(legend, Words::percent, metrics, metrics.ascent());
}

void paintSurfaceLegend(QPainter& painter, const QRect& line, const SurfaceLegend& legend, const QColor& text) {
    const QFontMetrics metrics = painter.fontMetrics();
    const int side = metrics.ascent();
    Words words = Words::name;
    for (const Words longer : {Words::number, Words::percent})
        if (widthOf(legend, longer, metrics, side) <= line.width()) words = longer;
    painter.save();
    painter.setClipRect(line);
    painter.setPen(text);
    int left = line.left();
    for (const SurfaceLegendEntry& entry : legend) {
        painter.drawImage(QRect(left, line.top() + (line.height() - side) / 2, side, side),
                          sampleOf(entry.shown, side));
        left += side + sampleGap;
        const QString said = wordsOf(entry, words);
        painter.drawText(QRect(left, line.top(), line.right() + 1 - left, line.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, said);
        left += metrics.horizontalAdvance(said) + entriesApart;
    }
    painter.restore();
}

QImage withSurfaceLegend(const QImage& picture, const SurfaceLegend& legend) {
    const int line = QFontMetrics(QFont()).height() + 2 * sampleGap;
    QImage image(picture.width(), picture.height() + line, QImage::Format_RGB32);
    image.fill(Qt::black);
    QPainter painter(&image);
    painter.drawImage(0, 0, picture);
    paintSurfaceLegend(painter, QRect(sampleGap, picture.height(), picture.width() - 2 * sampleGap, line), legend,
                       coloursOverPictures().text);
    return image;
}

}  // namespace echolucent
