// Rayleigh speckle: the modulus of complex Gaussian noise. Correlated speckle comes from smoothed noise (Petersch 2005,
// section 5; docs/experiments.md, "The conditions").
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace echolucent {

struct SpeckleConfig {
    std::uint64_t seed = 1;
    std::array<std::int64_t, 3> size{1, 1, 1};  ///< voxels along x, y, z
    double smoothing = 2;  ///< FWHM of the Gaussian that smooths the complex noise, voxels; 0 is uncorrelated
};

/// Taps of the separable smoothing, with the centre in the middle, cut at 3 standard deviations. Their squares add up
/// to 1, so smoothing keeps the noise's variance. Without smoothing there is a single tap of 1.
[[nodiscard]] std::vector<float> speckleTaps(double smoothing);

/// Gives the unit-mean Rayleigh field of slices [first, last) in order of z to `use(z, values, stride)`. Row y begins
/// at values + y * stride. A voxel's value follows from the seed, the smoothing and its index alone. So it has the same
/// bits for any range, thread or instruction set. The field goes on beyond the volume's borders, so they are not
/// special.
using SpeckleUse = std::function<void(std::int64_t z, const float* values, std::int64_t stride)>;
void makeSpeckle(const SpeckleConfig& config, std::int64_t first, std::int64_t last, const SpeckleUse& use);

/// How an echo becomes a stored number.
struct EchoFinish {
    float speckle = 0.5F;    ///< s of 1 + s (R - 1)
    float decibel = 0;       ///< dynamic range of the logarithmic compression; 0 compresses nothing
    float whiteLevel = 255;  ///< stored value of echo 255
};

/// Multiplies `count` echoes (0..255) by 1 + s (R - 1), compresses them as 255 (1 + 20 log10(echo / 255) / decibel),
/// scales to the white level, rounds and clamps to 0..whiteLevel. `rayleigh` may be null (no speckle). All three rows
/// must have room for a multiple of 16 values.
void finishRow(const float* echo, const float* rayleigh, std::int64_t count, const EchoFinish& finish,
               std::uint16_t* stored);

/// `count` rounded up to the room that finishRow() needs.
[[nodiscard]] constexpr std::int64_t paddedRow(std::int64_t count) { return (count + 15) / 16 * 16; }

}  // namespace echolucent
