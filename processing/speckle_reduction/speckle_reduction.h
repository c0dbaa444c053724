// The voxels a picture is taken from: quieter than those that were read, with their surfaces where they were
// (docs/speckle.md). Tube cores, the search for a cut and pointed values go on reading the voxels that were read.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "processing/choice_names.h"
#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// How much speckle is taken out of the voxels before they are shown.
enum class SpeckleReduction {
    off,     ///< none: the voxels as they were read
    light,   ///< a little, and the quickest
    medium,  ///< speckle fades, surfaces and membranes stay
    strong,  ///< what is left is smooth; the finest structures go with the speckle
};

inline constexpr std::array allSpeckleReductions{SpeckleReduction::off, SpeckleReduction::light,
                                                 SpeckleReduction::medium, SpeckleReduction::strong};
inline constexpr ChoiceNames<allSpeckleReductions.size()> speckleReductionNames{"off", "light", "medium", "strong"};

/// What nobody chose: chosen by eye on real volumes (docs/speckle.md).
inline constexpr SpeckleReduction defaultSpeckleReduction = SpeckleReduction::medium;

/// "off", "light", "medium", "strong".
[[nodiscard]] inline std::string_view nameOf(SpeckleReduction reduction) {
    return nameIn(speckleReductionNames, reduction);
}
[[nodiscard]] inline std::optional<SpeckleReduction> speckleReductionFromName(std::string_view name) {
    return choiceNamed<SpeckleReduction>(speckleReductionNames, name);
}

/// The volume with quiet voxels: voxel type, geometry, white level and data mask are the volume's. What a scalpel cut
/// changes none of them (Volume::scannedMask()). Voxels without data
/// stay as they are, and what is stored in them changes no other voxel. What is above the white level counts as white,
/// what is below 0 as 0. Where all data is one value it stays that
/// value. With `off` the result shares the volume's voxels. The result is empty only where progress.cancel was raised,
/// and has the same bits for any number of threads.
[[nodiscard]] std::optional<Volume> quietVolume(const Volume& volume, SpeckleReduction reduction,
                                                const Progress& progress = {});

}  // namespace echolucent
