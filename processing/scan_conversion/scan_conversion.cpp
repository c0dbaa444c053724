#include "processing/scan_conversion/scan_conversion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "processing/parallel.h"
#include "processing/progress_count.h"
#include "processing/scan_conversion/conversion_kernel.h"

namespace echolucent {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// How far beyond the insonified region a voxel's centre still counts as in it, voxels, for rounding.
constexpr double forgivenVoxels = 1e-6;
/// How far from a sample a voxel's centre still counts as on it, samples, for rounding in the file.
constexpr double onASample = 1e-4;

/// An interval of positions along x, mm. It is empty if `low` is above `high`.
struct Interval {
    double low = 0, high = infinity;
    void atLeast(double value) { low = std::max(low, value); }
    void atMost(double value) { high = std::min(high, value); }
    void clear() { high = -infinity; }
};

/// Positions x >= 0 of a row at depth `along` from the axis of the lines. Their distance from the axis lies in
/// [nearest, farthest], their angle atan2(x, along) in [lowest, highest].
Interval insonifiedSide(double along, double nearest, double farthest, double lowest, double highest) {
    constexpr double quarter = std::numbers::pi / 2;
    Interval side;
    const double behind = along * along;
    if (farthest * farthest < behind || highest < 0) side.clear();
    side.atLeast(std::sqrt(std::max(nearest * nearest - behind, 0.0)));
    side.atMost(std::sqrt(std::max(farthest * farthest - behind, 0.0)));
    if (along > 0) {
        if (highest < quarter) side.atMost(along * std::tan(highest));
        if (lowest >= quarter) side.clear();
        if (lowest > 0 && lowest < quarter) side.atLeast(along * std::tan(lowest));
    } else if (along < 0) {
        if (highest <= quarter) side.clear();
        if (highest > quarter) side.atLeast(along * std::tan(highest));
        if (lowest > quarter) side.atMost(along * std::tan(lowest));
    } else if (highest < quarter || lowest > quarter) {
        // Beams that do not go sideways meet this row only at the apex. There the way back finds the angle 0.
        if (lowest > 0) side.clear();
        side.atMost(0);
    }
    return side;
}

}  // namespace

ScanConversion::ScanConversion(const PolarGeometry& polar, const ConversionGrid& grid, const Progress& progress)
    : m_polar(polar), m_grid(grid), m_lines(polar.lines, progress) {
    if (const auto problem = problemOf(polar))
        throw std::invalid_argument("ScanConversion: the geometry makes no sense: " + problem->words);
    const auto& size = m_grid.geometry.size;
    if (progress.cancelled()) return;
    m_rows.resize(static_cast<std::size_t>(m_grid.rows()));
    parallelFor(std::int64_t{0}, size[2], [&](std::int64_t z) {
        for (std::int64_t y = 0; y < size[1] && !progress.cancelled(); ++y) setRow(y, z);
    });
    setLattice();
}

void ScanConversion::setLattice() {
    if (kindOf(m_polar) != PolarKind::linear) return;
    const auto& size = m_grid.geometry.size;
    const auto indices = [&](std::size_t axis, const auto& indexAt) {
        std::vector<std::int32_t> found(static_cast<std::size_t>(size[axis]), notThere);
        for (std::size_t i = 0; i < found.size(); ++i) {
            const auto place = static_cast<int>(axis);
            const std::optional<double> index =
                indexAt(m_grid.geometry.origin[place] + static_cast<double>(i) * m_grid.geometry.spacing[place]);
            if (index && std::abs(*index - std::round(*index)) < onASample)
                found[i] = static_cast<std::int32_t>(std::lround(*index));
        }
        return found;
    };
    m_lattice.lines = indices(0, [&](double mm) { return indexOnAxis(m_polar.lines, mm); });
    m_lattice.planes = indices(1, [&](double mm) { return indexOnAxis(m_polar.planes, mm); });
    m_lattice.samples = indices(2, [&](double mm) -> std::optional<double> {
        const double sample = (mm - m_polar.rangeStartMm) / m_polar.rangeStepMm;
        if (!(sample > -onASample && sample < static_cast<double>(m_polar.samples - 1) + onASample))
            return std::nullopt;
        return sample;
    });
    m_lattice.allLines = std::find(m_lattice.lines.begin(), m_lattice.lines.end(), notThere) == m_lattice.lines.end();
}

void ScanConversion::setRow(std::int64_t y, std::int64_t z) {
    const Vec3 mm = m_grid.probeMmFromVoxel({0, static_cast<double>(y), static_cast<double>(z)});
    Row& row = m_rows[static_cast<std::size_t>(y + m_grid.geometry.size[1] * z)];
    double plane = mm[1], along = mm[2];
    if (m_polar.planes.spread == PolarSpread::angles) {
        const double depth = mm[2] + m_polar.planes.radiusMm;
        plane = std::atan2(mm[1], depth);
        along = std::hypot(mm[1], depth) - m_polar.planes.radiusMm;
    }
    const auto planeIndex = indexOnAxis(m_polar.planes, plane);
    if (!planeIndex) return;
    row.plane = std::min(static_cast<std::int32_t>(*planeIndex), static_cast<std::int32_t>(m_polar.size()[2] - 2));
    row.planeShare = static_cast<float>(*planeIndex - row.plane);

    const auto [lowest, highest] = std::minmax(m_polar.lines.values.front(), m_polar.lines.values.back());
    const double tolerance = forgivenVoxels * m_grid.geometry.spacing[0];
    Interval left, right;
    if (m_polar.lines.spread == PolarSpread::positions) {
        row.along = static_cast<float>(along);
        const double step = forgivenVoxels * m_polar.rangeStepMm;
        if (along < m_polar.rangeStartMm - step || along > m_polar.rangeEndMm() + step) return;
        right = {lowest, highest};
        left.clear();
    } else {
        along += m_polar.lines.radiusMm;
        row.along = static_cast<float>(along);
        const double nearest = std::max(m_polar.rangeStartMm + m_polar.lines.radiusMm, 0.0) - tolerance;
        const double farthest = m_polar.rangeEndMm() + m_polar.lines.radiusMm + tolerance;
        right = insonifiedSide(along, std::max(nearest, 0.0), farthest, lowest, highest);
        const Interval mirrored = insonifiedSide(along, std::max(nearest, 0.0), farthest, -highest, -lowest);
        left = {-mirrored.high, -mirrored.low};
    }
    const auto runOf = [&](const Interval& interval) {
        if (!(interval.low <= interval.high + 2 * tolerance)) return Run{};
        const double spacing = m_grid.geometry.spacing[0];
        const double first = std::ceil((interval.low - mm[0]) / spacing - forgivenVoxels);
        const double last = std::floor((interval.high - mm[0]) / spacing + forgivenVoxels);
        const auto count = static_cast<double>(m_grid.geometry.size[0]);
        const Run run{static_cast<std::int32_t>(std::clamp(first, 0.0, count)),
                      static_cast<std::int32_t>(std::clamp(last + 1, 0.0, count))};
        return run.first < run.end ? run : Run{};
    };
    row.runs[0] = runOf(left);
    row.runs[1] = runOf(right);
    // Both sides hold the middle.
    if (row.runs[1].first < row.runs[0].end && row.runs[1].end > 0) row.runs[1].first = row.runs[0].end;
    if (row.runs[1].first >= row.runs[1].end) row.runs[1] = {};
}

std::vector<std::uint8_t> ScanConversion::mask(const Progress& progress) const {
    if (progress.cancelled()) return {};
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(m_grid.geometry.voxelCount()));
    const std::int64_t width = m_grid.geometry.size[0];
    parallelFor(std::size_t{0}, m_rows.size(), [&](std::size_t row) {
        if (progress.cancelled()) return;
        for (const Run& run : m_rows[row].runs)
            std::fill(mask.begin() + static_cast<std::int64_t>(row) * width + run.first,
                      mask.begin() + static_cast<std::int64_t>(row) * width + run.end, std::uint8_t{1});
    });
    return progress.cancelled() ? std::vector<std::uint8_t>() : mask;
}

/// Copies a row if its voxels are samples. Returns false if the row needs interpolation.
template <typename Value>
bool ScanConversion::copyRow(const VoxelArray<Value>& polar, std::int64_t index, std::vector<Value>& out) const {
    if (!m_lattice.allLines) return false;
    const auto& size = m_grid.geometry.size;
    const std::int32_t plane = m_lattice.planes[static_cast<std::size_t>(index % size[1])];
    const std::int32_t sample = m_lattice.samples[static_cast<std::size_t>(index / size[1])];
    if (plane == notThere || sample == notThere) return false;
    const auto [samples, lines, planes] = m_polar.size();
    const Value* from = polar.data() + sample + samples * lines * plane;
    for (const Run& run : m_rows[static_cast<std::size_t>(index)].runs)
        for (std::int64_t x = run.first; x < run.end; ++x)
            out[static_cast<std::size_t>(index * size[0] + x)] =
                from[samples * m_lattice.lines[static_cast<std::size_t>(x)]];
    return true;
}

template <typename Value>
void ScanConversion::convertRow(const VoxelArray<Value>& polar, std::int64_t index, std::vector<Value>& out) const {
    if (copyRow(polar, index, out)) return;
    const Row& row = m_rows[static_cast<std::size_t>(index)];
    const auto [samples, lines, planes] = m_polar.size();
    ConversionRow<Value> job;
    job.lines = &m_lines;
    job.angular = m_polar.lines.spread == PolarSpread::angles;
    job.firstMm = static_cast<float>(m_grid.geometry.origin[0]);
    job.spacingMm = static_cast<float>(m_grid.geometry.spacing[0]);
    job.alongMm = row.along;
    job.rangeStartMm = static_cast<float>(m_polar.rangeStartMm + (job.angular ? m_polar.lines.radiusMm : 0.0));
    job.samplesPerMm = static_cast<float>(1 / m_polar.rangeStepMm);
    job.planeShare = row.planeShare;
    job.samples = static_cast<std::int32_t>(samples);
    job.lineCount = static_cast<std::int32_t>(lines);
    job.nearPlane = polar.data() + row.plane * samples * lines;
    job.farPlane = job.nearPlane + samples * lines;
    job.endsHere = row.plane == planes - 2;
    for (const Run& run : row.runs) convertRun(job, run.first, run.end, out.data() + index * m_grid.geometry.size[0]);
}

template <typename Value>
std::optional<Voxels> ScanConversion::convertValues(const VoxelArray<Value>& polar, const Progress& progress) const {
    const auto [samples, lines, planes] = m_polar.size();
    if (polar.size() != static_cast<std::size_t>(samples * lines * planes))
        throw std::invalid_argument("ScanConversion: the number of voxels does not match the geometry");
    std::vector<Value> out(static_cast<std::size_t>(m_grid.geometry.voxelCount()));
    const std::int64_t height = m_grid.geometry.size[1], depth = m_grid.geometry.size[2];
    ProgressCount count(progress, static_cast<std::size_t>(height));
    // Go along z first: rows one behind the other lie in the same or the next plane, which then stays in the cache.
    parallelFor(std::int64_t{0}, height, [&](std::int64_t y) {
        for (std::int64_t z = 0; z < depth && !progress.cancelled(); ++z) convertRow(polar, y + height * z, out);
        if (!progress.cancelled()) count.oneDone();
    });
    if (progress.cancelled()) return std::nullopt;
    return Voxels(std::move(out));
}

std::optional<Voxels> ScanConversion::convert(const Voxels& polar, const Progress& progress) const {
    return std::visit([&](const auto& values) { return convertValues(values, progress); }, polar);
}

}  // namespace echolucent
