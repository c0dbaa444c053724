// A 3D ultrasound volume: voxels, geometry, and which voxels carry data. Immutable once built and shared between
// threads as shared_ptr<const Volume>.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "processing/result.h"
#include "processing/volume/geometry.h"
#include "processing/volume/reduction.h"
#include "processing/volume/stated_probe.h"
#include "processing/volume/value_scale.h"
#include "processing/volume/voxels.h"

namespace echolucent {

/// Where the voxels are. Index order: x fastest, then y, then z. Voxel centres lie at integer indices. The volume's box
/// reaches half a voxel beyond the outermost centres, from -0.5 to size-0.5.
struct VolumeGeometry {
    std::array<std::int64_t, 3> size{1, 1, 1};  ///< voxels along x, y, z; each at least 1
    Vec3 spacing{1, 1, 1};                      ///< mm between voxel centres; each finite and above 0
    Vec3 origin{0, 0, 0};                       ///< patient position (mm, LPS) of the centre of voxel (0,0,0)
    /// Columns: unit patient directions of the grid axes. Every reader gives a right-handed grid (determinant above 0);
    /// on any other, pictures and planes would show the mirror image of the body.
    Mat3 direction = Mat3::eye();
    bool spacingKnown = true;  ///< if false, the spacing is a guess: the picture must say so, and no length in mm may
                               ///< be shown as a fact
    bool patientFrameKnown = false;  ///< whether `direction` was stated for a patient; else it is the grid's own frame
    std::optional<StatedProbe> probe{};  ///< where the probe was, if the file says it
    /// Set if the file holds more voxels than are kept: each is the mean of a block, and the picture must say so.
    std::optional<Reduction> reduction{};

    [[nodiscard]] std::int64_t voxelCount() const { return size[0] * size[1] * size[2]; }
    /// Offset of voxel (x,y,z) in the voxel array.
    [[nodiscard]] std::int64_t offset(std::int64_t x, std::int64_t y, std::int64_t z) const {
        return x + size[0] * (y + size[1] * z);
    }
    /// The unit of length along tube cores and rays: the smallest spacing, in mm (docs/method.md, "Words and units").
    [[nodiscard]] double unit() const;
    [[nodiscard]] Vec3 gridMmFromVoxel(const Vec3& voxel) const { return voxel.mul(spacing); }
    [[nodiscard]] Vec3 voxelFromGridMm(const Vec3& mm) const;
    [[nodiscard]] Vec3 patientFromVoxel(const Vec3& voxel) const { return origin + direction * voxel.mul(spacing); }
    /// Corners of the volume's box in grid mm (half a voxel outside the outermost centres).
    [[nodiscard]] Vec3 boxMinMm() const { return spacing * -0.5; }
    [[nodiscard]] Vec3 boxMaxMm() const;
    [[nodiscard]] Vec3 centreMm() const;
    /// The depths of the box's nearest and farthest corner along a direction, mm from the grid origin.
    struct DepthRange {
        double nearest, farthest;
    };
    [[nodiscard]] DepthRange depthsAlong(const Vec3& forward) const;
};

/// A box along the grid axes, in grid mm. A sector often leaves much of its grid empty. What lies outside the data is
/// no part of the picture.
struct DataBox {
    Vec3 lowMm{0, 0, 0};
    Vec3 highMm{0, 0, 0};

    DataBox() = default;
    DataBox(const Vec3& low, const Vec3& high) : lowMm(low), highMm(high) {}
    /// The whole grid, half a voxel beyond the outermost centres. It converts implicitly, so a geometry can stand for a
    /// box if no voxels are known.
    DataBox(const VolumeGeometry& geometry);

    [[nodiscard]] Vec3 centreMm() const { return (lowMm + highMm) * 0.5; }
    [[nodiscard]] Vec3 sizeMm() const { return highMm - lowMm; }
    /// The smallest box around both.
    [[nodiscard]] DataBox joined(const DataBox& other) const;
    friend bool operator==(const DataBox&, const DataBox&) = default;
};

/// The box around the voxels that a mask marks, half a voxel beyond their centres. The mask holds one byte for each
/// voxel, x fastest, 0 is no data. The box is the whole grid if the mask is empty or marks no voxel.
[[nodiscard]] DataBox dataBoxOf(const VolumeGeometry& geometry, std::span<const std::uint8_t> mask);

/// One volume (one phase of a 4D study).
class Volume {
public:
    /// Takes the voxels. `whiteLevel` is the stored value of normalised intensity 1. If it is missing, not finite or
    /// not above 0, the white level is 255 for 8 bits, else what whiteLevelOf() finds in these voxels (1 if no voxel is
    /// above 0). Float voxels that are not finite count as no data. Throws std::invalid_argument if sizes disagree or
    /// the geometry is not valid (readers check before).
    Volume(VolumeGeometry geometry, Voxels voxels, std::optional<double> whiteLevel = std::nullopt);

    [[nodiscard]] const VolumeGeometry& geometry() const { return m_geometry; }
    [[nodiscard]] const Voxels& voxels() const { return *m_voxels; }
    [[nodiscard]] double whiteLevel() const { return m_whiteLevel; }
    /// How stored values stand for the file's own. The file's values are those that people and other programs read.
    [[nodiscard]] const ValueScale& valueScale() const { return m_valueScale; }
    /// The file's value of normalised intensity 0.
    [[nodiscard]] double blackValue() const { return m_valueScale.black; }
    /// The file's value of normalised intensity 1.
    [[nodiscard]] double whiteValue() const { return m_valueScale.fileValue(m_whiteLevel); }
    [[nodiscard]] ValueWindow valueWindow() const { return {blackValue(), whiteValue()}; }
    /// The file's value of a voxel; NaN stays NaN.
    [[nodiscard]] double fileValue(std::int64_t offset) const { return m_valueScale.fileValue(storedValue(offset)); }
    [[nodiscard]] std::string_view typeName() const;  ///< "uint8", "uint16" or "float32"

    /// One byte for each voxel: 1 is data, 0 is none (outside the scanned sector, cut, or not finite). Empty if all
    /// voxels are data.
    [[nodiscard]] const DataMask& dataMask() const { return *m_dataMask; }
    /// The data mask's first byte, or null if all voxels are data.
    [[nodiscard]] const std::uint8_t* dataMaskOrNull() const {
        return m_dataMask->empty() ? nullptr : m_dataMask->data();
    }
    /// The scan's own mask: dataMask() before a scalpel cut. Voxels outside it hold no echo. Voxels that were cut still
    /// hold theirs.
    [[nodiscard]] const DataMask& scannedMask() const { return *m_scannedMask; }
    /// Whether a scalpel cut (withCut()).
    [[nodiscard]] bool isCut() const { return m_dataMask != m_scannedMask; }
    [[nodiscard]] bool hasData(std::int64_t offset) const {
        return m_dataMask->empty() || (*m_dataMask)[static_cast<std::size_t>(offset)] != 0;
    }
    /// The value as it is stored in memory, as double; NaN stays NaN. The file may hold another: fileValue().
    [[nodiscard]] double storedValue(std::int64_t offset) const;
    /// The stored value over the white level, clamped to [0,1]; 0 if the value is NaN.
    [[nodiscard]] double normalisedIntensity(std::int64_t offset) const;

    /// Whether `other` is the same scan, with the same or another cut: it shares voxels and scannedMask().
    [[nodiscard]] bool isSameScanAs(const Volume& other) const {
        return m_voxels == other.m_voxels && m_scannedMask == other.m_scannedMask;
    }

    /// The box that pictures are fitted to: around the voxels with data, unless another was set.
    [[nodiscard]] const DataBox& dataBox() const { return m_dataBox; }

    /// A volume that shares these voxels but marks other voxels as data. The mask is empty or holds one byte for each
    /// voxel; another size is a broken contract (std::invalid_argument). It is taken as it is, even if it marks voxels
    /// that are not finite. The data box is computed anew, and no voxel counts as cut.
    [[nodiscard]] Volume withDataMask(DataMask mask) const;
    /// One byte for each voxel, shared.
    using SharedMask = std::shared_ptr<const DataMask>;
    /// withDataMask() with a mask that the phases of a study share; it is not null.
    [[nodiscard]] Volume withDataMask(SharedMask mask) const;
    /// withDataMask() if the box around the marked voxels is known. `box` becomes the data box.
    [[nodiscard]] Volume withDataMask(SharedMask mask, const DataBox& box) const;
    /// A volume that shares these voxels but keeps as data only what the mask marks after a scalpel cut. The mask holds
    /// one byte for each voxel (else std::invalid_argument) and marks only voxels of scannedMask(). Null takes the cut
    /// back. scannedMask() and the data box stay, so that the picture does not jump.
    [[nodiscard]] Volume withCut(const SharedMask& mask) const;
    /// The mask of the cut, for another volume of the same grid and scan; null if nothing was cut.
    [[nodiscard]] SharedMask cut() const { return isCut() ? m_dataMask : nullptr; }
    /// A volume that shares these voxels, which stand for the file's values by `scale`.
    [[nodiscard]] Volume withValueScale(const ValueScale& scale) const;
    /// The same volume with another data box. The phases of a study share one, so that the picture does not jump.
    [[nodiscard]] Volume withDataBox(const DataBox& box) const;

private:
    VolumeGeometry m_geometry;
    std::shared_ptr<const Voxels> m_voxels;
    double m_whiteLevel = 1.0;
    ValueScale m_valueScale;
    SharedMask m_dataMask, m_scannedMask;  ///< the same mask if nothing was cut
    DataBox m_dataBox;
};

}  // namespace echolucent
