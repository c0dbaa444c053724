#include "widgets/controls/tool_icons.h"

#include <QApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>

#include "widgets/theme_colours.h"

namespace echolucent {

namespace {

constexpr double side = 24.0;  ///< of the square in which all pictures are drawn

/// What a picture is made of: lines, and areas in the accent.
struct Drawing {
    QPainterPath lines, areas;
};

QPainterPath polygon(const QPolygonF& corners) {
    QPainterPath path;
    path.addPolygon(corners);
    path.closeSubpath();
    return path;
}

QPainterPath polyline(const QPolygonF& corners) {
    QPainterPath path;
    path.addPolygon(corners);
    return path;
}

/// An open folder.
Drawing openDrawing() {
    Drawing drawing;
    drawing.lines = polyline({{20, 9.5}, {20, 7.5}, {11.5, 7.5}, {9.5, 5}, {3, 5}, {3, 19}, {18, 19}});
    drawing.areas = polygon({{6.5, 10.5}, {22, 10.5}, {18.5, 19}, {3, 19}});
    drawing.lines.addPath(drawing.areas);
    return drawing;
}

/// A cube with one side chosen.
Drawing sidesDrawing() {
    Drawing drawing;
    drawing.areas = polygon({{3.5, 7.5}, {12, 12}, {12, 21.5}, {3.5, 17}});
    drawing.lines = drawing.areas;
    drawing.lines.addPath(polygon({{3.5, 7.5}, {12, 3}, {20.5, 7.5}, {12, 12}}));
    drawing.lines.addPath(polyline({{20.5, 7.5}, {20.5, 17}, {12, 21.5}}));
    return drawing;
}

/// Four panes; one is the 3D view.
Drawing layoutDrawing() {
    Drawing drawing;
    drawing.areas.addRect(12, 12, 9, 8);
    drawing.lines.addRoundedRect(3, 4, 18, 16, 1.5, 1.5);
    drawing.lines.addPath(polyline({{12, 4}, {12, 20}}));
    drawing.lines.addPath(polyline({{3, 12}, {21, 12}}));
    return drawing;
}

/// A frame with its handles.
Drawing boxDrawing() {
    Drawing drawing;
    drawing.lines.addRect(5, 5, 14, 14);
    for (const QPointF& corner : {QPointF(5, 5), QPointF(19, 5), QPointF(5, 19), QPointF(19, 19)})
        drawing.areas.addRect(corner.x() - 2.2, corner.y() - 2.2, 4.4, 4.4);
    return drawing;
}

/// A surface; what lay before it is gone, the rest stays.
Drawing frontDrawing() {
    Drawing drawing;
    QPainterPath rest;
    rest.moveTo(3.5, 11.5);
    rest.lineTo(20.5, 11.5);
    rest.arcTo(3.5, 3, 17, 17, 0, -180);
    rest.closeSubpath();
    drawing.areas = rest;
    drawing.lines = polyline({{2, 11.5}, {22, 11.5}});
    drawing.lines.moveTo(12, 1.5);
    drawing.lines.lineTo(12, 8.5);
    drawing.lines.addPath(polyline({{9, 5.5}, {12, 8.5}, {15, 5.5}}));
    return drawing;
}

Drawing scalpelDrawing() {
    Drawing drawing;
    drawing.lines = polygon({{13, 12.5}, {19.5, 3}, {21.5, 4.5}, {15.2, 14}});
    drawing.areas = polygon({{13, 12.5}, {15.2, 14}, {3, 21.5}});
    drawing.lines.addPath(drawing.areas);
    return drawing;
}

/// A line between two marks, with its ends as calipers have them.
Drawing measureDrawing() {
    Drawing drawing;
    drawing.lines = polyline({{5, 19}, {19, 5}});
    for (const QPointF& end : {QPointF(5, 19), QPointF(19, 5)}) {
        drawing.lines.addPath(polyline({end + QPointF(-3, 0), end + QPointF(3, 0)}));
        drawing.lines.addPath(polyline({end + QPointF(0, -3), end + QPointF(0, 3)}));
    }
    drawing.areas.addEllipse(QPointF(12, 12), 2.2, 2.2);
    return drawing;
}

/// Opacity that rises from fluid to tissue.
Drawing curveDrawing() {
    Drawing drawing;
    drawing.lines = polyline({{3.5, 3}, {3.5, 20.5}, {21.5, 20.5}});
    QPainterPath rise;
    rise.moveTo(5, 18.5);
    rise.cubicTo(13.5, 18.5, 11, 6, 20.5, 6);
    drawing.lines.addPath(rise);
    drawing.areas.addRect(10.2, 10.4, 4.2, 4.2);
    return drawing;
}

/// Into a tray.
Drawing saveDrawing() {
    Drawing drawing;
    drawing.lines = polyline({{3.5, 14}, {3.5, 20.5}, {20.5, 20.5}, {20.5, 14}});
    drawing.lines.addPath(polyline({{12, 3}, {12, 10}}));
    drawing.areas = polygon({{7, 10}, {17, 10}, {12, 16}});
    drawing.lines.addPath(drawing.areas);
    return drawing;
}

/// Once around and back.
Drawing resetDrawing() {
    Drawing drawing;
    drawing.lines.arcMoveTo(4, 4.5, 16, 16, 60);
    drawing.lines.arcTo(4, 4.5, 16, 16, 60, -300);
    drawing.areas = polygon({{9.5, 1.5}, {9.5, 9.5}, {3.5, 5.5}});
    return drawing;
}

Drawing playDrawing() {
    Drawing drawing;
    drawing.areas = polygon({{6, 3}, {21, 12}, {6, 21}});
    return drawing;
}

Drawing pauseDrawing() {
    Drawing drawing;
    drawing.areas.addRect(5.5, 3.5, 4.5, 17);
    drawing.areas.addRect(14, 3.5, 4.5, 17);
    return drawing;
}

Drawing drawingOf(ToolPicture picture) {
    switch (picture) {
        case ToolPicture::open: return openDrawing();
        case ToolPicture::sides: return sidesDrawing();
        case ToolPicture::layout: return layoutDrawing();
        case ToolPicture::box: return boxDrawing();
        case ToolPicture::front: return frontDrawing();
        case ToolPicture::scalpel: return scalpelDrawing();
        case ToolPicture::measure: return measureDrawing();
        case ToolPicture::curve: return curveDrawing();
        case ToolPicture::save: return saveDrawing();
        case ToolPicture::reset: return resetDrawing();
        case ToolPicture::play: return playDrawing();
        case ToolPicture::pause: return pauseDrawing();
    }
    return {};
}

/// Paints anew whenever it is asked, so that nothing of another theme is kept.
class ToolIconEngine : public QIconEngine {
public:
    explicit ToolIconEngine(ToolPicture picture) : m_picture(picture) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        const ThemeColours& colours = coloursOf(QApplication::palette());
        const bool disabled = mode == QIcon::Disabled;
        const Drawing drawing = drawingOf(m_picture);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->translate(rect.topLeft());
        painter->scale(rect.width() / side, rect.height() / side);
        painter->fillPath(drawing.areas, disabled ? colours.lineDisabled : colours.accent);
        painter->setBrush(Qt::NoBrush);
        painter->setPen(
            QPen(disabled ? colours.disabled : colours.text, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter->drawPath(drawing.lines);
        painter->restore();
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, pixmap.rect(), mode, state);
        return pixmap;
    }
    [[nodiscard]] QIconEngine* clone() const override { return new ToolIconEngine(m_picture); }

private:
    ToolPicture m_picture;
};

}  // namespace

QIcon toolIcon(ToolPicture picture) { return QIcon(new ToolIconEngine(picture)); }

}  // namespace echolucent
