// The slow, obvious route from volume to picture: what the fast one is measured against.
#pragma once

#include <optional>
#include <string_view>

#include "processing/ray_caster.h"

namespace echolucent {

/// How a pixel's colour and transmittance are stored after every sample; all that is computed in between is double.
enum class CompositingPrecision {
    eightBit,  ///< a frame buffer's bytes: rounded to the nearest 1/255, as graphics cards blended around 2000
    half,      ///< IEEE 754 binary16, round to nearest even
    single,    ///< binary32
    twofold,   ///< binary64
};

/// "8 bit", "half", "single", "double".
[[nodiscard]] std::string_view nameOf(CompositingPrecision precision);

struct PlainCasting {
    CompositingPrecision precision = CompositingPrecision::twofold;
    /// A sample that adds less than this to its pixel's opacity is lit as if there were no surface (w = 0 of Shading).
    /// 0: every sample is lit by its gradient, so that small steps converge; castRays() uses 1/128.
    double leastLitOpacity = 0.0;
    /// Steps are cut where what is rendered begins and ends (volume and render box, near plane, clipping planes, opaque
    /// depth): what is left counts with its length, sampled in its middle. Else each sample counts with a whole step or
    /// not at all, as castRays() documents, and a ray errs by up to half a step at either end: on opaque faces of the
    /// box by many levels, still at steps of 0.1. Converged references cut.
    bool cutsSteps = false;
    friend bool operator==(const PlainCasting&, const PlainCasting&) = default;
};

/// The picture that castRays() documents, sample by sample in double: the same rays, pixel centres and sample places;
/// opacity and colour straight from the curve and the colour map, without a table; nothing is skipped, and a ray ends
/// early only where terminationTransmittance is above 0. Unless steps are cut, a sample counts where its place, the
/// middle of its step, lies in the volume's box and in the render box (low corner included, high corner not), on each
/// clipping plane or on the side that its normal points to, and nearer than the opaque depth of its pixel. Places in
/// the outermost half voxel are read at the outermost voxel centres.
///
/// Pre-integration (direct mode, unshaded): sample k stands for the segment of one step around it. With s0 and s1 the
/// intensities at the segment's ends, half a step before and behind the sample (clamped to the outermost voxel centres
/// where they lie outside, and read also where the render box or a plane ends between), and
/// tau(s) = min(-log(1 - opacity(s)), 40) the extinction per unit,
///     alpha  = 1 - exp(-step * mean of tau over [s0, s1])
///     colour = mean of colour(s) tau(s) over [s0, s1] / mean of tau over [s0, s1]
/// and where s0 = s1 the values of that intensity. An end without data makes its half of the step transparent; the
/// other half takes the intensity of the end that has data.
///
/// Depth colouring is applied after the light. Empty only where progress.cancel was raised (polled once a row). Uses
/// the calling thread's oneTBB arena; the same pixels for any number of threads. Throws std::invalid_argument where
/// castRays() does, and for jittered rays, whose places castRays() keeps to itself.
[[nodiscard]] std::optional<Picture> castRaysPlainly(const Volume& volume, const OpacityCurve& curve,
                                                     const RayCastSettings& settings, const PlainCasting& casting = {},
                                                     const Progress& progress = {});

}  // namespace echolucent
