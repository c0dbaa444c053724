#include "processing/ray_caster/packed_voxels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "processing/parallel.h"
#include "processing/ray_caster/transfer_table.h"

namespace echolucent::ray_casting {

namespace {

/// What the kernel may interpolate of a voxel: a float as its table position. Differences, and the squares of
/// gradients, of what is packed must be finite.
template <typename Voxel>
struct Packing {
    double floatsToTable;

    Voxel operator()(Voxel value) const {
        if constexpr (std::is_same_v<Voxel, float>)
            return static_cast<float>(std::clamp(static_cast<double>(value) * floatsToTable, -1e15, 1e15));
        return value;
    }
};

std::int64_t strideOf(std::int64_t columns) {
    return (columns + extraCubes + rowAlignment - 1) / rowAlignment * rowAlignment;
}

/// Writes one row of cubes from the two rows of voxels whose voxels each cube holds.
template <typename Out, typename Voxel, typename Convert>
void packRow(const std::array<const Voxel*, voxelsPerCube>& rows, std::int64_t size, std::int64_t stride,
             Out* __restrict out, const Convert& convert) {
    const Voxel *upper = rows[0], *lower = rows[1];
    const auto write = [&](std::int64_t cube, std::int64_t x) {
        out[cube * voxelsPerCube] = convert(upper[x]);
        out[cube * voxelsPerCube + 1] = convert(lower[x]);
    };
    write(0, 0);
    for (std::int64_t x = 0; x < size; ++x) {
        out[(x + cubeShift) * voxelsPerCube] = convert(upper[x]);
        out[(x + cubeShift) * voxelsPerCube + 1] = convert(lower[x]);
    }
    // The row's rest is read by no sample.
    for (std::int64_t cube = size + 1; cube < stride; ++cube) write(cube, size - 1);
}

/// Packs what the voxels are converted to.
template <typename Out, typename Voxel, typename Convert>
std::unique_ptr<Out[]> packAll(const std::array<std::int64_t, 3>& size, const Voxel* voxels, const Convert& convert) {
    const std::int64_t columns = strideOf(size[0]), rows = size[1] + extraCubes,
                       slices = size[2] + extraCubes + 1;  // the last is read with weight 0 by what is rounded up
    const auto rowOf = [&](std::int64_t y, std::int64_t z) {
        return voxels + size[0] * (std::clamp<std::int64_t>(y, 0, size[1] - 1) +
                                   size[1] * std::clamp<std::int64_t>(z, 0, size[2] - 1));
    };
    auto cubes =
        std::make_unique_for_overwrite<Out[]>(static_cast<std::size_t>(columns * rows * slices * voxelsPerCube));
    parallelFor(tbb::blocked_range<std::int64_t>(0, rows * slices, 64), [&](const auto& range) {
        for (std::int64_t row = range.begin(); row < range.end(); ++row) {
            const std::int64_t y = row % rows - cubeShift, z = row / rows - cubeShift;
            packRow<Out, Voxel>({rowOf(y, z), rowOf(y + 1, z)}, size[0], columns,
                                cubes.get() + row * columns * voxelsPerCube, convert);
        }
    });
    return cubes;
}

}  // namespace

template <typename Voxel>
float PackedVoxels<Voxel>::toTable(double whiteLevel) {
    if constexpr (std::is_same_v<Voxel, float>) return 1.0f;
    // More than that makes the smallest stored value white already, less the largest one black; both must be finite and
    // have an inverse.
    return static_cast<float>(std::clamp(TransferTable::intervals / whiteLevel, 1e-12, 1e12));
}

template <typename Voxel>
PackedVoxels<Voxel>::PackedVoxels(const FilledVolume& volume)
    : m_size(volume.voxels.geometry().size),
      m_rowStride(strideOf(m_size[0])),
      m_sliceStride(m_rowStride * (m_size[1] + extraCubes)) {
    const Packing<Voxel> packing{TransferTable::intervals / volume.voxels.whiteLevel()};
    m_cubes = packAll<Voxel>(m_size, std::get<std::vector<Voxel>>(volume.voxels.voxels()).data(), packing);
    setPresence(volume.presence);
}

template <typename Voxel>
void PackedVoxels<Voxel>::setPresence(const std::optional<Volume>& presence) {
    m_presence.reset();  // first, so that there are never two
    if (!presence) return;
    m_presence = packAll<std::uint8_t>(m_size, std::get<std::vector<std::uint8_t>>(presence->voxels()).data(),
                                       Packing<std::uint8_t>{1.0});
}

template class PackedVoxels<std::uint8_t>;
template class PackedVoxels<std::uint16_t>;
template class PackedVoxels<float>;

}  // namespace echolucent::ray_casting
