// The parts of `study quiet`: which filters are compared, and what is measured of each.
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
    std::string name;        ///< what it does
    std::string setting;     ///< the reduction it stands behind; empty where none
    SpeckleReduction named;  ///< that reduction, as the curve is told; where `setting` is empty, the nearest
    std::function<Volume(const Volume&)> run;
};
/// The voxels as they are, Gaussians, and the filters behind every reduction.
[[nodiscard]] std::vector<QuietFilter> quietFilters();

/// What is left of known structures, measured on small volumes with speckle of s = 0.5 and a FWHM of 2 voxels. Fluid is
/// 14, tissue 85, object 170. Noise is averaged out along the structure.
struct StructureError {
    double planeShift = 0.0;   ///< units by which the middle of a plane's ramp of 4 units moves, to either side
    double sphereShift = 0.0;  ///< the same on a sphere with a radius of 12 units; below 0 where it shrinks
    double membrane = 0.0;     ///< contrast of a membrane of tissue, 2 voxels thick, in fluid; share of what was there
    double finger = 0.0;       ///< contrast on the axis of a finger of object in fluid, 4 voxels thick; share
};
[[nodiscard]] StructureError structureErrorOf(const QuietFilter& filter, std::uint64_t seed);

/// Wall time of a filter, ms per million voxels of 8 bits: the median of `repeats` runs.
struct QuietTimes {
    double whole = 0.0;   ///< all voxels are data
    double masked = 0.0;  ///< a sector of two thirds of the voxels is
};
[[nodiscard]] QuietTimes quietTimesOf(const QuietFilter& filter, int edge, int repeats);

/// CNR_S of the default reading's curve on the quiet voxels, for which it is meant.
[[nodiscard]] std::optional<double> quietContrastOf(const StudyPhantom& phantom, const std::vector<SurfaceRay>& rays,
                                                    const QuietFilter& filter);

}  // namespace echolucent::cli
