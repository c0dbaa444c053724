#include "widgets/volume_view/scene/annotation/smooth_lines.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace echolucent {

namespace {
constexpr Colour black{0, 0, 0};
constexpr double rim = 1.0;  // pixels around a shape
constexpr double rimOpacity = 0.55;
constexpr double feather = 0.5;  // an edge fades over twice this, pixels
constexpr double margin = 64.0;  // pixels around the viewport, more than any width

/// A piece of a line.
struct Piece {
    Point2 from, to;
    double skipped;  ///< the length before it
};

double distance(const Point2& from, const Point2& to) { return std::hypot(to[0] - from[0], to[1] - from[1]); }

/// Moves an end that lies below `least` along an axis there. `sign` -1 mirrors the axis. False if nothing is left.
bool cutBelow(Point2& from, Point2& to, int axis, double least, double sign) {
    const double begins = sign * from[axis], ends = sign * to[axis];
    if (begins < least && ends < least) return false;
    if (begins >= least && ends >= least) return true;
    Point2& moved = begins < least ? from : to;
    moved = from + (to - from) * ((least - begins) / (ends - begins));
    moved[axis] = sign * least;  // exactly, however far the end was
    return true;
}

/// The piece that lies in the viewport and the margin around it.
std::optional<Piece> pieceIn(double width, double height, const Point2& from, const Point2& to) {
    for (const int axis : {0, 1})
        if (!std::isfinite(from[axis]) || !std::isfinite(to[axis])) return std::nullopt;
    Piece piece{from, to, 0.0};
    for (const int axis : {0, 1}) {
        const double most = (axis == 0 ? width : height) + margin;
        if (!cutBelow(piece.from, piece.to, axis, -margin, 1.0)) return std::nullopt;
        if (!cutBelow(piece.from, piece.to, axis, -most, -1.0)) return std::nullopt;
    }
    piece.skipped = distance(from, piece.from);
    return piece;
}
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

void SmoothLines::setViewport(int width, int height) {
    m_width = width;
    m_height = height;
}

void SmoothLines::clear() {
    m_bands = 0;
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
    for (std::size_t i = 1; i < points.size(); ++i)
        if (const auto piece = pieceIn(m_width, m_height, points[i - 1], points[i]))
            addBand(piece->from, piece->to, width, colour, 1.0);
}

void SmoothLines::addDashedPath(const std::vector<Point2>& points, double width, const Colour& colour, double dash,
                                double gap) {
    addRim(points, width);
    const double period = dash + gap;
    double before = 0.0;  // length of the path before the line
    for (std::size_t i = 1; i < points.size(); ++i) {
        const auto piece = pieceIn(m_width, m_height, points[i - 1], points[i]);
        if (piece)
            addDashes(piece->from, piece->to, std::fmod(before + piece->skipped, period), width, colour, dash, gap);
        const double size = distance(points[i - 1], points[i]);
        if (std::isfinite(size)) before = std::fmod(before + size, period);
    }
}

/// `begun`: how much of a dash and its gap lies before the line.
void SmoothLines::addDashes(const Point2& from, const Point2& to, double begun, double width, const Colour& colour,
                            double dash, double gap) {
    const double size = cv::norm(to - from);
    if (size < 1e-9) return;
    const Point2 along = (to - from) * (1.0 / size);
    const int dashes = static_cast<int>(std::ceil((size + begun) / (dash + gap)));
    for (int i = 0; i < dashes; ++i) {
        const double start = i * (dash + gap) - begun;
        const double first = std::max(0.0, start), last = std::min(size, start + dash);
        if (first < last) addBand(from + along * first, from + along * last, width, colour, 1.0);
    }
}

void SmoothLines::addRim(const std::vector<Point2>& points, double width) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        const auto piece = pieceIn(m_width, m_height, points[i - 1], points[i]);
        if (!piece) continue;
        const Point2 along = piece->to - piece->from;
        const Point2 end = along * (rim / std::max(cv::norm(along), 1e-9));
        addBand(piece->from - end, piece->to + end, width + 2 * rim, black, rimOpacity);
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
    ++m_bands;
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
