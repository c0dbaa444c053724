// A volume as pictures read it: the end of the data is no edge in it.
#pragma once

#include <cstdint>
#include <optional>

#include "processing/volume/volume.h"

namespace echolucent {

/// The voxels of a volume, and the presence of data beside them. A picture interpolates all voxels, with and without
/// data. The presence tells how much of each voxel the picture shows.
struct FilledVolume {
    /// The same voxels, but a voxel without data within fillReach voxels of data holds a mean of its neighbours on the
    /// data's side. The mask marks the voxels that then hold a value; all others hold 0. The filled voxels depend on
    /// the scan alone (Volume::scannedMask()): voxels that a scalpel cut still hold their echo.
    Volume voxels;
    /// Bytes with a white level of 255 (see presence.h). Not set if all voxels carry data.
    std::optional<Volume> presence;

    static constexpr int fillReach = 4;  ///< voxels
};

/// Takes a few passes over the volume if voxels lack data. If none do, reads only masks and float voxels.
[[nodiscard]] FilledVolume filledVolume(const Volume& volume);
/// FilledVolume::voxels alone.
[[nodiscard]] Volume filledVoxels(const Volume& volume);
/// FilledVolume::presence alone.
[[nodiscard]] std::optional<Volume> presenceIn(const Volume& volume);

/// How a picture uses the presence of data, 0 to 1.
struct PresenceUse {
    /// The share of a sample's opacity that counts: 0 up to presence 1/4, 1 from 3/4, linear between.
    [[nodiscard]] static constexpr double coverage(double presence) {
        const double share = 2.0 * presence - 0.5;
        return share < 0.0 ? 0.0 : share > 1.0 ? 1.0 : share;
    }
    /// How near a sample is to the border of the data: 1 up to presence 1/2, 0 from 7/8, linear between.
    [[nodiscard]] static constexpr double border(double presence) {
        const double share = (0.875 - presence) / 0.375;
        return share < 0.0 ? 0.0 : share > 1.0 ? 1.0 : share;
    }
    static constexpr std::uint8_t noneUpTo = 63;  ///< bytes of presence up to this have coverage 0
    static constexpr std::uint8_t allFrom = 224;  ///< bytes from this on have coverage 1 and border 0
};

}  // namespace echolucent
