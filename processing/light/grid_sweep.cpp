#include "processing/light/grid_sweep.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "processing/light/slice_kernel.h"
#include "processing/parallel.h"

namespace echolucent::light {

namespace {

/// The grid as slices of rows.
struct Slices {
    std::array<int, 3> axes;  ///< of the grid: along a row, from row to row, from slice to slice
    std::array<int, 3> size;  ///< columns, rows, slices
    std::size_t rowStride, sliceStride;

    Slices(const LightGrid& grid, int axis)
        : axes(axis == 0   ? std::array{1, 2, 0}
               : axis == 1 ? std::array{0, 2, 1}
                           : std::array{0, 1, 2}) {
        for (std::size_t i = 0; i < 3; ++i) size[i] = grid.size[static_cast<std::size_t>(axes[i])];
        const auto columns = static_cast<std::size_t>(size[0]);
        // If slices follow each other along x or y, each plane of constant z holds one row of every slice. So the next
        // slice is one row on in memory, and the next row of a slice one plane on.
        rowStride = axis == 2 ? columns : columns * static_cast<std::size_t>(size[2]);
        sliceStride = axis == 2 ? columns * static_cast<std::size_t>(size[1]) : columns;
    }
    [[nodiscard]] std::size_t planeStride() const { return static_cast<std::size_t>(size[0]) + 2 + spareFloats; }
};

/// A direction's two planes: the light behind the slice before, and the light behind this slice.
class SweptPlanes {
public:
    explicit SweptPlanes(const Slices& slices)
        : m_planes{std::vector<float>(slices.planeStride() * static_cast<std::size_t>(slices.size[1] + 2), 1.0f)} {
        m_planes[1] = m_planes[0];
    }
    void bind(SweptDirection& direction, int slice) {
        direction.before = m_planes[static_cast<std::size_t>(slice & 1)].data();
        direction.behind = m_planes[static_cast<std::size_t>(1 - (slice & 1))].data();
    }

private:
    std::array<std::vector<float>, 2> m_planes;
};

/// Where a direction crosses the slice before, in places.
SweptDirection swept(const WeightedDirection& direction, const Slices& slices, const Vec3& spacingMm) {
    const double lengthMm = spacingMm[slices.axes[2]] / std::abs(direction.towards[slices.axes[2]]);
    const auto crossing = [&](int axis) {
        return std::clamp(direction.towards[axis] * lengthMm / spacingMm[axis], -1.0, 1.0);
    };
    const double column = crossing(slices.axes[0]), row = crossing(slices.axes[1]);
    SweptDirection result{};
    result.column = column < 0.0 ? -1 : 0;
    result.row = row < 0.0 ? -1 : 0;
    const double right = column - result.column, down = row - result.row;
    const std::array<double, 4> taps{(1.0 - right) * (1.0 - down), right * (1.0 - down), (1.0 - right) * down,
                                     right * down};
    for (std::size_t i = 0; i < taps.size(); ++i) result.taps[i] = static_cast<float>(taps[i]);
    result.halfLengthMm = static_cast<float>(0.5 * lengthMm);
    result.weight = static_cast<float>(direction.weight);
    return result;
}

/// The axis along which a direction crosses the most places.
int sweptAxis(const Vec3& towards, const Vec3& spacingMm) {
    int axis = 2;
    for (const int other : {1, 0})
        if (std::abs(towards[other]) / spacingMm[other] > std::abs(towards[axis]) / spacingMm[axis]) axis = other;
    return axis;
}

}  // namespace

std::vector<DirectionBundle> DirectionBundle::of(const std::vector<WeightedDirection>& directions,
                                                 const LightGrid& grid) {
    std::vector<DirectionBundle> bundles;
    for (const WeightedDirection& direction : directions) {
        const int axis = sweptAxis(direction.towards, grid.spacingMm);
        const bool fromHigh = direction.towards[axis] > 0.0;
        const auto open = std::find_if(bundles.begin(), bundles.end(), [&](const DirectionBundle& bundle) {
            return bundle.m_axis == axis && bundle.m_fromHigh == fromHigh && bundle.m_directions.size() < most;
        });
        DirectionBundle& bundle = open != bundles.end() ? *open : bundles.emplace_back(DirectionBundle(axis, fromHigh));
        bundle.m_directions.push_back(direction);
    }
    return bundles;
}

std::vector<std::uint16_t> DirectionBundle::sweep(const GridExtinctions& extinctions, double attenuation,
                                                  const Progress& progress) const {
    const LightGrid& grid = extinctions.grid;
    const Slices slices(grid, m_axis);
    std::vector<SweptDirection> directions;
    for (const WeightedDirection& direction : m_directions) {
        directions.push_back(swept(direction, slices, grid.spacingMm));
        directions.back().halfLengthMm *= static_cast<float>(attenuation);
    }
    std::vector<SweptPlanes> planes(directions.size(), SweptPlanes(slices));
    std::vector<float> sums(slices.planeStride());
    std::vector<std::uint16_t> reaching(grid.places());
    const std::vector<float>& source = alongX() ? extinctions.yFastest : extinctions.xFastest;
    for (int slice = 0; slice < slices.size[2] && !progress.cancelled(); ++slice) {
        for (std::size_t i = 0; i < directions.size(); ++i) planes[i].bind(directions[i], slice);
        const auto place = static_cast<std::size_t>(m_fromHigh ? slices.size[2] - 1 - slice : slice);
        const std::size_t offset = place * slices.sliceStride;
        sweepSlice({source.data() + offset, slices.rowStride, slices.size[0], slices.size[1], slices.planeStride(),
                    directions, sums.data(), reaching.data() + offset, static_cast<float>(fullLight)});
    }
    return reaching;
}

std::vector<float> withYFastest(const std::vector<float>& xFastest, const LightGrid& grid) {
    const auto columns = static_cast<std::size_t>(grid.size[0]), rows = static_cast<std::size_t>(grid.size[1]);
    std::vector<float> exchanged(grid.places() + spareFloats);
    parallelFor(0, grid.size[2], [&](int z) {
        const std::size_t plane = static_cast<std::size_t>(z) * columns * rows;
        for (std::size_t x = 0; x < columns; ++x)
            for (std::size_t y = 0; y < rows; ++y) exchanged[plane + x * rows + y] = xFastest[plane + y * columns + x];
    });
    return exchanged;
}

}  // namespace echolucent::light
