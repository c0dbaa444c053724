#include "processing/ray_caster/packed_voxels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "processing/parallel.h"
#include "processing/ray_caster/transfer_table.h"

namespace echolucent::ray_casting {

namespace {

/// What the kernel may interpolate: 0 in place of what holds no value.
template <typename Voxel>
struct Source {
    const Voxel* voxels;
    std::array<std::int64_t, 3> size;
    double floatsToTable;

    [[nodiscard]] Voxel packed(std::int64_t offset) const {
        if constexpr (!std::is_same_v<Voxel, float>)
            return voxels[offset];
        else
            // Differences, and the squares of gradients, of what is packed must be finite.
            return static_cast<float>(std::clamp(static_cast<double>(voxels[offset]) * floatsToTable, -1e15, 1e15));
    }
    [[nodiscard]] std::int64_t rowOf(std::int64_t y, std::int64_t z) const {
        return size[0] *
               (std::clamp<std::int64_t>(y, 0, size[1] - 1) + size[1] * std::clamp<std::int64_t>(z, 0, size[2] - 1));
    }
};

/// Writes one row of cubes; `rows` are offsets of the first voxels of the rows whose voxels each cube holds.
template <typename Out, typename Read>
void packRow(const std::array<std::int64_t, voxelsPerCube>& rows, std::int64_t size, std::int64_t stride, Out* out,
             const Read& read) {
    const auto write = [&](std::int64_t cube, std::int64_t x) {
        for (std::size_t i = 0; i < voxelsPerCube; ++i)
            out[static_cast<std::size_t>(cube) * voxelsPerCube + i] = read(rows[i] + x);
    };
    write(0, 0);
    for (std::int64_t x = 0; x < size; ++x) write(x + cubeShift, x);
    // The row's rest is read by no sample.
    for (std::int64_t cube = size + 1; cube < stride; ++cube) write(cube, size - 1);
}
std::int64_t strideOf(std::int64_t columns) {
    return (columns + extraCubes + rowAlignment - 1) / rowAlignment * rowAlignment;
}

template <typename Out, typename Voxel, typename Read>
std::unique_ptr<Out[]> packAll(const Source<Voxel>& source, const Read& read) {
    const std::int64_t columns = strideOf(source.size[0]), rows = source.size[1] + extraCubes,
                       slices =
                           source.size[2] + extraCubes + 1;  // the last is read with weight 0 by what is rounded up
    auto cubes =
        std::make_unique_for_overwrite<Out[]>(static_cast<std::size_t>(columns * rows * slices * voxelsPerCube));
    parallelFor(tbb::blocked_range<std::int64_t>(0, rows * slices, 64), [&](const auto& range) {
        for (std::int64_t row = range.begin(); row < range.end(); ++row) {
            const std::int64_t y = row % rows - cubeShift, z = row / rows - cubeShift;
            packRow<Out>({source.rowOf(y, z), source.rowOf(y + 1, z)}, source.size[0], columns,
                         cubes.get() + row * columns * voxelsPerCube, read);
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
    : m_rowStride(strideOf(volume.voxels.geometry().size[0])),
      m_sliceStride(m_rowStride * (volume.voxels.geometry().size[1] + extraCubes)) {
    const auto& size = volume.voxels.geometry().size;
    const Source<Voxel> source{std::get<std::vector<Voxel>>(volume.voxels.voxels()).data(), size,
                               TransferTable::intervals / volume.voxels.whiteLevel()};
    m_cubes = packAll<Voxel>(source, [&](std::int64_t offset) { return source.packed(offset); });
    if (!volume.presence) return;
    const auto& presence = std::get<std::vector<std::uint8_t>>(volume.presence->voxels());
    m_presence =
        packAll<std::uint8_t>(source, [&](std::int64_t offset) { return presence[static_cast<std::size_t>(offset)]; });
}

template class PackedVoxels<std::uint8_t>;
template class PackedVoxels<std::uint16_t>;
template class PackedVoxels<float>;

}  // namespace echolucent::ray_casting
