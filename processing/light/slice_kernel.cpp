#include "processing/light/slice_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "processing/light/slice_kernel.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace echolucent::light::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, spareFloats>;
using FloatVector = hn::Vec<Floats>;

/// exp(-x) for x >= 0, as 1 / (1 + y + y^2/2 + y^3/6)^4 with y = x/4: at most 0.0016 off, and near 0 for large x.
HWY_INLINE FloatVector faded(FloatVector x) {
    const Floats floats;
    const auto y = hn::Mul(x, hn::Set(floats, 0.25f)), one = hn::Set(floats, 1.0f);
    const auto cubic = hn::MulAdd(y, hn::Set(floats, 1.0f / 6.0f), hn::Set(floats, 0.5f));
    const auto root = hn::MulAdd(y, hn::MulAdd(y, cubic, one), one);
    const auto inverse = hn::Div(one, root), square = hn::Mul(inverse, inverse);
    return hn::Mul(square, square);
}

/// Carries light through one row of places. Each place weakens the light in two halves. The light that counts as
/// reaching the place is taken after a quarter of it, not after half: a place is so large that it smears a surface
/// towards the light, so light taken at its middle would leave the lit side of the surface too dark (docs/light.md).
HWY_INLINE void sweepRow(const SliceJob& job, const SweptDirection& direction, const float* extinctions, int row) {
    const Floats floats;
    const auto stride = static_cast<std::ptrdiff_t>(job.planeStride);
    const float* first = direction.before + (row + 1 + direction.row) * stride + 1 + direction.column;
    const float* second = first + stride;
    float* behind = direction.behind + (row + 1) * stride + 1;
    const auto a = hn::Set(floats, direction.taps[0]), b = hn::Set(floats, direction.taps[1]),
               c = hn::Set(floats, direction.taps[2]), d = hn::Set(floats, direction.taps[3]),
               halfLength = hn::Set(floats, direction.halfLengthMm), weight = hn::Set(floats, direction.weight);
    const auto columns = static_cast<std::size_t>(job.columns);
    for (std::size_t x = 0; x < columns; x += hn::Lanes(floats)) {
        const auto upper = hn::MulAdd(b, hn::LoadU(floats, first + x + 1), hn::Mul(a, hn::LoadU(floats, first + x)));
        const auto lower = hn::MulAdd(d, hn::LoadU(floats, second + x + 1), hn::Mul(c, hn::LoadU(floats, second + x)));
        const auto half = faded(hn::Mul(hn::LoadU(floats, extinctions + x), halfLength));
        const auto arriving = hn::Add(upper, lower), reaching = hn::Mul(arriving, hn::Sqrt(half));
        hn::StoreU(hn::Mul(arriving, hn::Mul(half, half)), floats, behind + x);
        hn::StoreU(hn::MulAdd(weight, reaching, hn::LoadU(floats, job.sums + x)), floats, job.sums + x);
    }
    behind[columns] = 1.0f;
}

void sweepSliceHere(const SliceJob& job) {
    const auto columns = static_cast<std::size_t>(job.columns);
    for (int row = 0; row < job.rows; ++row) {
        const std::size_t offset = static_cast<std::size_t>(row) * job.rowStride;
        for (std::size_t x = 0; x < columns + spareFloats; ++x) job.sums[x] = 0.0f;
        for (const SweptDirection& direction : job.directions) sweepRow(job, direction, job.extinctions + offset, row);
        for (std::size_t x = 0; x < columns; ++x)
            // NOLINTNEXTLINE(bugprone-incorrect-roundings): no sum is below 0.
            job.reaching[offset + x] = static_cast<std::uint16_t>(static_cast<int>(job.sums[x] * job.scale + 0.5f));
    }
}

}  // namespace echolucent::light::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace echolucent::light {
HWY_EXPORT(sweepSliceHere);
void sweepSlice(const SliceJob& job) { HWY_DYNAMIC_DISPATCH(sweepSliceHere)(job); }
}  // namespace echolucent::light
#endif
