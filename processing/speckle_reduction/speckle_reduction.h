// The voxels of a picture: quieter than the voxels read, with the same surfaces (docs/speckle.md). Tube cores, the
// search for a cut and pointed values still use the voxels read.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "processing/choice_names.h"
#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// How much speckle is removed from the voxels before they are shown.
enum class SpeckleReduction {
    off,     ///< none: the voxels as they were read
    light,   ///< a little, and the quickest
    medium,  ///< speckle fades, surfaces and membranes stay
    strong,  ///< the rest is smooth; the finest structures go with the speckle
};

inline constexpr std::array allSpeckleReductions{SpeckleReduction::off, SpeckleReduction::light,
                                                 SpeckleReduction::medium, SpeckleReduction::strong};
inline constexpr ChoiceNames<allSpeckleReductions.size()> speckleReductionNames{"off", "light", "medium", "strong"};

/// The default, chosen by eye on real volumes (docs/speckle.md).
inline constexpr SpeckleReduction defaultSpeckleReduction = SpeckleReduction::medium;

/// "off", "light", "medium", "strong".
[[nodiscard]] inline std::string_view nameOf(SpeckleReduction reduction) {
    return nameIn(speckleReductionNames, reduction);
}

/// The volume with quiet voxels. Voxel type, geometry, white level and data mask stay, and scalpel cuts change no quiet
/// voxel (Volume::scannedMask()). Voxels without data stay, and their stored values change no other voxel. Values above
/// the white level count as white, values below 0 as 0. If all data is one value, it stays that value. With `off`, the
/// result shares the volume's voxels. Empty only if the caller set progress.cancel. Has the same bits for any number of
/// threads.
[[nodiscard]] std::optional<Volume> quietVolume(const Volume& volume, SpeckleReduction reduction,
                                                const Progress& progress = {});

}  // namespace echolucent
