// A volume as pictures read it: no edge stands where the data ends.
#pragma once

#include <cstdint>
#include <optional>

#include "processing/volume/volume.h"

namespace echolucent {

/// The voxels of a volume, and how present data is beside them. A picture interpolates the voxels without asking which
/// of them carry data, and asks the presence what it shows of them.
struct FilledVolume {
    /// The same voxels; where one without data lies within fillReach voxels of data, it holds the mean of what lies
    /// nearest to it on the data's side. The mask marks what then holds a value; the rest holds 0. What a scalpel cut
    /// still holds echo and stays as it is: these voxels depend on the scan alone (Volume::scannedMask()).
    Volume voxels;
    /// Bytes with a white level of 255 (see presence.h). It is not set where all voxels carry data.
    std::optional<Volume> presence;

    static constexpr int fillReach = 4;  ///< voxels
};

/// Takes a few passes over the volume where voxels lack data, else none.
[[nodiscard]] FilledVolume filledVolume(const Volume& volume);
/// FilledVolume::voxels alone.
[[nodiscard]] Volume filledVoxels(const Volume& volume);
/// FilledVolume::presence alone.
[[nodiscard]] std::optional<Volume> presenceIn(const Volume& volume);

/// What a picture makes of the presence of data, 0 to 1.
struct PresenceUse {
    /// The share of a sample's opacity that counts: 0 up to presence 1/4, 1 from 3/4, linear between.
    [[nodiscard]] static constexpr double coverage(double presence) {
        const double share = 2.0 * presence - 0.5;
        return share < 0.0 ? 0.0 : share > 1.0 ? 1.0 : share;
    }
    /// How far a sample lies on the border of the data: 1 up to presence 1/2, 0 from 7/8, linear between.
    [[nodiscard]] static constexpr double border(double presence) {
        const double share = (0.875 - presence) / 0.375;
        return share < 0.0 ? 0.0 : share > 1.0 ? 1.0 : share;
    }
    static constexpr std::uint8_t noneUpTo = 63;  ///< bytes of presence up to this one have coverage 0
    static constexpr std::uint8_t allFrom = 224;  ///< from this one they have coverage 1 and are no border
};

}  // namespace echolucent
