// How CurveCanvas draws: backdrop, grid, curves, nodes, guides.
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/controls/value_text.h"
#include "widgets/larger_letters.h"
#include "widgets/otf_editor/curve_canvas.h"
#include "widgets/otf_editor/curve_style.h"
#include "widgets/otf_editor/early_light_bars.h"
#include "widgets/surface_colours.h"

namespace echolucent {

namespace {

constexpr double nodeSide = 8.0;
constexpr double highlightedNodeSide = 11.0;
constexpr double haloWidth = 2.5;  // background colour around the active curve sets it off from the others

/// Enough decimals to tell neighbouring ticks apart.
QString tickText(double value, double step) {
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-6)), 1, 4);
    return QString::number(std::abs(value) < step / 2 ? 0.0 : value, 'f', decimals);
}

double stepOf(const std::vector<double>& ticks) { return ticks.size() > 1 ? ticks[1] - ticks[0] : 0.1; }

}  // namespace

void CurveCanvas::paintEvent(QPaintEvent*) {
    const PlotColours paints = plotColours(themeOf(palette()));
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().color(QPalette::Window));
    painter.fillRect(m_axes.rect, paints.background);
    painter.save();
    painter.setClipRect(m_axes.rect);
    paintHistogram(painter, m_axes, m_histogramHeights, paints.histogram, paints.histogramOutline);
    if (m_earlyLight) paintEarlyLight(painter, m_axes, *m_earlyLight, earlyLightColour(themeOf(palette())));
    painter.restore();
    paintAxes(painter, paints);
    paintCurves(painter, paints);
    paintLightHeldBack(painter, paints);
    paintGuides(painter, paints);
    paintNodes(painter, paints);
    if (hasFocus()) {
        painter.setPen(QPen(coloursOf(palette()).accent, 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void CurveCanvas::paintAxes(QPainter& painter, const PlotColours& colors) const {
    paintIntensityAxis(painter, colors);
    paintOpacityAxis(painter, colors);
    painter.setPen(QPen(colors.frame, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(m_axes.rect.adjusted(-0.5, -0.5, 0.5, 0.5));
}

void CurveCanvas::paintIntensityAxis(QPainter& painter, const PlotColours& colors) const {
    const QRectF& plot = m_axes.rect;
    const double rowHeight = painter.fontMetrics().height();
    const double cell = std::max<double>(painter.fontMetrics().horizontalAdvance("0.0000"), 2 * halfOfValues());
    const int maxTicks = std::max(3, static_cast<int>(plot.width() / (1.2 * cell)));
    const std::vector<double> ticks = tickPositions(m_axes.intensity, std::min(maxTicks, 6));
    for (const double tick : ticks) {
        const double x = m_axes.positionOf({tick, 0.0}).x();
        painter.setPen(QPen(colors.grid, 1.0));
        painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
        painter.setPen(QPen(colors.frame, 1.0));
        painter.drawLine(QPointF(x, plot.bottom()), QPointF(x, plot.bottom() + 3));
        const QRectF label(x - cell, plot.bottom() + 5, 2 * cell, rowHeight);
        painter.setPen(colors.text);
        painter.drawText(label, Qt::AlignHCenter, tickText(tick, stepOf(ticks)));
        if (m_values.isNormalised()) continue;
        painter.setPen(colors.secondary);
        painter.drawText(label.translated(0, rowHeight), Qt::AlignHCenter, valueText(m_values.valueAt(tick), m_values));
    }
    painter.setPen(colors.secondary);
    painter.drawText(plot.adjusted(0, 0, -6, -3), Qt::AlignRight | Qt::AlignBottom, tr("intensity"));
    if (!m_values.isNormalised())
        painter.drawText(QRectF(0, plot.bottom() + 5 + rowHeight, plot.left() - valueRowGap(), rowHeight),
                         Qt::AlignRight, tr("value"));
}

void CurveCanvas::paintOpacityAxis(QPainter& painter, const PlotColours& colors) const {
    const QRectF& plot = m_axes.rect;
    const double rowHeight = painter.fontMetrics().height();
    const int maxTicks = std::clamp(static_cast<int>(plot.height() / (1.6 * rowHeight)), 2, 6);
    const std::vector<double> ticks = tickPositions(m_axes.opacity, maxTicks);
    for (const double tick : ticks) {
        const double y = m_axes.positionOf({0.0, tick}).y();
        painter.setPen(QPen(colors.grid, 1.0));
        painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
        painter.setPen(QPen(colors.frame, 1.0));
        painter.drawLine(QPointF(plot.left() - 3, y), QPointF(plot.left(), y));
        painter.setPen(colors.text);
        painter.drawText(QRectF(0, y - rowHeight / 2, plot.left() - 6, rowHeight), Qt::AlignRight | Qt::AlignVCenter,
                         tickText(tick, stepOf(ticks)));
    }
    painter.save();
    painter.translate(0, plot.center().y());
    painter.rotate(-90);
    painter.setPen(colors.secondary);
    painter.drawText(QRectF(-plot.height() / 2, 0, plot.height(), rowHeight), Qt::AlignCenter, tr("opacity"));
    painter.restore();
}

void CurveCanvas::paintLightHeldBack(QPainter& painter, const PlotColours& colors) const {
    if (!m_earlyLight) return;
    const QString words = wordsOf(*m_earlyLight);
    constexpr int wrapped = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;  // a narrow plot takes two lines
    const QRectF place = painter.boundingRect(m_axes.rect.adjusted(6, 4, -6, -4), wrapped, words);
    painter.fillRect(place.adjusted(-3, -1, 3, 1), colors.background);  // curves pass below the words
    painter.setPen(colors.text);
    painter.drawText(place, wrapped, words);
}

QPen CurveCanvas::inLetters(QPen pen) const {
    pen.setWidthF(lettersOf(*this) * pen.widthF());
    return pen;
}

QPolygonF CurveCanvas::curvePolygon(CurveKind kind) const {
    QPolygonF polygon;
    if (kind == CurveKind::manual) {  // through its nodes exactly, steps included
        const auto& nodes = m_model.state().manual.nodes;
        if (nodes.empty()) return polygon;
        polygon << m_axes.positionOf({0.0, nodes.front().opacity});
        for (const CurveNode& node : nodes) polygon << m_axes.positionOf(node);
        polygon << m_axes.positionOf({1.0, nodes.back().opacity});
        return polygon;
    }
    return polygonOf(curveOf(m_model.state(), kind));
}

QPolygonF CurveCanvas::polygonOf(const OpacityCurve& curve) const {
    QPolygonF polygon;
    const int columns = static_cast<int>(std::ceil(m_axes.rect.width()));
    for (int i = 0; i <= columns; ++i) {
        const double x = std::min(m_axes.rect.left() + i, m_axes.rect.right());
        const double intensity = m_axes.valueAt({x, 0.0}).intensity;
        polygon << m_axes.positionOf({intensity, opacityAt(curve, intensity)});
    }
    return polygon;
}

void CurveCanvas::paintCurves(QPainter& painter, const PlotColours& colors) const {
    const OtfEditorState& state = m_model.state();
    painter.save();
    painter.setClipRect(m_axes.rect.adjusted(-1, -2, 1, 2));
    // The least important first; the active one lies on top.
    for (const CurveKind kind :
         {CurveKind::quartic, CurveKind::parabolic, CurveKind::linear, CurveKind::manual, CurveKind::adaptive})
        if (kind != state.active) paintCurve(painter, kind, colors);
    paintCurve(painter, state.active, colors);
    if (state.designed) paintDesign(painter, colors);
    painter.restore();
    if (state.designed) return;
    if (state.active == CurveKind::adaptive && state.adaptive.opacities.empty()) {
        painter.setPen(colors.secondary);
        painter.drawText(m_axes.rect.adjusted(8, 8, -8, -8), Qt::AlignHCenter | Qt::AlignTop,
                         tr("No adaptive curve yet"));
    }
}

void CurveCanvas::paintCurve(QPainter& painter, CurveKind kind, const PlotColours& colors) const {
    const OtfEditorState& state = m_model.state();
    if (!state.visible[indexOf(kind)]) return;
    if (kind == CurveKind::adaptive && state.adaptive.opacities.empty()) return;
    const bool active = kind == state.active && !state.designed;
    const bool isAdjusted = active && state.adjustment != CurveAdjustment{};
    const QPolygonF polygon = isAdjusted ? polygonOf(renderedCurve(state)) : curvePolygon(kind);
    const QPen pen = inLetters(curvePen(kind, active, themeOf(palette())));
    painter.setBrush(Qt::NoBrush);
    if (isAdjusted) {
        // Draw the curve before adjustment too, thin: a person edits its nodes.
        painter.setPen(inLetters(curvePen(kind, false, themeOf(palette()))));
        painter.drawPolyline(curvePolygon(kind));
    }
    if (active) {
        painter.setPen(QPen(colors.background, pen.widthF() + haloWidth, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
        painter.drawPolyline(polygon);
    }
    painter.setPen(pen);
    painter.drawPolyline(polygon);
}

/// Draws the designer's upper curve, adjusted. A person cannot edit it, so it has no nodes.
void CurveCanvas::paintDesign(QPainter& painter, const PlotColours& colors) const {
    const OtfEditorState& state = m_model.state();
    if (!state.designVisible || !state.design) return;
    const QPolygonF polygon = polygonOf(renderedCurve(state));
    const QPen pen = inLetters(designPen(themeOf(palette())));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colors.background, pen.widthF() + haloWidth, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter.drawPolyline(polygon);
    painter.setPen(pen);
    painter.drawPolyline(polygon);
}

void CurveCanvas::paintNodes(QPainter& painter, const PlotColours& colors) const {
    const OtfEditorState& state = m_model.state();
    if (!state.visible[indexOf(CurveKind::manual)]) return;
    const QRectF shown = m_axes.rect.adjusted(-1, -1, 1, 1);
    const QColor color = curveColor(CurveKind::manual, themeOf(palette()));
    const double letters = lettersOf(*this);
    for (int i = 0; i < static_cast<int>(state.manual.nodes.size()); ++i) {
        const QPointF centre = m_axes.positionOf(state.manual.nodes[static_cast<std::size_t>(i)]);
        if (!shown.contains(centre)) continue;
        const bool selected = i == m_model.selectedNode();
        const bool highlighted = selected || i == m_hoveredNode;
        paintNode(painter, centre, letters * (highlighted ? highlightedNodeSide : nodeSide),
                  selected ? color : colors.background, color);
        if (selected) paintNode(painter, centre, letters * (highlightedNodeSide + 5), Qt::transparent, colors.text);
    }
}

void CurveCanvas::paintGuides(QPainter& painter, const PlotColours& colors) const {
    const auto guideAt = [&](double intensity, const QColor& color, Qt::PenStyle style) {
        if (intensity < m_axes.intensity.lower || intensity > m_axes.intensity.upper) return;
        const QPointF onCurve = m_axes.positionOf({intensity, opacityAt(m_model.activeCurve(), intensity)});
        painter.setPen(QPen(color, 1.0, style));
        painter.drawLine(QPointF(onCurve.x(), m_axes.rect.top()), QPointF(onCurve.x(), m_axes.rect.bottom()));
        if (onCurve.y() < m_axes.rect.top() - 1 || onCurve.y() > m_axes.rect.bottom() + 1) return;
        painter.setPen(QPen(colors.text, 1.5));
        painter.setBrush(colors.background);
        painter.drawEllipse(onCurve, 3.5 * lettersOf(*this), 3.5 * lettersOf(*this));
    };
    if (m_cursorIntensity) guideAt(std::clamp(*m_cursorIntensity, 0.0, 1.0), colors.text, Qt::DashLine);
    if (m_pointer && m_hoveredNode < 0 && m_axes.rect.contains(*m_pointer))
        guideAt(m_axes.valueAt(*m_pointer).intensity, colors.frame, Qt::SolidLine);
}

}  // namespace echolucent
