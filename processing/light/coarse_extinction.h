// How much the places of a coarse grid attenuate light under a curve.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "processing/classification.h"
#include "processing/light/light_grid.h"
#include "processing/progress.h"
#include "processing/sampling/gradient_levels.h"
#include "processing/volume/row_marks.h"
#include "processing/volume/volume.h"

namespace echolucent::light {

/// Extinction (-log(1 - opacity)) per mm of each place of a grid, x fastest. A place has the mean opacity per unit of
/// its voxels, so that a single opaque voxel in a place of eight takes an eighth of the light of each unit, and not all
/// of it. No data and what lies beyond the volume has opacity 0.
///
/// Each voxel has a level: 0 is no data, 1 + 254 x is normalised intensity x. Where voxels are bytes, voxels and mask
/// are shared with the volume, and a table tells the levels; else the levels are kept, one byte a voxel.
class CoarseExtinction {
public:
    explicit CoarseExtinction(const Volume& volume);
    /// Follows another cut of the same scan, which marks the given rows otherwise (rowsMaskedOtherwise()).
    void setCut(const Volume& volume, const RowMarks& masked);
    /// Makes the extinctions of places that hold a voxel of the marked rows; the others stay. Where it was cancelled
    /// some of them are not made; the caller sees that from `progress`.
    void make(std::vector<float>& extinctions, const RowMarks& rows, const OpacityCurve& curve, const LightGrid& grid,
              const Progress& progress) const;
    /// The same under a two-dimensional OTF, with the gradients of the scan. Each voxel has the opacity of its level
    /// and its gradient's byte. Throws std::invalid_argument where the gradients are of another grid or scale.
    void make(std::vector<float>& extinctions, const RowMarks& rows, const TwoDimensionalOtf& otf,
              const GradientLevels& gradients, const LightGrid& grid, const Progress& progress) const;

private:
    /// addRow(offset of the first voxel, count, voxels a place, sums) adds opacities of a row of voxels to the sums of
    /// its places.
    template <typename AddRow>
    void makeOf(std::vector<float>& extinctions, const RowMarks& rows, const LightGrid& grid, const AddRow& addRow,
                const Progress& progress) const;

    std::array<std::int64_t, 3> m_size;
    double m_unit;                                  ///< mm
    VoxelArray<std::uint8_t> m_bytes;               ///< the volume's; empty where voxels are no bytes
    DataMask m_mask;                                ///< the volume's; empty where all is data or voxels are no bytes
    std::vector<std::uint8_t> m_levels;             ///< empty where voxels are bytes
    std::array<std::uint8_t, 256> m_levelOfByte{};  ///< of what is stored, or of the level itself where these are kept
};

}  // namespace echolucent::light
