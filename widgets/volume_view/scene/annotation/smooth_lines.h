// Draws straight lines and discs with smooth edges over the picture. OpenGL draws them jagged without multisampling.
#pragma once

#include <vtkNew.h>

#include <vector>

#include "processing/picture/annotation_layout.h"
#include "widgets/volume_view/scene/annotation/overlay.h"

class vtkActor2D;
class vtkCellArray;
class vtkPoints;
class vtkPolyData;
class vtkPolyDataMapper2D;
class vtkUnsignedCharArray;

namespace echolucent {

/// Shapes in viewport pixels (x right, y up, from the lower left corner), drawn in the order they were added. Lines
/// beside the viewport take no time, and a line to or from a place that is not finite is not drawn.
class SmoothLines {
public:
    SmoothLines();
    ~SmoothLines();
    [[nodiscard]] vtkActor2D* actor() { return m_actor.Get(); }

    void clear();
    /// The size of the viewport, pixels, for the lines that follow.
    void setViewport(int width, int height);
    /// The number of dashes, lines and rims that lie in the viewport.
    [[nodiscard]] long long bandCount() const { return m_bands; }
    /// A line with a dark rim, so that it shows over bright tissue too. Widths in pixels.
    void addLine(const Point2& from, const Point2& to, double width, const Colour& colour);
    /// A line as addLine() draws it, through two or more points. No rim covers a piece of the line.
    void addPath(const std::vector<Point2>& points, double width, const Colour& colour);
    /// A path of dashes. Its rim has no gaps. Lengths in pixels, above 0.
    void addDashedPath(const std::vector<Point2>& points, double width, const Colour& colour, double dash, double gap);
    void addDisc(const Point2& centre, double radius, const Colour& colour);
    /// The shapes of a layout, without its texts.
    void addShapes(const AnnotationLayout& layout);

private:
    void addRim(const std::vector<Point2>& points, double width);
    void addDashes(const Point2& from, const Point2& to, double begun, double width, const Colour& colour, double dash,
                   double gap);
    void addBand(const Point2& from, const Point2& to, double width, const Colour& colour, double opacity);
    void addFeatheredDisc(const Point2& centre, double radius, const Colour& colour, double opacity);
    long long addPoint(const Point2& point, const Colour& colour, double opacity);

    double m_width = 16384.0, m_height = 16384.0;  ///< of the viewport
    long long m_bands = 0;
    vtkNew<vtkPoints> m_points;
    vtkNew<vtkUnsignedCharArray> m_colours;
    vtkNew<vtkCellArray> m_polygons;
    vtkNew<vtkPolyData> m_shapes;
    vtkNew<vtkPolyDataMapper2D> m_mapper;
    vtkNew<vtkActor2D> m_actor;
};

}  // namespace echolucent
