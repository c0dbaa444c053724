// Times ours and VTK's CPU mapper on one scene, in turns.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "processing/ray_caster/ray_caster.h"
#include "tests/benchmarks/bench_scene.h"
#include "tests/benchmarks/coarsest_rays.h"
#include "tests/benchmarks/measured_cost.h"
#include "tests/benchmarks/vtk_scene.h"

namespace echolucent::bench {

/// The medians, and the costs that are paid once.
struct SideBySide {
    Cost ours;          ///< RayCaster::cast(), all of it
    Cost oursFirst;     ///< the first picture under this curve
    Cost oursMasked;    ///< as ours, with the no-data mask, which VTK does not know; 0 if there is none
    Cost oursCoarse;    ///< as ours, with coarser rays and the enlarging to full size; 0 if none are asked for
    Cost oursReaching;  ///< shaded: with light that reaches; its volume is made anew for each frame; else 0
    Cost vtkRays, vtkSetUp, vtkFrame;  ///< see VtkFrameCost
    Cost vtkFirst;                     ///< the first frame under this curve: tables, bricks and (shaded) gradients
    int repeats = 0;                   ///< frames of each in the medians
};

/// What is timed: a prepared caster, VTK's scene with its look set, and the settings without the turn.
struct Contenders {
    const BenchVolume& volume;
    RayCaster& ours;
    RayCaster* oursMasked;  ///< null if there is no mask
    VtkScene& vtk;
    std::optional<RayCoarseness> coarse = std::nullopt;  ///< if set, a second picture of ours is timed with it
};

/// Times ours and VTK in turn, one frame each, at most `repeats` of each. If VTK's frame takes longer than a second,
/// three of each, or `repeats` if that is less. The camera turns a little from frame to frame, the same for both.
[[nodiscard]] SideBySide measureSideBySide(const Contenders& contenders, const OpacityCurve& curve,
                                           const RayCastSettings& look, int size, int repeats);

/// The settings of a frame with another frame's look (step, shading, colour map).
[[nodiscard]] RayCastSettings turnedSettings(const BenchVolume& volume, const RayCastSettings& look, int size,
                                             double turnDegrees);

}  // namespace echolucent::bench
