#include "processing/sampling/plane_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "processing/parallel.h"

namespace echolucent {

namespace {

constexpr float nothing = std::numeric_limits<float>::quiet_NaN();
constexpr double roundingOfBox = 1e-9;  // as in inBox()

/// Rows of a plane in voxels.
struct RowsInVoxels {
    Vec3 first, perColumn, perRow;
    std::array<std::int64_t, 3> size;

    /// The columns of a row, [begin, end), that lie in the volume's box.
    struct Span {
        int begin, end;
    };
    [[nodiscard]] Span inBox(const Vec3& start, int columns) const {
        double from = 0.0, to = columns - 1.0;
        for (int axis = 0; axis < 3; ++axis) {
            const double low = -0.5 - roundingOfBox - start[axis],
                         high = static_cast<double>(size[static_cast<std::size_t>(axis)]) - 0.5 + roundingOfBox -
                                start[axis];
            const double step = perColumn[axis];
            // A step that changes nothing over the whole row counts as 0.
            if (std::abs(step) * columns < roundingOfBox) {
                if (low > 0.0 || high < 0.0) return {0, 0};
                continue;
            }
            from = std::max(from, std::min(low / step, high / step));
            to = std::min(to, std::max(low / step, high / step));
        }
        if (!(from <= to)) return {0, 0};
        return {static_cast<int>(std::ceil(from)), static_cast<int>(std::floor(to)) + 1};
    }
};

/// The lower of two neighbouring voxel centres along an axis, the way to the upper one, and the share of that way.
struct Between {
    std::int64_t low, step;
    float share;
};

Between between(double voxel, std::int64_t size) {
    const auto last = static_cast<double>(size - 1);
    const double inside = std::min(std::max(voxel, 0.0), last);  // std::clamp() would branch
    // No side of a volume is as long as 2^31 voxels, and the conversion to 32 bits is faster.
    const auto low = static_cast<std::int32_t>(inside);
    return {low, low + 1 < size ? 1 : 0, static_cast<float>(inside - low)};
}

template <typename Voxel>
float interpolated(const Voxel* corner, std::int64_t right, std::int64_t down, std::int64_t behind, float x, float y,
                   float z) {
    const auto along = [&](const Voxel* at) {
        const auto a = static_cast<float>(at[0]), b = static_cast<float>(at[right]);
        return a + x * (b - a);
    };
    const auto across = [&](const Voxel* at) {
        const float a = along(at), b = along(at + down);
        return a + y * (b - a);
    };
    const float front = across(corner), back = across(corner + behind);
    return front + z * (back - front);
}

/// The weighted mean of the voxels with data. NaN if they weigh less than half. Every mask marks float voxels that are
/// not finite as no data.
template <typename Voxel>
float interpolatedData(const Voxel* corner, const std::uint8_t* mask, std::int64_t right, std::int64_t down,
                       std::int64_t behind, float x, float y, float z) {
    float sum = 0.0f, weights = 0.0f;
    for (int i = 0; i < 8; ++i) {
        const float weight = (i & 1 ? x : 1.0f - x) * (i & 2 ? y : 1.0f - y) * (i & 4 ? z : 1.0f - z);
        const std::int64_t at = (i & 1 ? right : 0) + (i & 2 ? down : 0) + (i & 4 ? behind : 0);
        if (weight == 0.0f || mask[at] == 0) continue;
        sum += weight * static_cast<float>(corner[at]);
        weights += weight;
    }
    return weights < 0.5f ? nothing : sum / weights;
}

template <typename Voxel>
void sampleRow(const Volume& volume, const Voxel* voxels, const RowsInVoxels& rows, const Vec3& start,
               RowsInVoxels::Span span, float* intensity) {
    const auto& size = rows.size;
    const std::uint8_t* mask = volume.dataMaskOrNull();
    const auto toWhite = static_cast<float>(1.0 / volume.whiteLevel());
    for (int column = span.begin; column < span.end; ++column) {
        const Between x = between(start[0] + rows.perColumn[0] * column, size[0]),
                      y = between(start[1] + rows.perColumn[1] * column, size[1]),
                      z = between(start[2] + rows.perColumn[2] * column, size[2]);
        const std::int64_t at = x.low + size[0] * (y.low + size[1] * z.low);
        const std::int64_t right = x.step, down = y.step * size[0], behind = z.step * size[0] * size[1];
        bool complete = mask == nullptr;
        if (mask != nullptr) {
            const std::uint8_t* m = mask + at;
            complete = m[0] && m[right] && m[down] && m[right + down] && m[behind] && m[right + behind] &&
                       m[down + behind] && m[right + down + behind];
        }
        const float stored =
            complete ? interpolated(voxels + at, right, down, behind, x.share, y.share, z.share)
                     : interpolatedData(voxels + at, mask + at, right, down, behind, x.share, y.share, z.share);
        // NaN stays NaN.
        const float normalised = stored * toWhite;
        intensity[column] = normalised < 0.0f ? 0.0f : normalised > 1.0f ? 1.0f : normalised;
    }
}

}  // namespace

PlaneSamples sampledPlane(const Volume& volume, const PlaneGrid& grid) {
    const VolumeGeometry& geometry = volume.geometry();
    PlaneSamples samples{grid.columns, grid.rows, {}};
    samples.intensity.assign(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows), nothing);
    const RowsInVoxels rows{geometry.voxelFromGridMm(grid.firstMm), geometry.voxelFromGridMm(grid.perColumnMm),
                            geometry.voxelFromGridMm(grid.perRowMm), geometry.size};
    std::visit(
        [&](const auto& voxels) {
            parallelFor(0, grid.rows, [&](int row) {
                const Vec3 start = rows.first + rows.perRow * row;
                const auto offset = static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns);
                sampleRow(volume, voxels.data(), rows, start, rows.inBox(start, grid.columns),
                          samples.intensity.data() + offset);
            });
        },
        volume.voxels());
    return samples;
}

}  // namespace echolucent
