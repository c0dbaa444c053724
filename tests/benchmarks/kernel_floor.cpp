#include "tests/benchmarks/kernel_floor.h"

#include "processing/ray_caster/packet_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/benchmarks/kernel_floor.cpp"
#include <hwy/foreach_target.h>

#include "processing/ray_caster/packet_gradient-inl.h"

HWY_BEFORE_NAMESPACE();
namespace echolucent::ray_casting::HWY_NAMESPACE {

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
                            const Gradient g =
                                gradientBetween(addressesOf(*job.gradients, run, at, run.inRange(number)), at,
                                                job.gradients->quantum());
                            const auto square = hn::MulAdd(g.x, g.x, hn::MulAdd(g.y, g.y, hn::Mul(g.z, g.z)));
                            const auto share = hn::Div(square, hn::Add(square, set(job.light->floorSquare)));
                            const auto towards = hn::MulAdd(g.x, set(job.light->towardsLight[0]),
                                                            hn::MulAdd(g.y, set(job.light->towardsLight[1]),
                                                                       hn::Mul(g.z, set(job.light->towardsLight[2]))));
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
