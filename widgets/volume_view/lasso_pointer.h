// Takes what the hand draws over the 3D view with the scalpel.
#pragma once

#include <QObject>
#include <QPointF>
#include <vector>

#include "processing/picture/picture_place.h"
#include "processing/scalpel/scalpel_stroke.h"

class QMouseEvent;
class QWindow;

namespace echolucent {

/// While a tool is set, the left button draws. Freehand and eraser go from press to release, a box from corner to
/// corner. A polygon goes corner by corner; a double click or closePolygon() closes it. cancelDrawing() takes back what
/// is being drawn. All other events pass on, so that right and middle drags and the wheel still move the camera.
class LassoPointer : public QObject {
    Q_OBJECT

public:
    explicit LassoPointer(QWindow* window, QObject* parent = nullptr);

    /// No value puts the scalpel away: the left button then does what it does without a scalpel. An unfinished stroke
    /// is dropped.
    void setTool(std::optional<ScalpelTool> tool);
    [[nodiscard]] std::optional<ScalpelTool> tool() const { return m_tool; }
    [[nodiscard]] bool drawing() const { return m_drawing; }
    /// Drops an unfinished stroke; false if there is none.
    bool cancelDrawing();
    /// Closes a polygon of three corners or more; false if there is none.
    bool closePolygon();

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// Emitted even if the same tool was set again.
    void toolChanged();
    /// Places in the picture, in heights of the picture from its centre; empty if nothing is being drawn.
    void drawn(const std::vector<echolucent::PicturePlace>& places);
    /// A stroke is complete: an outline of three places or more, or the line of an eraser.
    void finished(const std::vector<echolucent::PicturePlace>& places);

private:
    [[nodiscard]] PicturePlace placeOf(const QPointF& pixel) const;
    bool press(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    bool release(const QMouseEvent& event);
    void add(const QPointF& pixel);
    void finish();

    QWindow* m_window;
    std::optional<ScalpelTool> m_tool;
    bool m_drawing = false;
    QPointF m_last;
    std::vector<PicturePlace> m_places;
};

}  // namespace echolucent
