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
    /// A step that adds less than this to its pixel's opacity is lit as if there were no surface (w = 0 of Shading).
    /// 0: every step is lit by its gradient, so that pictures converge; castRays() uses min(1, step) / 128.
    double leastLitOpacity = 0.0;
    /// No step is cut: each counts whole where its middle is rendered, else not at all, as many volume renderers do. A
    /// ray then errs by up to half a step at either end: on opaque faces of the box by many levels, still at steps of
    /// 0.1.
    bool wholeSteps = false;
    friend bool operator==(const PlainCasting&, const PlainCasting&) = default;
};

/// The picture that castRays() documents, step by step in double: the same rays and places of samples; opacity and
/// colour straight from the curve and the colour map, without a table; nothing is skipped, and a ray ends early only
/// where terminationTransmittance is above 0, after the very step that falls below it. Places in the outermost half
/// voxel are read at the outermost voxel centres.
///
/// Pre-integration (direct mode, unshaded; not of steps that are cut): with s0 and s1 the intensities at the step's
/// ends and tau(s) = min(-log(1 - opacity(s)), 40) the extinction per unit,
///     opacity   = 1 - exp(-step * mean of tau over [s0, s1])
///     intensity = mean of s tau(s) over [s0, s1] / mean of tau over [s0, s1], whose colour is shown
/// and where s0 = s1 those of that intensity. An end without data makes its half of the step transparent; the other
/// half takes the intensity of the end that has data.
///
/// Depth colouring is applied after the light. Empty only where progress.cancel was raised (polled once a row). Uses
/// the calling thread's oneTBB arena; the same pixels for any number of threads. Throws std::invalid_argument where
/// castRays() does.
[[nodiscard]] std::optional<Picture> castRaysPlainly(const Volume& volume, const OpacityCurve& curve,
                                                     const RayCastSettings& settings, const PlainCasting& casting = {},
                                                     const Progress& progress = {});

}  // namespace echolucent
