// The converged picture by an obvious, slow route in double precision, and how far a picture is from it.
#pragma once

#include <string>
#include <vector>

#include "processing/opacity_curve.h"
#include "processing/picture/picture.h"
#include "processing/picture/ray_cast_settings.h"
#include "processing/volume/volume.h"

namespace echolucent::bench {

/// Red, green, blue over black of some of a picture's pixels: every stride-th of every stride-th row, from the first
/// on.
struct ReferencePicture {
    int size = 0;  ///< pixels along each edge of the whole picture
    int stride = 1;
    std::vector<float> rgb;  ///< row-major, what the stride takes only
};

/// Step of the reference, units.
inline constexpr double referenceStep = 0.1;

/// Pixels by PlainCaster (processing/ray_caster/plain/plain_caster.h) with the step referenceStep, until less than 1e-6
/// of the light is left. Every voxel counts as data.
[[nodiscard]] ReferencePicture referencePicture(const Volume& volume, const OpacityCurve& curve,
                                                const RayCastSettings& settings, int stride);

/// The same, kept as a file in `folder` under a hash of everything that goes in, so that it is made once.
[[nodiscard]] ReferencePicture cachedReference(const std::string& folder, const Volume& volume,
                                               const OpacityCurve& curve, const RayCastSettings& settings, int stride);

/// Differences in 8-bit levels (1/255), over red, green and blue.
struct PictureError {
    double rmse = 0.0, largest = 0.0;            ///< over the rays that meet the box, but for a rim along its outline
    double rmseWhole = 0.0, largestWhole = 0.0;  ///< over all pixels: the background counts, and so does the outline
};

/// rgb: the whole picture, three floats a pixel, rows from the top. The rim is 2 pixels (of 512 where there are
/// more) to each side of the outline of the settings' box: VTK does not cast all rays there, and the box's edge is no
/// property of a method.
[[nodiscard]] PictureError errorOf(const std::vector<float>& rgb, const ReferencePicture& reference,
                                   const RayCastSettings& settings);
/// The same against a picture of the same size.
[[nodiscard]] PictureError differenceOf(const std::vector<float>& rgb, const std::vector<float>& other, int stride,
                                        const RayCastSettings& settings);

/// Red, green, blue of a picture over black.
[[nodiscard]] std::vector<float> rgbOf(const Picture& picture);
/// A picture of fewer pixels as a screen of size x size pixels shows it: linear between pixel centres, its outermost
/// pixels beyond.
[[nodiscard]] std::vector<float> enlarged(const Picture& picture, int size);

}  // namespace echolucent::bench
