// Lengths along tube cores for volumes of few voxels.
#pragma once

#include <optional>

#include "processing/adaptive/adaptive_otf_config.h"
#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// The default lengths suit volumes some 200 units deep (Petersch 2005, section 5: 199 x 197 x 199 voxels). A volume
/// below this depth has voxels so coarse that its cavities are shorter than the least fluid.
inline constexpr double shallowUnits = 100.0;

/// The config for a volume less than shallowUnits deep along the view: cells and all lengths along the tube cores are
/// half as long, rounded up. Empty if the volume is deeper, if surfaces are not looked for by ratio, or if a length is
/// not the default one, because then somebody chose it.
[[nodiscard]] std::optional<AdaptiveOtfConfig> halvedLengths(const AdaptiveOtfConfig& config,
                                                             const VolumeGeometry& geometry, const Viewpoint& view);

/// The config as the method ran: AdaptiveOtf::config, with halved lengths if AdaptiveOtf::lengthsHalved.
[[nodiscard]] AdaptiveOtfConfig configUsed(const AdaptiveOtf& otf);

}  // namespace echolucent
