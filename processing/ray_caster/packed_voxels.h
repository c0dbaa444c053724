// The voxels of a volume in the order the kernel reads them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "processing/volume/filled_volume.h"

namespace echolucent::ray_casting {

/// Cube (x,y,z) of the packed order is the space between voxels x-1 and x, y-1 and y, z-1 and z; voxels beyond the grid
/// repeat its outermost ones. So a position p in voxels lies in cube floor(p) + 1, for all p in the volume's box. Each
/// axis has size + 2 cubes; the last one only ends the cube before it.
inline constexpr int cubeShift = 1;
inline constexpr int extraCubes = 2;

/// Of each cube the two voxels at its lower x and z are stored, that of lower y first: twice the volume's memory. So
/// one load of four bytes (8 bits) or eight bytes (16 bits) brings the four voxels of a cube in one slice, of floats
/// two.
inline constexpr int voxelsPerCube = 2;

/// Rows of cubes are filled up to a multiple of this, so that strides of rows and slices fit words when divided by it.
inline constexpr int rowAlignment = 16;

/// Makes one pass over the volume. Floats are stored as table positions (see transfer_table.h): their white level may
/// be of any magnitude.
template <typename Voxel>
class PackedVoxels {
public:
    explicit PackedVoxels(const FilledVolume& volume);
    /// Packs another presence of data beside the same voxels; none where all voxels carry data.
    void setPresence(const std::optional<Volume>& presence);

    [[nodiscard]] const Voxel* cubes() const { return m_cubes.get(); }
    /// The factor from a packed value to its table position.
    [[nodiscard]] static float toTable(double whiteLevel);
    /// The presence of data, packed like bytes. It is null where all voxels carry data.
    [[nodiscard]] const std::uint8_t* presence() const { return m_presence.get(); }
    [[nodiscard]] std::int64_t rowStride() const { return m_rowStride; }      ///< cubes
    [[nodiscard]] std::int64_t sliceStride() const { return m_sliceStride; }  ///< cubes

private:
    std::array<std::int64_t, 3> m_size;
    std::int64_t m_rowStride, m_sliceStride;
    std::unique_ptr<Voxel[]> m_cubes;
    std::unique_ptr<std::uint8_t[]> m_presence;
};

}  // namespace echolucent::ray_casting
