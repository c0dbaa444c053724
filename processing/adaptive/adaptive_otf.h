// The adaptive opacity transfer function of Petersch et al. 2005, section 4, as docs/method.md defines it.
#pragma once

#include <optional>

#include "processing/adaptive/adaptive_otf_config.h"
#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/adaptive/quiet_reading.h"
#include "processing/progress.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Runs the method on a volume, seen from a viewpoint. The result is empty only if progress.cancel was raised. Its bits
/// are the same for any number of threads.
/// If no tube core finds a surface behind fluid, and a guess has masked zeros as no data, the method runs again with
/// these zeros as data, dark as fluid. The surfaces found then are where the data begin
/// (AdaptiveOtf::surfacesWhereDataBegin).
/// If the picture shows other voxels than the volume's, pass them as `shown`: the curve is meant for them; surfaces and
/// weights are still the volume's. Throws std::invalid_argument if problemOf(config) is not empty or the shown voxels
/// have another grid.
[[nodiscard]] std::optional<AdaptiveOtf> adaptOpacity(const Volume& volume, const Viewpoint& view,
                                                      const AdaptiveOtfConfig& config, const Progress& progress = {},
                                                      const QuietVoxels& shown = {});

}  // namespace echolucent
