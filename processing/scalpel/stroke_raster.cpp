#include "processing/scalpel/stroke_raster.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "processing/scalpel/outline.h"

namespace echolucent::scalpel {

namespace {

constexpr int margin = 4;  // cells around the stroke, so that the raster's rim is outside
constexpr int bucketEdge = 8, buckets = StrokeRaster::edge / bucketEdge;

/// An interval on an axis of the picture; empty until something is added.
struct Interval {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

/// The part of a row at `y` within a distance of the line from a to b. The surroundings of a line are convex, so its
/// ends and sides bound the part.
Interval rowWithin(double distance, const PicturePlace& a, const PicturePlace& b, double y) {
    Interval row;
    if (!(distance > 0.0)) return row;
    for (const PicturePlace& end : {a, b}) {
        const double squared = distance * distance - (y - end[1]) * (y - end[1]);
        if (squared < 0.0) continue;
        row.add(end[0] - std::sqrt(squared));
        row.add(end[0] + std::sqrt(squared));
    }
    const double along[] = {b[0] - a[0], b[1] - a[1]}, length = std::hypot(along[0], along[1]);
    if (!(length > 0.0) || along[1] == 0.0) return row;
    for (const double side : {-distance, distance}) {
        const double shiftedX = a[0] - along[1] / length * side, shiftedY = a[1] + along[0] / length * side;
        const double share = (y - shiftedY) / along[1];
        if (share >= 0.0 && share <= 1.0) row.add(shiftedX + share * along[0]);
    }
    return row;
}

}  // namespace

StrokeRaster::StrokeRaster(const ScalpelStroke& stroke)
    : m_stroke(stroke), m_cells(static_cast<std::size_t>(edge) * edge, outside) {
    place();
    if (stroke.tool == ScalpelTool::eraser) {
        fillEraser();
        fillBuckets();
    } else {
        m_bands.resize(edge);
        fillOutline();
    }
    findAlike();
}

/// Around each square of cells, a larger square of like squares grows until it meets a square that differs.
void StrokeRaster::findAlike() {
    constexpr std::size_t count = static_cast<std::size_t>(blocks) * blocks;
    m_blockCells.resize(count);
    std::vector<int> rings(count, 0);  // how many rings of squares around are alike, itself the first
    for (int row = 0; row < blocks; ++row)
        for (int column = 0; column < blocks; ++column) {
            const Cell* first =
                m_cells.data() + static_cast<std::ptrdiff_t>(row) * blockEdge * edge + column * blockEdge;
            bool alike = *first != mixed;
            for (int y = 0; y < blockEdge && alike; ++y)
                alike = std::all_of(first + static_cast<std::ptrdiff_t>(y) * edge,
                                    first + static_cast<std::ptrdiff_t>(y) * edge + blockEdge,
                                    [&](Cell cell) { return cell == *first; });
            const auto at = static_cast<std::size_t>(row * blocks + column);
            m_blockCells[at] = alike ? *first : mixed;
            rings[at] = alike ? 1 : 0;
        }
    // Beyond the raster's rim everything is as at the rim.
    const auto at = [](int row, int column) {
        return static_cast<std::size_t>(std::clamp(row, 0, blocks - 1) * blocks + std::clamp(column, 0, blocks - 1));
    };
    constexpr int mostRings = 16;
    for (int ring = 1; ring < mostRings; ++ring) {
        std::vector<int> wider = rings;
        for (int row = 0; row < blocks; ++row)
            for (int column = 0; column < blocks; ++column) {
                if (rings[at(row, column)] != ring) continue;
                bool alike = true;
                for (int y = row - 1; y <= row + 1; ++y)
                    for (int x = column - 1; x <= column + 1; ++x)
                        alike =
                            alike && rings[at(y, x)] >= ring && m_blockCells[at(y, x)] == m_blockCells[at(row, column)];
                if (alike) wider[at(row, column)] = ring + 1;
            }
        rings = std::move(wider);
    }
    m_alike.resize(count);
    std::ranges::transform(rings, m_alike.begin(), [](int alike) { return std::max(alike - 1, 0) * blockEdge; });
}

void StrokeRaster::place() {
    for (std::size_t axis = 0; axis < 2; ++axis) {
        Interval extent;
        for (const PicturePlace& place : m_stroke.places) {
            extent.add(place[axis] - m_stroke.radius);
            extent.add(place[axis] + m_stroke.radius);
        }
        // A line without extent needs cells of some size too.
        const double least = 1e-6 * (1.0 + std::max(std::abs(extent.low), std::abs(extent.high)));
        const double cell = std::max(extent.high - extent.low, least) / (edge - 2 * margin);
        m_toCells.first[axis] = extent.low - margin * cell;
        m_toCells.perHeight[axis] = 1.0 / cell;
    }
}

double StrokeRaster::centreOf(int cell, int axis) const {
    const auto i = static_cast<std::size_t>(axis);
    return m_toCells.first[i] + (cell + 0.5) / m_toCells.perHeight[i];
}

namespace {

int clampedCell(double cells) { return static_cast<int>(std::clamp(cells, 0.0, StrokeRaster::edge - 1.0)); }

}  // namespace

/// Marks the cells on a line and their neighbours.
void StrokeRaster::markLine(const PicturePlace& a, const PicturePlace& b) {
    const auto inCells = [&](const PicturePlace& place, std::size_t axis) {
        return (place[axis] - m_toCells.first[axis]) * m_toCells.perHeight[axis];
    };
    const double ax = inCells(a, 0), ay = inCells(a, 1), bx = inCells(b, 0), by = inCells(b, 1);
    const double top = std::min(ay, by), bottom = std::max(ay, by);
    for (int row = clampedCell(top - 1.0); row <= clampedCell(bottom + 1.0); ++row) {
        // The part of the line from a cell above the row to one below it.
        Interval across;
        for (const double y : {std::clamp(row - 1.0, top, bottom), std::clamp(row + 2.0, top, bottom)}) {
            if (bottom - top < 1e-9) {
                across.add(ax);
                across.add(bx);
            } else {
                across.add(ax + (bx - ax) * std::clamp((y - ay) / (by - ay), 0.0, 1.0));
            }
        }
        Cell* cells = m_cells.data() + static_cast<std::ptrdiff_t>(row) * edge;
        std::fill(cells + clampedCell(across.low - 1.0), cells + clampedCell(across.high + 1.0) + 1, mixed);
    }
}

void StrokeRaster::fillOutline() {
    const auto& places = m_stroke.places;
    for (std::size_t i = 0, before = places.size() - 1; i < places.size(); before = i++) {
        markLine(places[before], places[i]);
        const std::size_t first = bandOf(places[before]), last = bandOf(places[i]);
        // One more band on both sides, for rounding.
        for (std::size_t band = std::max<std::size_t>(std::min(first, last), 1) - 1;
             band < std::min<std::size_t>(std::max(first, last) + 2, edge); ++band)
            m_bands[band].push_back(static_cast<std::uint32_t>(i));
    }
    for (int row = 0; row < edge; ++row) {
        Cell* cells = m_cells.data() + static_cast<std::ptrdiff_t>(row) * edge;
        const double y = centreOf(row, 1);
        // Where the outline crosses the middle of the row. An untouched cell is inside if an odd number of crossings
        // lies before it.
        std::vector<double> crossings;
        for (const std::uint32_t i : m_bands[static_cast<std::size_t>(row)]) {
            const PicturePlace &a = places[i > 0 ? i - 1 : places.size() - 1], &b = places[i];
            if ((a[1] > y) != (b[1] > y)) crossings.push_back(a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]));
        }
        std::ranges::sort(crossings);
        std::size_t passed = 0;
        for (int column = 0; column < edge; ++column) {
            while (passed < crossings.size() && crossings[passed] <= centreOf(column, 0)) ++passed;
            if (cells[column] != mixed && passed % 2 == 1) cells[column] = inside;
        }
    }
}

void StrokeRaster::fillEraser() {
    const double cell = std::max(1.0 / m_toCells.perHeight[0], 1.0 / m_toCells.perHeight[1]);
    // Half a diagonal reaches to a cell's corner. Add half a cell for places beside the cell, and the thinned part.
    const double thinned = 0.25 * cell, slack = 1.5 * cell + thinned;
    std::vector<PicturePlace> line{m_stroke.places.front()};
    for (const PicturePlace& place : m_stroke.places)
        if (std::hypot(place[0] - line.back()[0], place[1] - line.back()[1]) >= thinned) line.push_back(place);
    line.push_back(m_stroke.places.back());
    // For each cell of a row, the number of pieces that begin there less the number that end before it.
    std::vector<int> within(edge + 1), near(edge + 1);
    for (int row = 0; row < edge; ++row) {
        std::ranges::fill(within, 0);
        std::ranges::fill(near, 0);
        const double y = centreOf(row, 1);
        const auto add = [&](const Interval& part, std::vector<int>& counts) {
            const auto column = [&](double x) { return (x - m_toCells.first[0]) * m_toCells.perHeight[0] - 0.5; };
            const double first = std::ceil(column(part.low)), last = std::floor(column(part.high));
            if (!(first <= last)) return;
            ++counts[static_cast<std::size_t>(clampedCell(first))];
            --counts[static_cast<std::size_t>(clampedCell(last)) + 1];
        };
        for (std::size_t i = 1; i < line.size(); ++i) {
            const PicturePlace &a = line[i - 1], &b = line[i];
            const double reach = m_stroke.radius + slack;
            if (y < std::min(a[1], b[1]) - reach || y > std::max(a[1], b[1]) + reach) continue;
            add(rowWithin(m_stroke.radius - slack, a, b, y), within);
            add(rowWithin(reach, a, b, y), near);
        }
        Cell* cells = m_cells.data() + static_cast<std::ptrdiff_t>(row) * edge;
        int isWithin = 0, isNear = 0;
        for (int column = 0; column < edge; ++column) {
            isWithin += within[static_cast<std::size_t>(column)];
            isNear += near[static_cast<std::size_t>(column)];
            cells[column] = isWithin > 0 ? inside : isNear > 0 ? mixed : outside;
        }
    }
}

/// Collects the pieces near each square of cells that has a mixed cell.
void StrokeRaster::fillBuckets() {
    m_bands.resize(static_cast<std::size_t>(buckets) * buckets);
    const double halfDiagonal =
        0.5 * bucketEdge * std::hypot(1.0 / m_toCells.perHeight[0], 1.0 / m_toCells.perHeight[1]);
    for (int row = 0; row < buckets; ++row)
        for (int column = 0; column < buckets; ++column) {
            // Also look one cell around the square, since a place may lie on the border between two squares.
            const int left = std::max(column * bucketEdge - 1, 0),
                      right = std::min((column + 1) * bucketEdge + 1, edge);
            const int top = std::max(row * bucketEdge - 1, 0), bottom = std::min((row + 1) * bucketEdge + 1, edge);
            bool any = false;
            for (int y = top; y < bottom && !any; ++y) {
                const Cell* cells = m_cells.data() + static_cast<std::ptrdiff_t>(y) * edge;
                any = std::find(cells + left, cells + right, mixed) != cells + right;
            }
            if (!any) continue;
            const PicturePlace centre{m_toCells.first[0] + (column + 0.5) * bucketEdge / m_toCells.perHeight[0],
                                      m_toCells.first[1] + (row + 0.5) * bucketEdge / m_toCells.perHeight[1]};
            auto& band = m_bands[static_cast<std::size_t>(row) * buckets + static_cast<std::size_t>(column)];
            for (std::size_t i = 0; i < m_stroke.places.size(); ++i)
                if (liesWithin(m_stroke.radius + 1.25 * halfDiagonal, m_stroke.places[i > 0 ? i - 1 : 0],
                               m_stroke.places[i], centre))
                    band.push_back(static_cast<std::uint32_t>(i));
        }
}

std::size_t StrokeRaster::bandOf(const PicturePlace& place) const {
    const int row = clampedCell((place[1] - m_toCells.first[1]) * m_toCells.perHeight[1]);
    if (m_stroke.tool != ScalpelTool::eraser) return static_cast<std::size_t>(row);
    const int column = clampedCell((place[0] - m_toCells.first[0]) * m_toCells.perHeight[0]);
    return static_cast<std::size_t>(row / bucketEdge) * buckets + static_cast<std::size_t>(column / bucketEdge);
}

bool StrokeRaster::holds(const PicturePlace& place) const {
    const Cell cell = at((place[0] - m_toCells.first[0]) * m_toCells.perHeight[0],
                         (place[1] - m_toCells.first[1]) * m_toCells.perHeight[1]);
    if (cell != mixed) return cell == inside;
    const auto& places = m_stroke.places;
    const auto& band = m_bands[bandOf(place)];
    if (m_stroke.tool == ScalpelTool::eraser)
        return std::ranges::any_of(band, [&](std::uint32_t i) {
            return liesWithin(m_stroke.radius, places[i > 0 ? i - 1 : 0], places[i], place);
        });
    bool within = false;
    for (const std::uint32_t i : band)
        if (crosses(places[i > 0 ? i - 1 : places.size() - 1], places[i], place)) within = !within;
    return within;
}

}  // namespace echolucent::scalpel
