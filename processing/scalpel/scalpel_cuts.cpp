#include "processing/scalpel/scalpel_cuts.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "processing/parallel.h"
#include "processing/picture/picture_place.h"
#include "processing/scalpel/stroke_raster.h"

namespace echolucent {

namespace {

using scalpel::StrokeRaster;

constexpr std::size_t sharedNumber = 255;

std::uint8_t numberOf(std::size_t stroke) { return static_cast<std::uint8_t>(std::min(stroke + 1, sharedNumber)); }

/// A value that changes evenly along a row of voxels.
struct Along {
    double first, perVoxel;
    [[nodiscard]] double at(double x) const { return first + perVoxel * x; }
};
Along operator-(const Along& a, const Along& b) { return {a.first - b.first, a.perVoxel - b.perVoxel}; }
Along operator*(const Along& a, double factor) { return {a.first * factor, a.perVoxel * factor}; }

/// Voxels [first, last) of a row.
struct Part {
    std::int64_t first, last;
};

/// The part of voxels [0, count) at which a value is above a limit, less `inside` voxels where it crosses the limit.
Part partAbove(const Along& value, double limit, double inside, std::int64_t count) {
    const auto whole = [&](double x) {
        return static_cast<std::int64_t>(std::clamp(x, 0.0, static_cast<double>(count)));
    };
    if (value.perVoxel == 0.0) return {0, value.first > limit ? count : 0};
    const double crossing = (limit - value.first) / value.perVoxel;
    if (value.perVoxel > 0.0) return {whole(std::ceil(crossing) + inside), count};
    return {0, whole(std::floor(crossing) + 1.0 - inside)};
}

Part common(const Part& a, const Part& b) {
    const std::int64_t first = std::max(a.first, b.first);
    return {first, std::max(first, std::min(a.last, b.last))};
}

/// Says which voxels of a row a stroke cuts. Where a stroke's raster says it for sure it is looked up there, many
/// voxels at once; where a voxel's place may err too much for that, it is asked for exactly.
class RowCutter {
public:
    RowCutter(const VolumeGeometry& geometry, const ScalpelStroke& stroke, const StrokeRaster& raster)
        : m_geometry(geometry), m_stroke(stroke), m_raster(raster), m_cells(raster.toCells()) {
        const Camera& camera = stroke.camera;
        m_parallel = camera.projection == Projection::parallel;
        m_heightPerMm = 2.0 * std::tan(camera.viewAngleDegrees / 2.0 * std::numbers::pi / 180.0);
        m_eyeDepth = camera.frame.forward.dot(camera.focalPoint) - camera.distanceMm;
        const double reach = std::max({length(geometry.boxMinMm()), length(geometry.boxMaxMm()),
                                       length(camera.focalPoint), m_parallel ? 0.0 : camera.distanceMm});
        const double cells = std::max(m_cells.perHeight[0], m_cells.perHeight[1]);
        // Nearer to the eye than this, or nearer to the depth at which a stroke ends, voxels are asked for exactly:
        // floats hold sums of lengths up to `reach` to about 2^-22 of it, and a place must not err by half a cell.
        m_leastHeight = reach * std::max(5e-6 * cells, m_parallel ? 0.0 : 5e-3 * m_heightPerMm);
        m_depthError = 1e-9 * reach;
        const double first = std::max(std::abs(m_cells.first[0]), std::abs(m_cells.first[1]));
        m_sure = 1e-6 * cells * first < 0.1 && !(m_parallel && camera.heightMm < m_leastHeight);
    }

    /// Writes `number` into a row of first cuts wherever the stroke cuts a voxel that holds 0. `places` is room for a
    /// row.
    void cutRow(std::int64_t y, std::int64_t z, std::uint8_t number, std::uint8_t* row,
                std::vector<std::int32_t>& places) const {
        const Camera& camera = m_stroke.camera;
        const std::int64_t count = m_geometry.size[0];
        const Vec3 start = m_geometry.gridMmFromVoxel({0.0, static_cast<double>(y), static_cast<double>(z)});
        const auto along = [&](const Vec3& direction, const Vec3& from) {
            return Along{direction.dot(start - from), direction[0] * m_geometry.spacing[0]};
        };
        const Along depth = along(camera.frame.forward, {0, 0, 0});
        const Along height =
            m_parallel ? Along{camera.heightMm, 0.0} : Along{depth.first - m_eyeDepth, depth.perVoxel} * m_heightPerMm;
        Part sure{0, m_sure ? count : 0}, asked{0, count};
        if (!m_parallel) {
            sure = common(sure, partAbove(height, m_leastHeight, 1.0, count));
            asked = partAbove(height, -m_leastHeight, -1.0, count);
        }
        if (m_stroke.depthMm) {
            const Along before = Along{*m_stroke.depthMm, 0.0} - depth;
            sure = common(sure, partAbove(before, m_depthError, 1.0, count));
            asked = common(asked, partAbove(before, -m_depthError, -1.0, count));
        }
        sure = common(sure, asked);
        lookUp(sure, along(camera.frame.right, camera.focalPoint), along(camera.frame.down, camera.focalPoint), height,
               places);
        const auto exactly = [&](std::int64_t x) {
            if (row[x] == 0 && cutsExactly(m_geometry.gridMmFromVoxel(
                                   {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)})))
                row[x] = number;
        };
        for (std::int64_t x = asked.first; x < sure.first; ++x) exactly(x);
        const StrokeRaster::Cell cut =
            m_stroke.side == ScalpelSide::inside ? StrokeRaster::inside : StrokeRaster::outside;
        for (std::int64_t x = sure.first; x < sure.last; ++x) {
            const StrokeRaster::Cell cell = m_raster.cells()[places[static_cast<std::size_t>(x)]];
            if (cell == cut)
                row[x] = row[x] != 0 ? row[x] : number;
            else if (cell == StrokeRaster::mixed)
                exactly(x);
        }
        for (std::int64_t x = std::max(sure.last, asked.first); x < asked.last; ++x) exactly(x);
    }

private:
    /// The raster's cells of a part of a row; right, down and height in mm.
    void lookUp(const Part& part, const Along& right, const Along& down, const Along& height,
                std::vector<std::int32_t>& places) const {
        const auto inCells = [&](const Along& across, std::size_t axis) {
            return (across - height * m_cells.first[axis]) * m_cells.perHeight[axis];
        };
        const Along column = inCells(right, 0), line = inCells(down, 1);
        const auto columnFirst = static_cast<float>(column.at(static_cast<double>(part.first))),
                   columnStep = static_cast<float>(column.perVoxel),
                   lineFirst = static_cast<float>(line.at(static_cast<double>(part.first))),
                   lineStep = static_cast<float>(line.perVoxel),
                   heightFirst = static_cast<float>(height.at(static_cast<double>(part.first))),
                   heightStep = static_cast<float>(height.perVoxel);
        constexpr float last = StrokeRaster::edge - 1;
        std::int32_t* to = places.data() + part.first;
        const auto voxels = static_cast<std::int32_t>(part.last - part.first);
        for (std::int32_t i = 0; i < voxels; ++i) {
            const auto x = static_cast<float>(i);
            const float perHeight = 1.0f / (heightFirst + heightStep * x);
            const float across = (columnFirst + columnStep * x) * perHeight,
                        below = (lineFirst + lineStep * x) * perHeight;
            to[i] = static_cast<std::int32_t>(std::min(std::max(below, 0.0f), last)) * StrokeRaster::edge +
                    static_cast<std::int32_t>(std::min(std::max(across, 0.0f), last));
        }
    }

    /// cutsAway(), with the raster's help.
    [[nodiscard]] bool cutsExactly(const Vec3& gridMm) const {
        if (m_stroke.depthMm && m_stroke.camera.frame.forward.dot(gridMm) > *m_stroke.depthMm) return false;
        const auto place = placeInPicture(m_stroke.camera, gridMm);
        return place && m_raster.holds(*place) == (m_stroke.side == ScalpelSide::inside);
    }

    const VolumeGeometry& m_geometry;
    const ScalpelStroke& m_stroke;
    const StrokeRaster& m_raster;
    StrokeRaster::ToCells m_cells;
    double m_heightPerMm = 1.0, m_eyeDepth = 0.0, m_leastHeight = 0.0, m_depthError = 0.0;
    bool m_parallel = true, m_sure = false;
};

}  // namespace

ScalpelCuts::ScalpelCuts(const VolumeGeometry& geometry) : m_geometry(geometry) {}

/// Forgets what the strokes from one on cut; where strokes share its number, from the first of these on.
void ScalpelCuts::forgetFrom(std::size_t kept) {
    if (kept >= m_strokes.size()) return;
    kept = std::min(kept, sharedNumber - 1);
    m_strokes.resize(kept);
    parallelFor(tbb::blocked_range<std::size_t>(0, m_firstCut.size(), 1 << 16), [&](const auto& part) {
        for (std::size_t i = part.begin(); i < part.end(); ++i)
            m_firstCut[i] = m_firstCut[i] > kept ? std::uint8_t{0} : m_firstCut[i];
    });
}

bool ScalpelCuts::add(const ScalpelStroke& stroke, const Progress& progress) {
    if (const std::string problem = problemOf(stroke); !problem.empty())
        throw std::invalid_argument("ScalpelCuts: a stroke " + problem);
    if (m_firstCut.empty()) m_firstCut.resize(static_cast<std::size_t>(m_geometry.voxelCount()));
    const std::uint8_t number = numberOf(m_strokes.size());
    // What needs memory comes before the stroke counts as cut.
    m_strokes.reserve(m_strokes.size() + 1);
    const StrokeRaster raster(stroke);
    const RowCutter cutter(m_geometry, stroke, raster);
    m_strokes.push_back(stroke);
    ++m_passes;
    ProgressCount count(progress, static_cast<std::size_t>(m_geometry.size[2]));
    parallelFor(std::int64_t{0}, m_geometry.size[2], [&](std::int64_t z) {
        if (progress.cancelled()) return;
        std::vector<std::int32_t> places(static_cast<std::size_t>(m_geometry.size[0]));
        for (std::int64_t y = 0; y < m_geometry.size[1]; ++y)
            cutter.cutRow(y, z, number, m_firstCut.data() + m_geometry.offset(0, y, z), places);
        count.oneDone();
    });
    if (!progress.cancelled()) return true;
    forgetFrom(m_strokes.size() - 1);
    return false;
}

bool ScalpelCuts::follow(std::span<const ScalpelStroke> strokes, const Progress& progress) {
    const auto same = static_cast<std::size_t>(std::ranges::mismatch(strokes, m_strokes).in1 - strokes.begin());
    // Where the list only became shorter, what its end cut is told by the numbers, but for those that share one.
    if (same < strokes.size() || (same < m_strokes.size() && same >= sharedNumber)) forgetFrom(same);
    while (m_strokes.size() < strokes.size())
        if (progress.cancelled() || !add(strokes[m_strokes.size()], progress)) return false;
    return true;
}

std::optional<Volume> ScalpelCuts::cut(const Volume& scan, std::span<const ScalpelStroke> strokes,
                                       const Progress& progress) {
    if (scan.geometry().size != m_geometry.size) throw std::invalid_argument("ScalpelCuts: a volume of another size");
    if (strokes.empty()) return progress.cancelled() ? std::nullopt : std::optional(scan.withCut(nullptr));
    if (!follow(strokes, progress)) return std::nullopt;
    const std::uint8_t last = numberOf(strokes.size() - 1);
    const std::vector<std::uint8_t>& scanned = scan.scannedMask();
    auto mask = std::make_shared<std::vector<std::uint8_t>>(m_firstCut.size());
    parallelFor(tbb::blocked_range<std::size_t>(0, mask->size(), 1 << 16), [&](const auto& part) {
        const std::size_t count = part.end() - part.begin();
        const std::uint8_t* __restrict first = m_firstCut.data() + part.begin();
        std::uint8_t* __restrict marks = mask->data() + part.begin();
        // 0, which is cut by none, becomes the largest number.
        for (std::size_t i = 0; i < count; ++i) marks[i] = static_cast<std::uint8_t>(first[i] - 1) >= last ? 1 : 0;
        if (scanned.empty()) return;
        const std::uint8_t* __restrict held = scanned.data() + part.begin();
        for (std::size_t i = 0; i < count; ++i) marks[i] = marks[i] != 0 && held[i] != 0 ? 1 : 0;
    });
    return scan.withCut(std::move(mask));
}

}  // namespace echolucent
