// The gradients that light asks for, interpolated by one look at a place instead of six samples of the volume.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "processing/ray_caster/packed/brick_grid.h"
#include "processing/ray_caster/packed/packed_voxels.h"
#include "processing/volume/geometry.h"

namespace echolucent::ray_casting {

/// What the gradients of a volume depend on beside its voxels.
struct GradientRule {
    std::array<int, 3> reach{};  ///< voxels from a sample to each end of the difference
    double gradientFloor = 0.0;  ///< Shading::gradientFloor
    friend bool operator==(const GradientRule&, const GradientRule&) = default;

    /// `reach`: voxels from a sample to each end of the difference. Empty if nothing is stored: an axis has no
    /// whole reach, or bytes are too coarse for the gradient floor.
    [[nodiscard]] static std::optional<GradientRule> of(const std::array<double, 3>& reach, double gradientFloor);
};

/// Gradients at voxels, as bytes. A central difference over whole voxels of a trilinear field is the trilinear mean of
/// the differences at voxels. So between them nothing is lost but what the bytes round away. They are `quantum` apart,
/// a tenth of the gradient floor; in a brick with a gradient of more than 127 quanta, up to four times as far. A
/// gradient that is longer still keeps its direction.
///
/// A brick is made when the first sample in it asks for light. Several threads may ask at once.
class GradientPlaces {
public:
    /// A place holds the bytes of gx, gy, gz and the brick's scale at voxel (x,y,z), each beside that at (x,y+1,z). So
    /// two loads of 16 bytes, which also reach the place of x + 1, give all that the mean between eight voxels needs.
    static constexpr int bytesPerPlace = 8;
    /// A brick of places has one more along x and z than its brick of cubes.
    static constexpr int columns = BrickGrid::edge + 1, rows = BrickGrid::edge, slices = BrickGrid::edge + 1;
    static constexpr std::size_t bytesPerBrick = std::size_t{columns} * rows * slices * bytesPerPlace;
    /// The byte of no difference.
    static constexpr int zero = 128;
    /// The scale with which a brick's bytes are quanta.
    static constexpr int scaleOne = 64;
    /// Gradient floors in a quantum. Differences over the usual reach of four units of bytes with white level 255 are
    /// whole quanta at the usual floor.
    static constexpr double floorsPerQuantum = 100.0 / 1020.0;
    static constexpr double leastFloor = 0.004;  ///< normalised intensity per unit

    template <typename Voxel>
    GradientPlaces(const std::shared_ptr<const PackedVoxels<Voxel>>& voxels, const VolumeGeometry& geometry,
                   float toTable, const GradientRule& rule);
    ~GradientPlaces();
    GradientPlaces(const GradientPlaces&) = delete;
    GradientPlaces& operator=(const GradientPlaces&) = delete;

    [[nodiscard]] const GradientRule& rule() const { return m_rule; }
    /// Normalised intensity per unit.
    [[nodiscard]] float quantum() const { return m_quantum; }
    /// Cubes [first, last) on an axis have its derivatives. The differences of others would end beyond the outermost
    /// voxels.
    [[nodiscard]] std::int32_t firstCube(std::size_t axis) const { return m_firstCube[axis]; }
    [[nodiscard]] std::int32_t lastCube(std::size_t axis) const { return m_lastCube[axis]; }
    [[nodiscard]] const BrickGrid& grid() const { return m_grid; }

    /// The places of a brick. One more, number grid().count(), has scale 0: no gradient.
    [[nodiscard]] const std::uint8_t* brick(std::size_t index) const {
        const std::uint8_t* const made = m_bricks[index].load(std::memory_order_acquire);
        return made != nullptr ? made : make(index);
    }
    /// Bytes of the bricks made so far.
    [[nodiscard]] std::size_t bytes() const { return m_made.load(std::memory_order_relaxed) * bytesPerBrick; }

    /// The most bytes that the bricks that are shown may take, for a volume with so many bytes of packed voxels. Those
    /// that light has asked for are a part of them.
    [[nodiscard]] static std::size_t mostBytes(std::size_t packed);

private:
    const std::uint8_t* make(std::size_t index) const;

    GradientRule m_rule;
    BrickGrid m_grid;
    float m_quantum;
    std::array<std::int32_t, 3> m_firstCube{}, m_lastCube{};
    std::function<void(std::size_t brick, std::uint8_t* places)> m_fill;
    mutable std::vector<std::atomic<const std::uint8_t*>> m_bricks;
    mutable std::atomic<std::size_t> m_made = 0;
};

}  // namespace echolucent::ray_casting
