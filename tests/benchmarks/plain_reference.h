// Makes the converged picture by an obvious, slow route in double precision, and measures pictures against it.
#pragma once

#include <string>
#include <vector>

#include "processing/opacity_curve.h"
#include "processing/picture/picture.h"
#include "processing/picture/ray_cast_settings.h"
#include "processing/volume/volume.h"

namespace echolucent::bench {

/// Red, green, blue over black of some of a picture's pixels: every stride-th pixel of every stride-th row, from the
/// first on.
struct ReferencePicture {
    int size = 0;  ///< pixels along each edge of the whole picture
    int stride = 1;
    std::vector<float> rgb;  ///< row-major, only the pixels that the stride takes
};

/// Step of the reference, units.
inline constexpr double referenceStep = 0.1;

/// Pixels by PlainCaster (processing/ray_caster/plain/plain_caster.h) with the step referenceStep, until less than 1e-6
/// of the light is left. Every voxel counts as data.
[[nodiscard]] ReferencePicture referencePicture(const Volume& volume, const OpacityCurve& curve,
                                                const RayCastSettings& settings, int stride);

/// The same, kept as a file in `folder` under a hash of all inputs, so that it is made only once.
[[nodiscard]] ReferencePicture cachedReference(const std::string& folder, const Volume& volume,
                                               const OpacityCurve& curve, const RayCastSettings& settings, int stride);

/// Differences in 8-bit levels (1/255), over red, green and blue.
struct PictureError {
    double rmse = 0.0, largest = 0.0;            ///< over the rays that meet the box, without a rim along its outline
    double rmseWhole = 0.0, largestWhole = 0.0;  ///< over all pixels, background and outline included
};

/// rgb: the whole picture, three floats a pixel, rows from the top. The rim is 2 pixels to each side of the box's
/// outline (of 512 pixels; more in larger pictures). VTK does not cast all rays there, and the box's edge is no
/// property of a method.
[[nodiscard]] PictureError errorOf(const std::vector<float>& rgb, const ReferencePicture& reference,
                                   const RayCastSettings& settings);
/// The same for two pictures of the same size.
[[nodiscard]] PictureError differenceOf(const std::vector<float>& rgb, const std::vector<float>& other, int stride,
                                        const RayCastSettings& settings);

/// Red, green, blue of a picture over black.
[[nodiscard]] std::vector<float> rgbOf(const Picture& picture);
/// A picture of fewer pixels as a screen of size x size pixels shows it: linear between pixel centres. Beyond them the
/// outermost pixels go on.
[[nodiscard]] std::vector<float> enlarged(const Picture& picture, int size);

}  // namespace echolucent::bench
