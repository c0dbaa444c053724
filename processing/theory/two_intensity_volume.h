// The two-intensity model as a volume, its picture by the ray caster, and what speckle makes of it.
#pragma once

#include <cstdint>

#include "processing/opacity_curve.h"
#include "processing/picture/ray_cast_settings.h"
#include "processing/theory/two_intensities.h"
#include "processing/volume/volume.h"

namespace echolucent {

struct TwoIntensityVolume {
    TwoIntensities model;      ///< its thicknesses together from 1 to 4096 units
    int edge = 16;             ///< voxels across the field each way, [2, 1024]
    double speckle = 0.0;      ///< s of 1 + s (R - 1), as PhantomConfig::speckle
    double speckleSize = 2.0;  ///< as PhantomConfig::speckleSize
    std::uint64_t seed = 1;
    friend bool operator==(const TwoIntensityVolume&, const TwoIntensityVolume&) = default;
};
/// A field of two halves, seen along +z: on the left fluid all the way, on the right fluid and then tissue. There is no
/// ramp between them and no change of gain. Voxels have edges of 1 mm and 16 bits: intensities err by at most 1/131070.
/// Echoes above white become white. The bits do not depend on the number of threads. Throws std::invalid_argument for
/// values out of range.
[[nodiscard]] Volume makeTwoIntensityVolume(const TwoIntensityVolume& wanted);

/// How the picture is made that eqs. 2 and 3 describe: a pixel for each column of voxels, a parallel view along +z,
/// linear greys, no light, a sample in the middle of each voxel, and rays that end only behind the last one.
[[nodiscard]] RayCastSettings theorySettings(const VolumeGeometry& geometry);

/// The pixels of one half of the field.
struct HalfField {
    double mean = 0.0;    ///< share of white
    double spread = 0.0;  ///< standard deviation between pixels
    double least = 0.0, most = 0.0;
};
struct MeasuredPixels {
    HalfField fluid, tissue;
};
/// The picture of a volume of makeTwoIntensityVolume() by castRays(), over the background.
[[nodiscard]] MeasuredPixels measuredPixels(const Volume& volume, const OpacityCurve& curve, double background);

/// A layer of a model as rays meet it in the mean over uncorrelated speckle. Samples are then independent, so that the
/// mean of eq. 3 is eq. 3 with the means of alpha and of c alpha: the opacity is the mean of alpha, the intensity the
/// mean of c alpha over it. Speckle brightens, because brighter voxels are more opaque too. Correlated speckle has
/// other means of products.
[[nodiscard]] RayLayer speckledLayer(const RayLayer& layer, const OpacityCurve& curve, double speckle);
/// The mean pixels of a model with uncorrelated speckle. Throws as layersOf() does.
[[nodiscard]] ModelPixels speckledPixelsOf(const TwoIntensities& model, const OpacityCurve& curve, double speckle);

}  // namespace echolucent
