#include "widgets/otf_editor/curve_style.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <array>
#include <vector>

#include "widgets/controls/panel_controls.h"

namespace echolucent {

namespace {

struct CurveStyle {
    QString shortName;
    QString name;
    ColourOfThemes colour;
    double width;                // pixels, not active
    double activeWidth;          // pixels
    std::vector<double> dashes;  // pixels on and off in turn; none: the line is solid
};

const CurveStyle& styleOf(CurveKind kind) {
    const auto translated = [](const char* text) { return QCoreApplication::translate("CurveStyle", text); };
    static const ColourOfThemes accent{coloursOf(Theme::dark).accent, coloursOf(Theme::light).accent};
    static const ColourOfThemes amber{{0xe8, 0xb0, 0x4b}, {0x96, 0x64, 0x00}};
    static const ColourOfThemes grey{{0x9a, 0xa5, 0xb1}, {0x66, 0x71, 0x7d}};
    static const ColourOfThemes violet{{0xb4, 0x8e, 0xad}, {0x90, 0x5a, 0x8a}};
    static const ColourOfThemes green{{0x8f, 0xbc, 0x8f}, {0x3c, 0x7f, 0x3c}};
    static const std::array<CurveStyle, 5> styles{{
        {translated("Adaptive"), translated("adaptive"), accent, 2.4, 3.2, {}},
        {translated("Manual"), translated("manual"), amber, 1.4, 2.2, {}},
        {translated("Linear (eq. 1)"), translated("piecewise linear"), grey, 1.4, 2.2, {8, 5}},
        {translated("x²"), translated("parabolic"), violet, 1.6, 2.4, {2, 4}},
        {translated("x⁴"), translated("quartic"), green, 1.4, 2.2, {9, 4, 2, 4}},
    }};
    return styles.at(indexOf(kind));
}

constexpr std::array<double, 2> iconScales{1.0, 2.0};  // ordinary and high-density screens

QPixmap transparentPixmap(QSize size, double scale) {
    QPixmap pixmap(size * scale);
    pixmap.setDevicePixelRatio(scale);
    pixmap.fill(Qt::transparent);
    return pixmap;
}

QPixmap bentArrow(bool toTheLeft, const QColor& color, double scale) {
    QPixmap pixmap = transparentPixmap({16, 16}, scale);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!toTheLeft) {
        painter.translate(16, 0);
        painter.scale(-1, 1);
    }
    QPainterPath shaft(QPointF(3.5, 6.0));
    shaft.lineTo(9.5, 6.0);
    shaft.cubicTo(14.5, 6.0, 14.5, 13.0, 9.5, 13.0);
    shaft.lineTo(6.5, 13.0);
    painter.setPen(QPen(color, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(shaft);
    painter.drawPolyline(QPolygonF({QPointF(6.5, 2.8), QPointF(3.2, 6.0), QPointF(6.5, 9.2)}));
    return pixmap;
}

QPen penOf(const QColor& colour, double width, const std::vector<double>& dashes) {
    QPen pen(colour, width);
    pen.setJoinStyle(Qt::RoundJoin);
    pen.setCapStyle(Qt::FlatCap);
    if (!dashes.empty()) {
        QList<qreal> pattern;  // Qt counts dashes in pen widths
        for (const double length : dashes) pattern.push_back(length / pen.widthF());
        pen.setDashPattern(pattern);
    }
    return pen;
}

QIcon sampleOf(const QPen& pen, bool node) {
    QIcon icon;
    for (const double scale : iconScales) {
        QPixmap pixmap = transparentPixmap(curveSampleSize, scale);
        QPainter painter(&pixmap);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(pen);
        const QPointF middle = QRectF({}, QSizeF(curveSampleSize)).center();
        painter.drawLine(QPointF(0, middle.y()), QPointF(curveSampleSize.width(), middle.y()));
        if (node) paintNode(painter, middle, 7, pen.color(), pen.color());
        painter.end();
        icon.addPixmap(pixmap);
    }
    return icon;
}

}  // namespace

QString curveKey(CurveKind kind) { return textOf(nameOf(kind)); }
QString curveShortName(CurveKind kind) { return styleOf(kind).shortName; }
QString curveName(CurveKind kind) { return styleOf(kind).name; }
QColor curveColor(CurveKind kind, Theme theme) { return styleOf(kind).colour.in(theme); }

QPen curvePen(CurveKind kind, bool active, Theme theme) {
    const CurveStyle& style = styleOf(kind);
    return penOf(curveColor(kind, theme), active ? style.activeWidth : style.width, style.dashes);
}

QColor designColor(Theme theme) {
    static const ColourOfThemes coral{{0xf0, 0x86, 0x72}, {0xb5, 0x3f, 0x2b}};
    return coral.in(theme);
}

QPen designPen(Theme theme) { return penOf(designColor(theme), 3.0, {14, 3}); }

QIcon curveSample(CurveKind kind, Theme theme) {
    return sampleOf(curvePen(kind, true, theme), kind == CurveKind::manual);
}

QIcon designSample(Theme theme) { return sampleOf(designPen(theme), false); }

void paintNode(QPainter& painter, QPointF centre, double side, const QColor& fill, const QColor& outline) {
    painter.setPen(QPen(outline, 1.5));
    painter.setBrush(fill);
    painter.drawRect(QRectF(centre.x() - side / 2, centre.y() - side / 2, side, side));
}

QIcon bentArrowIcon(bool toTheLeft, const QColor& color, const QColor& disabledColor) {
    QIcon icon;
    for (const double scale : iconScales) {
        icon.addPixmap(bentArrow(toTheLeft, color, scale), QIcon::Normal);
        icon.addPixmap(bentArrow(toTheLeft, disabledColor, scale), QIcon::Disabled);
    }
    return icon;
}

}  // namespace echolucent
