#include "widgets/volume_view/scene/annotation/smooth_lines.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <numbers>

namespace echolucent {

namespace {
constexpr Colour black{0, 0, 0};
constexpr double rim = 1.0;  // pixels around a shape
constexpr double rimOpacity = 0.55;
constexpr double feather = 0.5;  // an edge fades over twice this, pixels
}  // namespace

SmoothLines::SmoothLines() {
    m_colours->SetNumberOfComponents(4);
    m_shapes->SetPoints(m_points);
    m_shapes->SetPolys(m_polygons);
    m_shapes->GetPointData()->SetScalars(m_colours);
    m_mapper->SetInputData(m_shapes);
    m_actor->SetMapper(m_mapper);
    m_actor->PickableOff();
}

SmoothLines::~SmoothLines() = default;

void SmoothLines::clear() {
    m_points->Reset();
    m_colours->Reset();
    m_polygons->Reset();
    m_points->Modified();
    m_colours->Modified();
    m_polygons->Modified();
    m_shapes->Modified();
}

void SmoothLines::addLine(const Point2& from, const Point2& to, double width, const Colour& colour) {
    addPath({from, to}, width, colour);
}

void SmoothLines::addPath(const std::vector<Point2>& points, double width, const Colour& colour) {
    addRim(points, width);
    for (std::size_t i = 1; i < points.size(); ++i) addBand(points[i - 1], points[i], width, colour, 1.0);
}

void SmoothLines::addDashedPath(const std::vector<Point2>& points, double width, const Colour& colour, double dash,
                                double gap) {
    addRim(points, width);
    double done = 0.0;  // of the dash and the gap that the path is in
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Point2 along = points[i] - points[i - 1];
        const double size = cv::norm(along);
        for (double at = 0.0; at < size;) {
            const bool drawn = done < dash;
            const double next = std::min(size, at + (drawn ? dash : dash + gap) - done);
            if (drawn)
                addBand(points[i - 1] + along * (at / size), points[i - 1] + along * (next / size), width, colour, 1.0);
            done += next - at;
            // The remainder of a subtraction must not become a dash without length that never ends.
            if (next < size) done = drawn ? dash : 0.0;
            at = next;
        }
    }
}

void SmoothLines::addRim(const std::vector<Point2>& points, double width) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Point2 along = points[i] - points[i - 1];
        const Point2 end = along * (rim / std::max(cv::norm(along), 1e-9));
        addBand(points[i - 1] - end, points[i] + end, width + 2 * rim, black, rimOpacity);
    }
}

void SmoothLines::addDisc(const Point2& centre, double radius, const Colour& colour) {
    addFeatheredDisc(centre, radius + rim, black, rimOpacity);
    addFeatheredDisc(centre, radius, colour, 1.0);
}

void SmoothLines::addShapes(const AnnotationLayout& layout) {
    for (const auto& shape : layout.shapes) {
        if (const auto* line = std::get_if<AnnotationLine>(&shape))
            addLine(line->from, line->to, line->width, line->colour);
        if (const auto* disc = std::get_if<AnnotationDisc>(&shape)) addDisc(disc->centre, disc->radius, disc->colour);
    }
}

long long SmoothLines::addPoint(const Point2& point, const Colour& colour, double opacity) {
    m_colours->InsertNextTuple4(colour[0], colour[1], colour[2], std::lround(255 * opacity));
    return m_points->InsertNextPoint(point[0], point[1], 0.0);
}

void SmoothLines::addBand(const Point2& from, const Point2& to, double width, const Colour& colour, double opacity) {
    const Point2 along = to - from;
    const double size = cv::norm(along);
    if (size < 1e-9) return;
    const Point2 across = Point2{-along[1], along[0]} * (1.0 / size);
    // Across the band: transparent, full, full, transparent.
    const std::array<double, 4> offsets{-width / 2 - feather, -width / 2 + feather, width / 2 - feather,
                                        width / 2 + feather};
    const std::array<double, 4> opacities{0.0, opacity, opacity, 0.0};
    std::array<std::array<vtkIdType, 2>, 4> rows{};
    for (std::size_t i = 0; i < 4; ++i) {
        rows[i] = {addPoint(from + across * offsets[i], colour, opacities[i]),
                   addPoint(to + across * offsets[i], colour, opacities[i])};
    }
    for (std::size_t i = 0; i + 1 < 4; ++i) {
        m_polygons->InsertNextCell({rows[i][0], rows[i][1], rows[i + 1][1], rows[i + 1][0]});
    }
}

void SmoothLines::addFeatheredDisc(const Point2& centre, double radius, const Colour& colour, double opacity) {
    constexpr int corners = 24;
    const vtkIdType middle = addPoint(centre, colour, opacity);
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        const Point2 outwards{std::cos(angle), std::sin(angle)};
        addPoint(centre + outwards * (radius - feather), colour, opacity);
        addPoint(centre + outwards * (radius + feather), colour, 0.0);
    }
    for (int i = 0; i < corners; ++i) {
        const vtkIdType inner = middle + 1 + 2 * i, nextInner = middle + 1 + 2 * ((i + 1) % corners);
        m_polygons->InsertNextCell({middle, inner, nextInner});
        m_polygons->InsertNextCell({inner, inner + 1, nextInner + 1, nextInner});
    }
}

}  // namespace echolucent
