// The adaptive opacity transfer function of Petersch et al. 2005, section 4, as docs/method.md defines it: values in,
// the curve and everything that led to it out.
#pragma once

#include <optional>

#include "processing/adaptive/adaptive_otf_config.h"
#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/adaptive/quiet_reading.h"
#include "processing/progress.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Runs the method on a volume, seen from a viewpoint. Where no tube core finds a surface behind fluid, and a guess has
/// taken zeros for no data, it looks once more with these zeros as data, dark as fluid: the surfaces are then where the
/// data begin (AdaptiveOtf::surfacesWhereDataBegin). The result is empty only where progress.cancel was raised, and
/// has the same bits for any number of threads.
/// Where the picture is taken from other voxels than the volume's, `shown` is what they are, and the curve is meant for
/// them; surfaces and weights are the volume's. Without them the curve is meant for the volume's own voxels.
/// It throws std::invalid_argument where problemOf(config) is not empty, or where the shown voxels have another grid.
[[nodiscard]] std::optional<AdaptiveOtf> adaptOpacity(const Volume& volume, const Viewpoint& view,
                                                      const AdaptiveOtfConfig& config, const Progress& progress = {},
                                                      const QuietVoxels& shown = {});

}  // namespace echolucent
