#include "processing/speckle_reduction/speckle_reduction.h"

#include <array>
#include <stdexcept>

#include "processing/speckle_reduction/faded_rim.h"
#include "processing/speckle_reduction/gaussian_filter.h"
#include "processing/speckle_reduction/joint_bilateral_filter.h"

namespace echolucent {

namespace {
// docs/speckle.md gives the reasons for these values.
constexpr double lightSigma = 1.0;
constexpr std::array mediumPasses{JointBilateralPass{}};
constexpr std::array strongPasses{JointBilateralPass{}, JointBilateralPass{.guideSigma = 0.7}};

std::optional<Volume> filtered(const Volume& volume, SpeckleReduction reduction, const Progress& progress) {
    switch (reduction) {
        case SpeckleReduction::off: break;
        case SpeckleReduction::light: return gaussianFiltered(volume, lightSigma, progress);
        case SpeckleReduction::medium: return jointBilateralFiltered(volume, mediumPasses, progress);
        case SpeckleReduction::strong: return jointBilateralFiltered(volume, strongPasses, progress);
    }
    throw std::invalid_argument("quietVolume: no such reduction");
}

std::optional<Volume> reduced(const Volume& volume, SpeckleReduction reduction, const Progress& progress) {
    if (reduction == SpeckleReduction::off) return progress.cancelled() ? std::nullopt : std::optional(volume);
    // The rim is darker than the tissue that it belongs to, more in one voxel than in the next. Without its own
    // surroundings outside, a filter would make teeth of that.
    const FadedRim rim(volume);
    const auto quiet = filtered(rim.without(volume), reduction, progress);
    return quiet ? std::optional(rim.filled(*quiet)) : std::nullopt;
}

}  // namespace

std::optional<Volume> quietVolume(const Volume& volume, SpeckleReduction reduction, const Progress& progress) {
    // Voxels cut by a scalpel still hold echo, and are quieted as if nothing were cut.
    auto quiet = reduced(volume.withCut(nullptr), reduction, progress);
    if (quiet) quiet = quiet->withCut(volume.cut());
    if (quiet) progress.at(1.0);  // another thread, which reports nothing, may have done the last part
    return quiet;
}

}  // namespace echolucent
