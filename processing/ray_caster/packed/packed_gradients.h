// What the kernel reads of a two-dimensional OTF: gradient magnitudes in the order of the packed voxels, and nodes.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "processing/classification.h"
#include "processing/ray_caster/packed/brick_grid.h"
#include "processing/ray_caster/packed/packed_voxels.h"
#include "processing/sampling/gradient_levels.h"
#include "processing/volume/volume.h"

namespace echolucent::ray_casting {

/// The gradient magnitudes of a volume for pictures with one two-dimensional OTF, and in which bricks it shows nothing.
class PackedGradients {
public:
    /// `filled` is FilledVolume::voxels, `levels` are its gradients. `bricks` are those of the empty space.
    PackedGradients(const Volume& filled, std::shared_ptr<const GradientLevels> levels, const BrickGrid& bricks);

    [[nodiscard]] const std::shared_ptr<const GradientLevels>& levels() const { return m_levels; }
    /// In the order of PackedVoxels: two bytes a cube.
    [[nodiscard]] const std::uint8_t* cubes() const { return m_packed.cubes(); }
    /// The smallest and the largest byte that samples in a brick may be made of.
    [[nodiscard]] const std::vector<std::uint8_t>& lowest() const { return m_lowest; }
    [[nodiscard]] const std::vector<std::uint8_t>& highest() const { return m_highest; }

private:
    std::shared_ptr<const GradientLevels> m_levels;
    PackedVoxels<std::uint8_t> m_packed;
    std::vector<std::uint8_t> m_lowest, m_highest;
};

/// How many nodes of a two-dimensional OTF are visible in each rectangle of nodes: sums over all nodes before.
class VisibleNodes {
public:
    explicit VisibleNodes(const TwoDimensionalOtf& otf);
    /// True where no intensity between two table positions, at a gradient between two bytes, is more opaque than
    /// TransferTable::negligible.
    [[nodiscard]] bool transparentBetween(float lowest, float highest, std::uint8_t lowestGradient,
                                          std::uint8_t highestGradient) const;
    /// Table positions up to this one have opacity 0 at any gradient.
    [[nodiscard]] float firstVisible() const { return m_firstVisible; }

private:
    int m_intensities, m_gradients;
    std::vector<std::int32_t> m_before;  ///< (m_intensities + 1) a row of gradients, m_gradients + 1 rows
    float m_firstVisible = 0.0f;
};

}  // namespace echolucent::ray_casting
