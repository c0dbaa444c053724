// Points, directions and rotations. "Grid mm" is a frame in mm along the voxel grid's axes, with its origin at the
// centre of voxel (0,0,0). Tube cores, rays, cameras and light are given in it. The patient frame is DICOM's LPS.
#pragma once

#include <opencv2/core/matx.hpp>

namespace echolucent {

using Vec3 = cv::Vec3d;
using Mat3 = cv::Matx33d;

/// The Euclidean length.
[[nodiscard]] double length(const Vec3& vector);
/// The vector divided by its length. A vector of length 0 or with a NaN is a broken contract (std::invalid_argument).
[[nodiscard]] Vec3 normalized(const Vec3& vector);
/// The same angle in (-180, 180] degrees.
[[nodiscard]] double wrappedDegrees(double degrees);
/// Right-handed rotations about the grid axes; the angle is in degrees. At multiples of 90 degrees the elements are
/// exactly 0, 1 and -1.
[[nodiscard]] Mat3 rotationX(double degrees);
[[nodiscard]] Mat3 rotationY(double degrees);
[[nodiscard]] Mat3 rotationZ(double degrees);

}  // namespace echolucent
