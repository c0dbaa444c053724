// How much each place of a coarse grid attenuates light under a curve.
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

/// Extinction, -log(1 - opacity), per mm of each place of a grid, x fastest. A place has the mean opacity per unit of
/// its voxels. So one opaque voxel in a place of eight takes an eighth of the light per unit, not all of it. No data
/// and the outside of the volume have opacity 0.
///
/// Each voxel has a level: 0 is no data, 1 + 254 x is normalised intensity x. If voxels are bytes, voxels and mask are
/// shared with the volume, and a table gives the levels. Otherwise the levels are kept, one byte a voxel.
class CoarseExtinction {
public:
    explicit CoarseExtinction(const Volume& volume);
    /// Follows another cut of the same scan. The cuts differ in the marked rows only (rowsMaskedOtherwise()).
    void setCut(const Volume& volume, const RowMarks& masked);
    /// Makes the extinctions of places that hold a voxel of the marked rows; other places keep theirs. If the work was
    /// cancelled, some are not made; the caller must ask progress.cancelled().
    void make(std::vector<float>& extinctions, const RowMarks& rows, const OpacityCurve& curve, const LightGrid& grid,
              const Progress& progress) const;
    /// The same under a two-dimensional OTF. Each voxel has the opacity of its level and of its gradient's byte. Throws
    /// std::invalid_argument if the gradients have another grid or scale.
    void make(std::vector<float>& extinctions, const RowMarks& rows, const TwoDimensionalOtf& otf,
              const GradientLevels& gradients, const LightGrid& grid, const Progress& progress) const;

private:
    /// addRow(offset of the first voxel, count, voxels a place, sums) adds the opacities of a row of voxels to the sums
    /// of its places.
    template <typename AddRow>
    void makeOf(std::vector<float>& extinctions, const RowMarks& rows, const LightGrid& grid, const AddRow& addRow,
                const Progress& progress) const;

    std::array<std::int64_t, 3> m_size;
    double m_unit;                       ///< mm
    VoxelArray<std::uint8_t> m_bytes;    ///< the volume's; empty if voxels are no bytes
    DataMask m_mask;                     ///< the volume's; empty if all voxels are data or voxels are no bytes
    std::vector<std::uint8_t> m_levels;  ///< empty if voxels are bytes
    std::array<std::uint8_t, 256> m_levelOfByte{};  ///< of a byte as stored, or of a level itself if levels are kept
};

}  // namespace echolucent::light
