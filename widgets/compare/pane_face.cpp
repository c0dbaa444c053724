#include "widgets/compare/pane_face.h"

#include <QCoreApplication>
#include <QFontInfo>
#include <QFontMetrics>
#include <QPolygonF>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "widgets/surface_colours.h"
#include "widgets/theme_colours.h"

namespace echolucent {

namespace {

constexpr int margin = 2, padding = 5, leastLetters = 7;
constexpr int tallest = 10'000;  // higher than any text below a picture

int roomIn(int width) { return std::max(1, width - 2 * (padding + margin)); }

/// The text, with a word, its number and its sign of percent in one line.
QString wrapping(QString text) {
    static const QRegularExpression share(QStringLiteral("(\\S+) (\\d+) %"));
    return text.replace(share, QStringLiteral("\\1\u00a0\\2\u00a0%"));
}

/// As long as the shares of a pane can be.
QString longestNumbers() {
    QStringList words;
    for (const ShownSurface shown : allShownSurfaces) words << QStringLiteral("%1 100 %").arg(wordOf(shown));
    return wrapping(words.join(QStringLiteral(" · ")));
}

int heightOf(const QString& text, int room, const QFontMetrics& metrics) {
    return metrics.boundingRect(QRect(0, 0, room, tallest), Qt::TextWordWrap, text).height();
}

bool fits(const QStringList& texts, int room, const QFontMetrics& metrics) {
    for (const QString& text : texts)
        for (const QString& word : text.split(QLatin1Char(' ')))
            if (metrics.horizontalAdvance(word) > room) return false;
    return true;
}

/// The legend of a coloured picture in one line, or in two. Letters get smaller only if two lines are too short.
void paintLegend(QPainter& painter, const QRect& place, const SurfaceLegend& legend) {
    QFont font = painter.font();
    const auto half = legend.begin() + static_cast<std::ptrdiff_t>(legend.size() / 2);
    const SurfaceLegend first(legend.begin(), half), second(half, legend.end());
    const auto width = [&] {
        const QFontMetrics metrics(font);
        return std::max(surfaceLegendWidth(first, metrics), surfaceLegendWidth(second, metrics));
    };
    int line = QFontMetrics(font).height();
    const bool inOne = surfaceLegendWidth(legend, QFontMetrics(font)) <= place.width();
    const QColor& text = coloursOverPictures().text;
    if (inOne || place.height() < 2 * line)
        return paintSurfaceLegend(painter, QRect(place.topLeft(), QSize(place.width(), line)), legend, text);
    while (width() > place.width() && QFontInfo(font).pixelSize() > leastLetters)
        font.setPixelSize(QFontInfo(font).pixelSize() - 1);
    painter.setFont(font);
    line = QFontMetrics(font).height();
    paintSurfaceLegend(painter, QRect(place.topLeft(), QSize(place.width(), line)), first, text);
    paintSurfaceLegend(painter, QRect(place.left(), place.top() + line, place.width(), line), second, text);
}

QPolygonF lineOf(const OpacityCurve& curve, const QRectF& plot) {
    constexpr int samples = 129;
    QPolygonF line;
    int i = 0;
    for (const double opacity : sampledOpacities(curve, samples))
        line << QPointF(plot.left() + plot.width() * i++ / (samples - 1),
                        plot.bottom() - plot.height() * std::clamp(opacity, 0.0, 1.0));
    return line;
}

/// Intensity to the right, gradient magnitude upwards, both from the middle of the first pixel to that of the last;
/// white is opaque.
QImage mapOf(const TwoDimensionalOtf& otf, const QSize& size) {
    constexpr double white = 255.0;
    QImage map(size, QImage::Format_Grayscale8);
    const int right = map.width() - 1, bottom = map.height() - 1;
    for (int row = 0; row <= bottom; ++row) {
        uchar* line = map.scanLine(row);
        const double gradient = otf.largestGradient * (bottom - row) / bottom;
        for (int i = 0; i <= right; ++i)
            line[i] = static_cast<uchar>(std::lround(white * opacityAt(otf, static_cast<double>(i) / right, gradient)));
    }
    return map;
}

void keepMapOf(const std::shared_ptr<const TwoDimensionalOtf>& otf, const QSize& wanted, InsetMap& map) {
    const QSize size = wanted.expandedTo({2, 2});
    if (map.otf == otf && map.image.size() == size) return;
    map = {otf, mapOf(*otf, size)};
}

}  // namespace

CaptionLayout captionLayout(const QStringList& names, int width, const QFont& font) {
    const int room = roomIn(width);
    const QString numbers = longestNumbers();
    CaptionLayout layout{.font = font};
    int letters = QFontInfo(font).pixelSize();
    while (!fits(QStringList(names) << numbers, room, QFontMetrics(layout.font)) && letters > leastLetters)
        layout.font.setPixelSize(--letters);
    const QFontMetrics metrics(layout.font);
    int name = metrics.height();
    for (const QString& each : names) name = std::max(name, heightOf(each, room, metrics));
    SurfaceLegend longest;
    for (const ShownSurface shown : allShownSurfaces) longest.push_back({shown, 100});
    const bool inOne = surfaceLegendWidth(longest, metrics) <= room;
    const int below = std::max(heightOf(numbers, room, metrics), inOne ? 0 : 2 * metrics.height());
    layout.height = name + std::max(below, metrics.height()) + 2 * padding;
    return layout;
}

QRect pictureIn(const QRect& pane, const CaptionLayout& caption) {
    return pane.adjusted(margin, margin, -margin, -margin - caption.height);
}

QRectF insetIn(const QRect& picture) {
    constexpr int leastPicture = 160;
    if (picture.width() < leastPicture) return {};
    const double wide = std::clamp(0.3 * picture.width(), 60.0, std::max(260.0, 0.22 * picture.width()));
    const double high = 0.6 * wide, around = wide / 30.0;
    return {picture.left() + around, picture.bottom() - around - high, wide, high};
}

void paintInset(QPainter& painter, const QRectF& inset, const PaneFace& face, InsetMap* kept) {
    if (!face.otf || inset.isEmpty()) return;
    const double inside = inset.width() / 30.0;
    const ThemeColours& colours = coloursOverPictures();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    constexpr int ground = 170;
    painter.setPen(QPen(colours.line, 1));
    painter.setBrush(QColor(0, 0, 0, ground));
    painter.drawRect(inset);
    const QRectF plot = inset.adjusted(inside, inside, -inside, -inside);
    if (face.otf->isTwoDimensional()) {
        InsetMap once;
        InsetMap& map = kept != nullptr ? *kept : once;
        keepMapOf(face.otf->twoDimensional(), plot.size().toSize(), map);
        painter.drawImage(plot, map.image);
    } else {
        const bool own = face.frame && !face.coloured;
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(own ? *face.frame : colours.text, std::max(1.5, inset.width() / 80.0),
                            own ? face.frameStyle : Qt::SolidLine));
        painter.drawPolyline(lineOf(face.otf->curve(), plot));
    }
    painter.restore();
}

void paintFace(QPainter& painter, const QRect& pane, const PaneFace& face, const CaptionLayout& caption,
               InsetMap* kept) {
    const QRect picture = pictureIn(pane, caption);
    const ThemeColours& colours = coloursOverPictures();
    painter.save();
    paintInset(painter, insetIn(picture), face, kept);
    painter.setFont(caption.font);
    const int room = roomIn(pane.width());
    const QRect texts(pane.left() + padding + margin, picture.bottom() + 1 + padding, room,
                      caption.height - 2 * padding);
    const int name = std::max(painter.fontMetrics().height(), heightOf(face.name, room, painter.fontMetrics()));
    painter.setPen(colours.text);
    painter.drawText(texts, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, face.name);
    const QRect below = texts.adjusted(0, name, 0, 0);
    if (!face.legend.empty()) {
        paintLegend(painter, below, face.legend);
    } else {
        painter.setPen(colours.secondary);
        painter.drawText(below, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, wrapping(face.numbers));
    }
    if (face.frame || face.coloured) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(face.coloured ? QPen(colours.line, margin) : QPen(*face.frame, margin, face.frameStyle));
        painter.drawRect(pane.adjusted(1, 1, -1, -1));
    }
    painter.restore();
}

}  // namespace echolucent
