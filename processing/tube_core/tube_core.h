// A tube core: a column of cells along the view direction, and what was found on it (Petersch 2005, section 4.1).
#pragma once

#include <optional>
#include <vector>

#include "processing/volume/geometry.h"

namespace echolucent {

enum class TubeStatus {
    surface,  ///< an interface was detected with at least one complete prior cell (readSurface())
    none,     ///< no interface was detected, or none with a complete prior cell; d is 0
    outside,  ///< the axis misses the volume or meets no data, or the tube core is never placed
              ///< (TubeGrid::withoutTubes); it does not count in T and N
};

/// One tube core. Intensities are normalised, lengths in units (the volume's smallest spacing), positions in voxel
/// index space.
struct TubeCore {
    int column = 0;  ///< u: index along the view's right axis
    int row = 0;     ///< v: index along the view's down axis
    TubeStatus status = TubeStatus::outside;
    /// Where the picture begins on the tube core's axis (TubeAxis::entryVoxel). Not set if `status` is outside.
    std::optional<Vec3> entryVoxel;
    std::optional<Vec3> surfaceVoxel;       ///< centre of the detected cell on the axis
    Vec3 firstSampleVoxel{0, 0, 0};         ///< axis position of sample 0
    int firstCell = 0;                      ///< the tube begins here: earlier cells hold too little data
    int surfaceCell = -1;                   ///< s_t, index into cellMeans; -1 if there is no surface
    std::optional<double> lowIntensity;     ///< I_L: mean of the last SurfaceRule::lowReach cells that end before the
                                            ///< surface cell; of all prior cells if lowReach is 0 or no cell ends there
    std::optional<double> highIntensity;    ///< I_H: largest cell mean from the surface cell to
                                            ///< SurfaceRule::highReach cells behind it
    std::optional<double> lowIntensityMax;  ///< largest mean of all prior cells (eq. 8)
    std::optional<double> slope;            ///< S: intensity per unit; may be negative
    std::optional<double> edgeToNoise;      ///< rise from the median prior cell mean to the cell mean
                                            ///< SurfaceRule::slopeHalfStep behind the surface, over the scatter of the
                                            ///< prior cell means; not set if there are too few prior cells
    std::optional<double> contrast;         ///< detection by ratio: contrast at the surface, in standard deviations of
                                            ///< a slab's voxels
    std::optional<double> fluidSpread;      ///< detection by ratio: standard deviation of voxels around I_L (speckle)
    double intensityWeight = 0.0;           ///< w_I, eq. 9
    double slopeWeight = 0.0;               ///< w_S, eq. 10
    double extraWeight = 1.0;  ///< 0 if I_H <= I_L (eq. 6 has no meaning then), or if VarianceRule::leastEdgeToNoise is
                               ///< above 0 and the edge to noise is not set or below it; else 1
    double d = 0.0;            ///< d_t = d_max w_I w_S extraWeight, eq. 11

    std::vector<float> cellMeans;          ///< mean normalised intensity of cell i (samples i ... i + cell size - 1)
    std::vector<float> interfaceFunction;  ///< the interface indicating function of cell i: the variance of normalised
                                           ///< intensity or, by ratio, the contrast at the cell's middle
    std::vector<int> trackedCells;         ///< detection by variance, for Fig. 4: the detected cell at each scale, from
                                           ///< the coarsest with a maximum to the finest; the unsmoothed function last
};

}  // namespace echolucent
