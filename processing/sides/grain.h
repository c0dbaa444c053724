// How fine the grain of the echo is, along each grid axis.
#pragma once

#include <optional>

#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// The grain along the grid axes, mm: the full width at half maximum of the autocorrelation of the voxels, less their
/// mean over a tenth of the data's extent along the axis. It measures speckle and resolution together; taking off the
/// mean narrows it, along all axes alike. It is at least two voxels, because nothing finer can be told. It is two
/// voxels too if an axis has too little echo. At most 1,500 rows of voxels are read along each axis. The result has the
/// same bits for any number of threads, and is empty only if progress.cancel was raised.
[[nodiscard]] std::optional<Vec3> grainMm(const Volume& volume, const Progress& progress = {});

/// The grain along a unit vector, mm, if it is an ellipsoid with these axes.
[[nodiscard]] double grainAlong(const Vec3& direction, const Vec3& grainMm);

}  // namespace echolucent
