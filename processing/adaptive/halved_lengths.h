// Lengths along tube cores for volumes of few voxels.
#pragma once

#include <optional>

#include "processing/adaptive/adaptive_otf_config.h"
#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// The default lengths suit volumes of some 200 units along each axis (Petersch 2005, section 5: 199 x 197 x 199
/// voxels). A volume that is shorter than this along every axis has voxels so coarse that its cavities are shorter than
/// the least fluid.
inline constexpr double coarseUnits = 100.0;
/// The halved run counts if at least this share of the tube cores that meet data have a weight: means over fewer slabs
/// find more by accident. Speckle alone gave 14 of 225 once, the low-resolution adult heart gives 45 of 210 and more.
inline constexpr double leastShareHalved = 1.0 / 8;

/// The config for a volume shorter than coarseUnits along every grid axis, whatever the view, so that turning it
/// changes nothing: cells and all lengths along the tube cores are half as long, rounded up. Empty if the volume is
/// longer, if surfaces are not looked for by ratio, or if a length is not the default one, because then somebody chose
/// it.
[[nodiscard]] std::optional<AdaptiveOtfConfig> halvedLengths(const AdaptiveOtfConfig& config,
                                                             const VolumeGeometry& geometry);

/// The config as the method ran: AdaptiveOtf::config, with halved lengths if AdaptiveOtf::lengthsHalved.
[[nodiscard]] AdaptiveOtfConfig configUsed(const AdaptiveOtf& otf);

}  // namespace echolucent
