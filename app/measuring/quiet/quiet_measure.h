// The parts of `study quiet`: the compared filters, and the measures of each.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/measuring/study_phantoms.h"
#include "processing/volume/volume.h"

namespace echolucent::cli {

/// One way to make voxels quiet.
struct QuietFilter {
    std::string name;        ///< its work in words
    std::string setting;     ///< the reduction that uses it; empty if none
    SpeckleReduction named;  ///< the reduction that adaptOpacity() is told: that of `setting`; light if that is empty
    std::function<Volume(const Volume&)> run;
};
/// The unfiltered voxels, Gaussians, and the filters of all reductions.
[[nodiscard]] std::vector<QuietFilter> quietFilters();

/// The loss of known structures, on small volumes with speckle of s = 0.5 and a FWHM of 2 voxels. Fluid is 14, tissue
/// 85, object 170. Means along the structure remove the noise.
struct StructureError {
    double planeShift = 0.0;   ///< how far the middle of a plane's ramp moves, units, without a sign; the ramp has 4
    double sphereShift = 0.0;  ///< how much a sphere of radius 12 units grows, units; below 0 if it shrinks
    double membrane = 0.0;     ///< remaining share of the contrast of a membrane of tissue in fluid, 2 voxels thick
    double finger = 0.0;       ///< remaining share of the contrast on the axis of a finger of object, 4 voxels thick
};
[[nodiscard]] StructureError structureErrorOf(const QuietFilter& filter, std::uint64_t seed);

/// Wall time of a filter, ms per million voxels of 8 bits: the median of `repeats` runs.
struct QuietTimes {
    double whole = 0.0;   ///< all voxels are data
    double masked = 0.0;  ///< two thirds of the voxels, a sector, are data
};
[[nodiscard]] QuietTimes quietTimesOf(const QuietFilter& filter, int edge, int repeats);

/// CNR_S of the default reading's curve, on the quiet voxels for which it is made.
[[nodiscard]] std::optional<double> quietContrastOf(const StudyPhantom& phantom, const std::vector<SurfaceRay>& rays,
                                                    const QuietFilter& filter);

}  // namespace echolucent::cli
