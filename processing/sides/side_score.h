// How much a side shows of what lies behind fluid.
#pragma once

#include <vector>

#include "processing/near_cut/near_cut.h"
#include "processing/near_cut/seen_fluid.h"
#include "processing/volume/geometry.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// How fine the grain is in a side's picture.
struct PictureFineness {
    double resolution = 1.0;  ///< root of the grain's area in the finest side's picture over that in this one, (0,1]
    /// The grain along the lateral direction over that along the elevation, at most 1. It is 1 onto the scan plane, and
    /// if the planes are not sure.
    double plane = 1.0;
    friend bool operator==(const PictureFineness&, const PictureFineness&) = default;
};

/// The score of a side (docs/sides.md). A tube core is *open* if it begins in fluid, behind the front or where the data
/// begin, and a wall stands behind that fluid: the picture shows a surface there. Lengths are shares of the data's
/// extent (SmoothEcho::dataExtentMm()). A side scores nothing if what it shows is not to be trusted: no fluid was
/// found; the cut of a wall before it is not sure; the data begin in fluid, but not surely, or what they begin in is
/// not clearly darker than dim tissue. The last does not hold along a sure beam: the border of a sector is dim, and it
/// lies across the beam.
struct SideScore {
    double opened = 0.0;     ///< open tube cores, as a share of all that meet data behind the front, [0,1]
    double area = 0.0;       ///< the area of the open ones, as a share of the square of the data's extent
    double depth = 0.0;      ///< root mean square of the depth of fluid before the surfaces
    double contrast = 0.0;   ///< mean FluidStretch::contrast of the fluid before the surfaces, weighted by length
    double wholeness = 0.0;  ///< rim of a disc as large as the open area, over its own rim: speckle tears it, (0,1]
    double shown = 0.0;      ///< share of the picture that is not dark to its end, [0,1]
    PictureFineness fineness{};
    double total = 0.0;  ///< what sides are compared by, >= 0
    friend bool operator==(const SideScore&, const SideScore&) = default;
};

/// Where a side without its own cuts shows something, with the front that it has without asking: of each tube core the
/// first sample behind the front. The front is the bowed surface if there is one, else the flat cut. 0 without a sure
/// front.
[[nodiscard]] std::vector<int> firstShownSamples(const SeenFluid& seen, const VolumeGeometry& geometry,
                                                 const NearCutFinding& front);

/// The score of a side that `seen` looked along and `front` was found for, of a volume with `geometry`. `alongBeam`:
/// whether the side surely looks from the probe.
[[nodiscard]] SideScore scoreOf(const SeenFluid& seen, const VolumeGeometry& geometry, const NearCutFinding& front,
                                bool alongBeam, const PictureFineness& fineness);

}  // namespace echolucent
