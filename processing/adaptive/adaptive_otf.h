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

/// Runs the method on a volume, seen from a viewpoint. The result is empty only if progress.cancel was raised. The bits
/// of the result are the same for any number of threads.
///
/// If no tube core finds a surface behind fluid, and the volume is coarse, the method runs again with halvedLengths().
/// If enough tube cores then have a weight (leastShareHalved), that is the result (AdaptiveOtf::lengthsHalved).
///
/// If still no tube core finds a surface behind fluid, and zeros are masked as no data (by a guess or by the file), the
/// method runs again with these zeros as data, dark as fluid. If a tube core then has a weight, the surfaces are where
/// the data begin (AdaptiveOtf::surfacesWhereDataBegin), and the curve stays the initial function. Else the first run's
/// result is returned.
///
/// If the picture shows other voxels than the volume's, pass them as `shown`: the curve is then made for the shown
/// voxels, while surfaces and weights are still the volume's. Throws std::invalid_argument if problemOf(config) is not
/// empty or the shown voxels have a grid of another size.
[[nodiscard]] std::optional<AdaptiveOtf> adaptOpacity(const Volume& volume, const Viewpoint& view,
                                                      const AdaptiveOtfConfig& config, const Progress& progress = {},
                                                      const QuietVoxels& shown = {});

}  // namespace echolucent
