// What is rendered: volumes, curves and the rays that every renderer gets.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "processing/opacity_curve.h"
#include "processing/phantom/phantom.h"
#include "processing/picture/ray_cast_settings.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent::bench {

struct BenchVolume {
    std::string name;
    std::shared_ptr<const Volume> volume;  ///< every voxel counts as data, because VTK knows no mask
    std::shared_ptr<const Volume>
        masked;      ///< with the no-data mask that the program uses; null where the mask marks nothing
    Viewpoint view;  ///< an oblique view, along no axis of the grid
};

/// A volume that could not be had, and why.
struct Skipped {
    std::string volume, reason;
};

/// The phantoms of 199x197x199 voxels and the real volumes of `folder` that are there.
[[nodiscard]] std::vector<BenchVolume> benchVolumes(const std::string& folder, std::vector<Skipped>& skipped);
/// A phantom of the default conditions with this many voxels an edge.
[[nodiscard]] BenchVolume benchPhantom(PhantomScene scene, const std::array<std::int64_t, 3>& size);
/// The volume with twice the voxels along each axis over the same extent between the outermost voxel centres
/// (trilinear).
[[nodiscard]] BenchVolume doubled(const BenchVolume& volume);

struct NamedCurve {
    std::string name;
    OpacityCurve curve;
};
/// "linear" (Petersch 2005, eq. 1), "parabolic" (0.5 x^2), "adaptive" (the default method for the volume's view).
[[nodiscard]] std::vector<NamedCurve> benchCurves(const BenchVolume& volume);
[[nodiscard]] NamedCurve parabolicCurve();

/// Ours and the reference's settings for a picture of size x size pixels: parallel, the volume two thirds of the
/// picture's width or height, rays only between the outermost voxel centres, where VTK has its volume, and sample
/// planes counted from that box's foremost corner. turnDegrees turns the view about `down` without moving the volume.
[[nodiscard]] RayCastSettings benchSettings(const BenchVolume& volume, int size, double turnDegrees = 0.0);

/// Degrees by which the camera is turned between frames that are timed, so that nothing of a picture may be had from
/// the one before.
inline constexpr double turnBetweenFrames = 0.01;

}  // namespace echolucent::bench
