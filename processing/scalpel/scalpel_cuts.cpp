#include "processing/scalpel/scalpel_cuts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "processing/parallel.h"
#include "processing/picture/picture_place.h"
#include "processing/progress_count.h"
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

/// The part of voxels [0, count) at which a value is above a limit. At a crossing of the limit the part is `inside`
/// voxels shorter.
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

/// Finds which voxels of a row a stroke cuts. If the stroke's raster is sure, one look-up decides many voxels. If a
/// voxel's place may err too much for the raster, the exact test decides.
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
        // Voxels need the exact test if the picture is lower at them than m_leastHeight (near the eye), or if they lie
        // within m_depthError of the depth at which the stroke ends. Floats hold sums of lengths up to `reach` to about
        // 2^-22 of it, and a place must not err by half a cell.
        m_leastHeight = reach * std::max(5e-6 * cells, m_parallel ? 0.0 : 5e-3 * m_heightPerMm);
        m_depthError = 1e-9 * reach;
        const double first = std::max(std::abs(m_cells.first[0]), std::abs(m_cells.first[1]));
        m_sure = 1e-6 * cells * first < 0.1 && !(m_parallel && camera.heightMm < m_leastHeight);
    }

    /// Writes `number` into a row of first cuts at each voxel that the stroke cuts and that holds 0. Returns the
    /// changed part of the row; voxels beside it did not change. `places` is room for a row.
    RowPart cutRow(std::int64_t y, std::int64_t z, std::uint8_t number, std::uint8_t* row,
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
        RowPart changed;
        const auto joinChanged = [&](std::int64_t first, std::int64_t last) {
            changed = changed.joined({static_cast<std::int32_t>(first), static_cast<std::int32_t>(last)});
        };
        const auto exactly = [&](std::int64_t x) {
            if (row[x] == 0 && cutsExactly(m_geometry.gridMmFromVoxel(
                                   {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}))) {
                row[x] = number;
                joinChanged(x, x + 1);
            }
        };
        const auto wholly = [&](std::int64_t first, std::int64_t last) {
            std::uint8_t fresh = 0;
            for (std::int64_t x = first; x < last; ++x) {
                fresh |= row[x] == 0 ? std::uint8_t{1} : std::uint8_t{0};
                row[x] = row[x] != 0 ? row[x] : number;
            }
            if (fresh != 0) joinChanged(first, last);
        };
        const auto inCells = [&](const Vec3& direction, std::size_t axis) {
            return (along(direction, camera.focalPoint) - height * m_cells.first[axis]) * m_cells.perHeight[axis];
        };
        const Across across{inCells(camera.frame.right, 0), inCells(camera.frame.down, 1), height};
        Part near = inRaster(across, sure, count);
        if (near.first >= near.last) near = {sure.first, sure.first};
        const bool beside = m_stroke.side == ScalpelSide::outside;
        for (std::int64_t x = asked.first; x < sure.first; ++x) exactly(x);
        if (beside) wholly(sure.first, near.first);
        cutNear(across, near, places, wholly, exactly);
        if (beside) wholly(near.last, sure.last);
        for (std::int64_t x = std::max(sure.last, asked.first); x < asked.last; ++x) exactly(x);
        return changed;
    }

private:
    /// The places of a row of voxels in the raster, in cells: column / height and line / height.
    struct Across {
        Along column, line, height;
    };

    /// The voxels of a part that lie in the raster. Beyond its rim all is outside.
    static Part inRaster(const Across& across, Part part, std::int64_t count) {
        constexpr double rim = 1.0, farRim = StrokeRaster::edge - 2.0;
        for (const Along& cells : {across.column, across.line}) {
            part = common(part, partAbove(cells - across.height * rim, 0.0, 0.0, count));
            part = common(part, partAbove(across.height * farRim - cells, 0.0, 0.0, count));
        }
        return part;
    }

    /// Cuts voxels in the raster: many at once if all cells around them are the same, else each by its cell.
    template <typename Wholly, typename Exactly>
    void cutNear(const Across& across, const Part& near, std::vector<std::int32_t>& places, const Wholly& wholly,
                 const Exactly& exactly) const {
        if (near.first >= near.last) return;
        const double least = std::min(across.height.at(static_cast<double>(near.first)),
                                      across.height.at(static_cast<double>(near.last - 1)));
        // Upper limit of a place's way from one voxel to the next, cells.
        const double stride = 1e-3 + (std::max(std::abs(across.column.perVoxel), std::abs(across.line.perVoxel)) +
                                      StrokeRaster::edge * std::abs(across.height.perVoxel)) /
                                         least;
        const StrokeRaster::Cell cut =
            m_stroke.side == ScalpelSide::inside ? StrokeRaster::inside : StrokeRaster::outside;
        // Divide before the loop, since divisions would be most of the work.
        const double voxelsPerCell = 1.0 / stride, perLeast = 1.0 / least;
        constexpr std::int64_t chunk = 8;
        for (std::int64_t x = near.first; x < near.last;) {
            const auto at = static_cast<double>(x);
            const double perHeight = m_parallel ? perLeast : 1.0 / across.height.at(at);
            const StrokeRaster::Stretch stretch =
                m_raster.around(across.column.at(at) * perHeight, across.line.at(at) * perHeight);
            const auto voxels = 1 + static_cast<std::int64_t>(stretch.cells * voxelsPerCell);
            if (stretch.cells > 0 && voxels >= chunk / 2) {
                const std::int64_t last = std::min(x + voxels, near.last);
                if (stretch.cell == cut) wholly(x, last);
                x = last;
                continue;
            }
            const Part part{x, std::min(x + chunk, near.last)};
            lookUp(part, across, places);
            for (; x < part.last; ++x) {
                const StrokeRaster::Cell cell = m_raster.cells()[places[static_cast<std::size_t>(x)]];
                if (cell == cut)
                    wholly(x, x + 1);
                else if (cell == StrokeRaster::mixed)
                    exactly(x);
            }
        }
    }

    /// Looks up the raster's cells for a part of a row.
    static void lookUp(const Part& part, const Across& across, std::vector<std::int32_t>& places) {
        const auto from = [&](const Along& value) {
            return std::pair(static_cast<float>(value.at(static_cast<double>(part.first))),
                             static_cast<float>(value.perVoxel));
        };
        const auto [columnFirst, columnStep] = from(across.column);
        const auto [lineFirst, lineStep] = from(across.line);
        const auto [heightFirst, heightStep] = from(across.height);
        constexpr float last = StrokeRaster::edge - 1;
        std::int32_t* to = places.data() + part.first;
        const auto voxels = static_cast<std::int32_t>(part.last - part.first);
        for (std::int32_t i = 0; i < voxels; ++i) {
            const auto x = static_cast<float>(i);
            const float perHeight = 1.0f / (heightFirst + heightStep * x);
            const float column = (columnFirst + columnStep * x) * perHeight,
                        line = (lineFirst + lineStep * x) * perHeight;
            to[i] = static_cast<std::int32_t>(std::min(std::max(line, 0.0f), last)) * StrokeRaster::edge +
                    static_cast<std::int32_t>(std::min(std::max(column, 0.0f), last));
        }
    }

    /// As cutsAway(), faster by the raster.
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

/// Calls visit(offset of the first voxel, count) for the marked parts of rows, in parallel.
template <typename Visit>
void forEachMarked(const VolumeGeometry& geometry, const RowMarks& rows, const Visit& visit) {
    parallelFor(std::int64_t{0}, geometry.size[2], [&](std::int64_t z) {
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            if (const RowPart& part = rows.at(y, z); part.any()) visit(geometry.offset(part.first, y, z), part.count());
    });
}

bool sameBytes(const DataMask& a, const DataMask& b) { return &a == &b || a == b; }

}  // namespace

ScalpelCuts::ScalpelCuts(const VolumeGeometry& geometry) : m_geometry(geometry) {}

/// Forgets the cuts of the strokes from `kept` on (counted from 0). If these share the number 255 with strokes before,
/// it forgets all strokes of this number.
void ScalpelCuts::forgetFrom(std::size_t kept) {
    if (kept >= m_carried.size()) return;
    kept = std::min(kept, sharedNumber - 1);
    RowMarks rows(m_geometry.size);
    for (std::size_t i = kept; i < m_carried.size(); ++i) {
        rows.add(m_carried[i].rows);
        if (m_made && i < m_made->strokes) m_made->others.add(m_carried[i].rows);
    }
    if (m_made) m_made->strokes = std::min(m_made->strokes, kept);
    m_carried.erase(m_carried.begin() + static_cast<std::ptrdiff_t>(kept), m_carried.end());
    forEachMarked(m_geometry, rows, [&](std::int64_t first, std::int64_t count) {
        std::uint8_t* row = m_firstCut.data() + first;
        for (std::int64_t x = 0; x < count; ++x) row[x] = row[x] > kept ? std::uint8_t{0} : row[x];
    });
}

bool ScalpelCuts::add(const ScalpelStroke& stroke, const Progress& progress) {
    if (const std::string problem = problemOf(stroke); !problem.empty())
        throw std::invalid_argument("ScalpelCuts: a stroke " + problem);
    if (m_firstCut.empty()) m_firstCut.resize(static_cast<std::size_t>(m_geometry.voxelCount()));
    const std::uint8_t number = numberOf(m_carried.size());
    const StrokeRaster raster(stroke);
    const RowCutter cutter(m_geometry, stroke, raster);
    // Take the memory before the stroke counts as cut.
    m_carried.push_back({stroke, RowMarks(m_geometry.size)});
    RowMarks& rows = m_carried.back().rows;
    ++m_passes;
    ProgressCount count(progress, static_cast<std::size_t>(m_geometry.size[2]));
    parallelFor(std::int64_t{0}, m_geometry.size[2], [&](std::int64_t z) {
        if (progress.cancelled()) return;
        std::vector<std::int32_t> places(static_cast<std::size_t>(m_geometry.size[0]));
        for (std::int64_t y = 0; y < m_geometry.size[1]; ++y)
            rows.mark(y, z, cutter.cutRow(y, z, number, m_firstCut.data() + m_geometry.offset(0, y, z), places));
        count.oneDone();
    });
    if (!progress.cancelled()) return true;
    forgetFrom(m_carried.size() - 1);
    return false;
}

bool ScalpelCuts::follow(std::span<const ScalpelStroke> strokes, const Progress& progress) {
    const auto differing = std::ranges::mismatch(strokes, m_carried, {}, {}, &Carried::stroke);
    const auto same = static_cast<std::size_t>(differing.in1 - strokes.begin());
    // If the list only became shorter, nothing is forgotten: m_firstCut still tells the missing strokes from the
    // others. Strokes that share a number cannot be told apart.
    if (same < strokes.size() || (same < m_carried.size() && same >= sharedNumber)) forgetFrom(same);
    while (m_carried.size() < strokes.size())
        if (progress.cancelled() || !add(strokes[m_carried.size()], progress)) return false;
    return true;
}

/// The mask after the first `strokes` (at least one) of m_carried.
Volume::SharedMask ScalpelCuts::maskFor(const Volume& scan, std::size_t strokes) const {
    const std::uint8_t last = numberOf(strokes - 1);
    const DataMask& scanned = scan.scannedMask();
    RowMarks rows(m_geometry.size, true);
    std::vector<std::uint8_t> mask;
    if (m_made && sameBytes(m_made->left.scannedMask(), scanned)) {
        rows = m_made->others;
        for (std::size_t i = std::min(strokes, m_made->strokes); i < std::max(strokes, m_made->strokes); ++i)
            rows.add(m_carried[i].rows);
        if (!rows.any()) return m_made->left.cut();
        mask = m_made->left.cut()->toVector();
    } else {
        mask.resize(m_firstCut.size());
    }
    forEachMarked(m_geometry, rows, [&](std::int64_t start, std::int64_t count) {
        const std::uint8_t* __restrict first = m_firstCut.data() + start;
        std::uint8_t* __restrict marks = mask.data() + start;
        // 0 (no stroke) becomes the largest number.
        for (std::int64_t i = 0; i < count; ++i) marks[i] = static_cast<std::uint8_t>(first[i] - 1) >= last ? 1 : 0;
        if (scanned.empty()) return;
        const std::uint8_t* __restrict held = scanned.data() + start;
        for (std::int64_t i = 0; i < count; ++i) marks[i] = marks[i] != 0 && held[i] != 0 ? 1 : 0;
    });
    return std::make_shared<const DataMask>(std::move(mask));
}

std::optional<Volume> ScalpelCuts::cut(const Volume& scan, std::span<const ScalpelStroke> strokes,
                                       const Progress& progress) {
    if (scan.geometry().size != m_geometry.size) throw std::invalid_argument("ScalpelCuts: a volume of another size");
    if (strokes.empty()) return progress.cancelled() ? std::nullopt : std::optional(scan.withCut(nullptr));
    if (!follow(strokes, progress)) return std::nullopt;
    m_made.emplace(Made{scan.withCut(maskFor(scan, strokes.size())), strokes.size(), RowMarks(m_geometry.size)});
    return m_made->left;
}

}  // namespace echolucent
