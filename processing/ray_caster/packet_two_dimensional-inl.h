// Opacities of samples under a two-dimensional OTF.
#include "processing/ray_caster/packet_run-inl.h"

#include <hwy/contrib/math/math-inl.h>

#if defined(ECHOLUCENT_PACKET_TWO_DIMENSIONAL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ECHOLUCENT_PACKET_TWO_DIMENSIONAL_INL
#undef ECHOLUCENT_PACKET_TWO_DIMENSIONAL_INL
#else
#define ECHOLUCENT_PACKET_TWO_DIMENSIONAL_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace echolucent::ray_casting::HWY_NAMESPACE {

/// 1 - (1 - opacity)^units, as opacityForStep().
HWY_INLINE FloatVector opacityOfUnits(FloatVector opacity, FloatVector units) {
    const Floats floats;
    const auto one = set(1.0f);
    const auto isFull = hn::Ge(opacity, one);
    const auto below = hn::IfThenZeroElse(isFull, opacity);
    const auto left = hn::Mul(units, hn::Log1p(floats, hn::Neg(below)));
    return hn::IfThenElse(isFull, one, hn::Neg(hn::Expm1(floats, left)));
}

/// A position's place between `count` nodes: the node before it, and the share of the way to the next node.
struct BetweenNodes {
    IntVector before;
    FloatVector share;
};
HWY_INLINE BetweenNodes betweenNodes(FloatVector position, int count) {
    const auto before = hn::Min(truncated(position), set(static_cast<std::int32_t>(count - 2)));
    return {before, hn::Sub(position, hn::ConvertTo(Floats(), before))};
}

/// Opacity of sample `number` of a run in a step of `units` units, at a known table position. Bilinear between the
/// nodes of the OTF, then corrected for the step. 0 in lanes that are not active.
template <typename Voxel>
HWY_INLINE FloatVector twoDimensionalOpacity(const KernelJob<Voxel>& job, const Run<Voxel>& run, FloatVector number,
                                             FloatVector position, LaneMask active, FloatVector units) {
    const Floats floats;
    const TwoDimensionalNodes& nodes = *job.twoDimensional;
    active = hn::And(active, hn::Gt(position, set(nodes.firstVisible)));
    if (hn::AllFalse(floats, active)) return set(0.0f);
    const Position exact = run.at(number), place = job.nearest ? nearestVoxel(exact) : exact;
    // Gradients are in the same order as voxels.
    const std::uint8_t* const cubes = nodes.cubes + (run.volume.cubes - job.voxels->cubes());
    const auto gradient = meanOfBytes(cubes, run.volume.sliceStride, run.volume.offsetOf(place), place, active);
    constexpr float perPosition = 1.0f / TransferTable::intervals, perGradient = 1.0f / (byteScale * 255.0f);
    const auto f = betweenNodes(hn::Mul(position, set(perPosition * static_cast<float>(nodes.intensities - 1))),
                                nodes.intensities);
    const auto g =
        betweenNodes(hn::Mul(gradient, set(perGradient * static_cast<float>(nodes.gradients - 1))), nodes.gradients);
    const auto index = hn::Add(hn::Mul(g.before, set(static_cast<std::int32_t>(nodes.intensities))), f.before);
    const auto row = [&](const float* from) {
        return between(loadEntries(from, index), loadEntries(from + 1, index), f.share);
    };
    const auto opacity =
        hn::IfThenElseZero(active, between(row(nodes.opacities), row(nodes.opacities + nodes.intensities), g.share));
    return job.stepUnits == 1.0f && hn::AllTrue(floats, hn::Eq(units, set(1.0f))) ? opacity
                                                                                  : opacityOfUnits(opacity, units);
}

}  // namespace echolucent::ray_casting::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
