// The ramp that shows every surface that the tube cores found at its place: the aim *every wall*.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "processing/progress.h"
#include "processing/tube_core/slabs/tube_samples.h"
#include "processing/tube_core/tube_core.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// A ramp over normalised intensity: clear up to `begin`, of `opacity` per unit from `end` on, linear between.
struct FoundRamp {
    double begin = 0.0, end = 1.0;  ///< begin < end; end may lie above 1
    double opacity = 1.0;           ///< (0,1]
    friend bool operator==(const FoundRamp&, const FoundRamp&) = default;
};
[[nodiscard]] double opacityAt(const FoundRamp& ramp, double intensity);

/// What a ray along a tube core's axis meets, from the tube core's first sample to missedUnits behind its surface.
struct AxisProfile {
    std::vector<float> intensities;  ///< normalised, one unit apart; NaN without data
    double surface = 0.0;            ///< of the surface, samples behind the first; may lie between two samples
};
/// The profiles of all tube cores with a weight, in their order, trilinear in the shown voxels. `samples` are those
/// that the tube cores were read with. If the work is cancelled, some profiles stay empty.
[[nodiscard]] std::vector<AxisProfile> axisProfiles(const Volume& shown, std::span<const TubeSamples> samples,
                                                    std::span<const TubeCore> tubes, const CellRule& rule,
                                                    const Progress& progress = {});

/// How right a ramp shows the surfaces of profiles, [0,1]: the mean over the profiles of 1 if half of the light is held
/// back (sampleAtHalf()) at most 2 units from the surface. That falls to 0 at 3 units before and at missedUnits behind
/// the surface: early counts more than late. 0 without a profile.
[[nodiscard]] double shownRight(std::span<const AxisProfile> profiles, const FoundRamp& ramp);
inline constexpr double missedUnits = 6.0;

/// The ramp for the surfaces of profiles. Tried are 32 ramps, half of the way from I_L to I_H wide, with opacities 1,
/// 0.7, 0.5 and 0.35. They begin up to 0.245 of that way before and behind the middle: 0.25 of the way, or two spreads
/// of the fluid if that is farther from I_L. The result is their mean (of begin, and of the logarithm of opacity),
/// weighted by exp(shownRight / 0.6). So it moves smoothly with the view: the best one alone would jump
/// (docs/experiments.md, "The aim"). I_L, I_H and the spread are plain means over the tube cores with a weight: a large
/// weight counts no more than a small one, because the ramp is to show every surface. Empty if no tube core has a
/// weight. The bits are the same for any number of threads.
[[nodiscard]] std::optional<FoundRamp> rampForEveryWall(std::span<const AxisProfile> profiles,
                                                        std::span<const TubeCore> tubes);

}  // namespace echolucent
