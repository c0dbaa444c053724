// The scenes that are rendered: volumes, curves and the rays that every renderer gets.
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
        masked;      ///< with the no-data mask that the program uses; null if the mask marks nothing
    Viewpoint view;  ///< an oblique view, along no axis of the grid
};

/// A volume that could not be loaded or made, and why.
struct Skipped {
    std::string volume, reason;
};

/// The phantoms of 199x197x199 voxels, and those real volumes that are in `folder`.
[[nodiscard]] std::vector<BenchVolume> benchVolumes(const std::string& folder, std::vector<Skipped>& skipped);
/// A phantom of `size` voxels under default conditions.
[[nodiscard]] BenchVolume benchPhantom(PhantomScene scene, const std::array<std::int64_t, 3>& size);
/// The volume with twice the voxels along each axis (trilinear). The outermost voxel centres stay.
[[nodiscard]] BenchVolume doubled(const BenchVolume& volume);

struct NamedCurve {
    std::string name;
    OpacityCurve curve;
};
/// "linear" (Petersch 2005, eq. 1), "parabolic" (0.5 x^2), "adaptive" (the default method for the volume's view).
[[nodiscard]] std::vector<NamedCurve> benchCurves(const BenchVolume& volume);
[[nodiscard]] NamedCurve parabolicCurve();

/// Ours and the reference's settings for a picture of size x size pixels. The projection is parallel. The volume fills
/// two thirds of the picture's width or height. Rays are cast only between the outermost voxel centres, where VTK has
/// its volume. Sample planes are counted from that box's foremost corner. turnDegrees turns the view about `down`
/// without moving the volume.
[[nodiscard]] RayCastSettings benchSettings(const BenchVolume& volume, int size, double turnDegrees = 0.0);

/// Degrees of the camera's turn between timed frames, so that nothing of the picture before can be used again.
inline constexpr double turnBetweenFrames = 0.01;

}  // namespace echolucent::bench
