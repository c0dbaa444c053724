#include "tests/benchmarks/kernel_floor.h"

#include <algorithm>

#include "processing/ray_caster/packet_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/benchmarks/kernel_floor.cpp"
#include <hwy/foreach_target.h>

#include "processing/ray_caster/packet_run-inl.h"

HWY_BEFORE_NAMESPACE();
namespace echolucent::ray_casting::HWY_NAMESPACE {

/// The difference of two samples along an axis. Their places stay within the outermost voxels.
HWY_INLINE FloatVector differenceAlong(const KernelJob<std::uint8_t>& job, const Run<std::uint8_t>& run,
                                       const Position& at, IntVector Position::*along, std::size_t axis,
                                       LaneMask active) {
    const auto place = [&](std::int64_t cube) {
        return set(
            static_cast<std::int32_t>(std::clamp<std::int64_t>(cube - run.corner[axis], -32767, 32767) * oneCube));
    };
    const auto first = place(cubeShift), last = place(cubeShift + job.geometry.size[axis] - 1);
    const auto reach = set(static_cast<std::int32_t>(job.light->reach[axis] * oneCube));
    Position before = at, behind = at;
    before.*along = hn::Max(hn::Sub(before.*along, reach), first);
    behind.*along = hn::Min(hn::Add(behind.*along, reach), last);
    return hn::Sub(meanOf(run.volume, run.volume.offsetOf(behind), behind, active),
                   meanOf(run.volume, run.volume.offsetOf(before), before, active));
}

template <bool withGradients>
double sumOf(const KernelJob<std::uint8_t>& job) {
    const Floats floats;
    constexpr int group = 8;
    auto sum = set(0.0f);
    double total = 0.0;
    for (int row = 0; row < job.picture->height; row += packetRows)
        for (int column = 0; column < job.picture->width; column += packetColumns) {
            const Packet<std::uint8_t> packet(job, PacketPixels::block(column, row, 1));
            if (packet.empty() || packet.longestCommonRun() < group) continue;
            for (std::int64_t next = packet.first(); next < packet.last();) {
                const Run<std::uint8_t> run = packet.run(next, packet.longestCommonRun(), -1);
                for (std::int64_t i = 0; i + group <= run.count; i += group) {
                    FloatVector value[group];
                    for (int k = 0; k < group; ++k) {
                        const auto number = set(static_cast<float>(i + k));
                        const Position at = run.at(number);
                        value[k] = meanOf(run.volume, run.volume.offsetOf(at), at, run.inRange(number));
                    }
                    for (int k = 0; k < group; ++k) sum = hn::Add(sum, value[k]);
                    if constexpr (withGradients)
                        for (int k = 0; k < group; ++k) {
                            const auto number = set(static_cast<float>(i + k));
                            const Position at = run.at(number);
                            const LaneMask active = run.inRange(number);
                            const FloatVector x = differenceAlong(job, run, at, &Position::x, 0, active);
                            const FloatVector y = differenceAlong(job, run, at, &Position::y, 1, active);
                            const FloatVector z = differenceAlong(job, run, at, &Position::z, 2, active);
                            const auto square = hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)));
                            const auto share = hn::Div(square, hn::Add(square, set(job.light->floorSquare)));
                            const auto towards = hn::MulAdd(x, set(job.light->towardsLight[0]),
                                                            hn::MulAdd(y, set(job.light->towardsLight[1]),
                                                                       hn::Mul(z, set(job.light->towardsLight[2]))));
                            const auto facing = hn::Div(towards, hn::Sqrt(hn::Add(square, set(1e-12f))));
                            sum = hn::MulAdd(share, facing, sum);
                        }
                }
                next += run.count;
            }
            total += static_cast<double>(hn::GetLane(hn::SumOfLanes(floats, sum)));
            sum = set(0.0f);
        }
    return total;
}

double sumOfValues(const KernelJob<std::uint8_t>& job) { return sumOf<false>(job); }
double sumOfGradients(const KernelJob<std::uint8_t>& job) { return sumOf<true>(job); }

}  // namespace echolucent::ray_casting::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace echolucent::ray_casting {
HWY_EXPORT(sumOfValues);
HWY_EXPORT(sumOfGradients);
}  // namespace echolucent::ray_casting

double echolucent::bench::sumOfSamples(const ray_casting::KernelJob<std::uint8_t>& job, FloorOf floor) {
    using namespace ray_casting;
    return floor == FloorOf::value ? HWY_DYNAMIC_DISPATCH(sumOfValues)(job) : HWY_DYNAMIC_DISPATCH(sumOfGradients)(job);
}
#endif
