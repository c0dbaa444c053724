// The kernel's data for a two-dimensional OTF: gradient magnitudes in the order of the packed voxels, and nodes.
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

/// A volume's gradient magnitudes for two-dimensional OTFs of one largest gradient, with their range in each brick.
class PackedGradients {
public:
    /// `filled` is FilledVolume::voxels, `levels` are its gradients, `bricks` are those of the empty space.
    PackedGradients(const Volume& filled, std::shared_ptr<const GradientLevels> levels, const BrickGrid& bricks);

    [[nodiscard]] const std::shared_ptr<const GradientLevels>& levels() const { return m_levels; }
    /// In the order of PackedVoxels: two bytes a cube.
    [[nodiscard]] const std::uint8_t* cubes() const { return m_packed.cubes(); }
    /// The smallest and the largest byte that the samples in each brick may read.
    [[nodiscard]] const std::vector<std::uint8_t>& lowest() const { return m_lowest; }
    [[nodiscard]] const std::vector<std::uint8_t>& highest() const { return m_highest; }

private:
    std::shared_ptr<const GradientLevels> m_levels;
    PackedVoxels<std::uint8_t> m_packed;
    std::vector<std::uint8_t> m_lowest, m_highest;
};

/// Counts the visible nodes of a two-dimensional OTF in any rectangle of nodes, by sums over all nodes before.
class VisibleNodes {
public:
    explicit VisibleNodes(const TwoDimensionalOtf& otf);
    /// Whether opacity stays up to TransferTable::negligible for all intensities between two table positions and all
    /// gradients between two bytes.
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
