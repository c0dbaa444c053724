#include "processing/tube_core/slabs/profile_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "processing/tube_core/slabs/profile_kernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace echolucent::profile_kernels::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, 8>;
using OneDouble = hn::CappedTag<double, 1>;

/// Calls run(tag, i) for vectors from i on: first whole ones, then single lanes.
template <typename Run>
HWY_INLINE void forVectors(std::size_t count, const Run& run) {
    const std::size_t lanes = hn::Lanes(Doubles());
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) run(Doubles(), i);
    for (; i < count; ++i) run(OneDouble(), i);
}

/// Whole numbers from 0 to below 2^52 as doubles.
template <typename Tag, typename Vector>
HWY_INLINE hn::Vec<Tag> doublesOf(Tag tag, Vector whole) {
    constexpr double upper = 4503599627370496.0;  // 2^52: the number stands in the last bits of 2^52 + number
    const hn::RebindToUnsigned<Tag> bits;
    const auto offset = hn::Set(tag, upper);
    return hn::Sub(hn::BitCast(tag, hn::Or(whole, hn::BitCast(bits, offset))), offset);
}

void moments(const std::int32_t* counts, const std::int32_t* sums, const std::uint64_t* squares, std::size_t count,
             double white, float* means, float* spreads) {
    forVectors(count, [&](auto tag, std::size_t i) HWY_ATTR {
        const hn::Rebind<float, decltype(tag)> floats;
        const hn::Rebind<std::int32_t, decltype(tag)> ints;
        const hn::RebindToUnsigned<decltype(tag)> wide;
        const auto samples = hn::PromoteTo(tag, hn::Max(hn::LoadU(ints, counts + i), hn::Set(ints, 1)));
        const auto sum = hn::PromoteTo(tag, hn::LoadU(ints, sums + i));
        const auto square = doublesOf(tag, hn::LoadU(wide, squares + i));
        // All below 2^52: exact.
        const auto scaledVariance = hn::Sub(hn::Mul(samples, square), hn::Mul(sum, sum));
        const auto scale = hn::Mul(samples, hn::Set(tag, white));
        hn::StoreU(hn::DemoteTo(floats, hn::Div(sum, scale)), floats, means + i);
        const auto spread = hn::Sqrt(hn::DemoteTo(floats, scaledVariance));
        hn::StoreU(hn::Div(spread, hn::DemoteTo(floats, scale)), floats, spreads + i);
    });
}

void tableValues(const double* table, std::size_t samples, const float* positions, std::size_t count, float* values) {
    forVectors(count, [&](auto tag, std::size_t i) HWY_ATTR {
        const hn::Rebind<float, decltype(tag)> floats;
        const hn::RebindToSigned<decltype(tag)> offsets;
        const auto intervals = hn::Set(tag, static_cast<double>(samples - 1));
        const auto inside =
            hn::Min(hn::Max(hn::PromoteTo(tag, hn::LoadU(floats, positions + i)), hn::Zero(tag)), hn::Set(tag, 1.0));
        const auto position = hn::Mul(inside, intervals);
        const auto low = hn::Min(hn::Floor(position), hn::Sub(intervals, hn::Set(tag, 1.0)));
        const auto index =
            hn::BitCast(offsets, hn::Sub(hn::BitCast(offsets, hn::Add(low, hn::Set(tag, 4503599627370496.0))),
                                         hn::BitCast(offsets, hn::Set(tag, 4503599627370496.0))));
        const auto left = hn::GatherIndex(tag, table, index), right = hn::GatherIndex(tag, table + 1, index);
        const auto value = hn::Add(left, hn::Mul(hn::Sub(position, low), hn::Sub(right, left)));
        hn::StoreU(hn::DemoteTo(floats, value), floats, values + i);
    });
}

void differences(const float* profile, int before, int behind, std::size_t count, float* values) {
    forVectors(count, [&](auto tag, std::size_t i) HWY_ATTR {
        const hn::Rebind<float, decltype(tag)> floats;
        const auto meanOf = [&](std::size_t first, int length) HWY_ATTR {
            auto sum = hn::Zero(tag);
            for (int k = 0; k < length; ++k)
                sum =
                    hn::Add(sum, hn::PromoteTo(tag, hn::LoadU(floats, profile + first + static_cast<std::size_t>(k))));
            return hn::Mul(sum, hn::Set(tag, 1.0 / length));
        };
        const auto difference = hn::Sub(meanOf(i + static_cast<std::size_t>(before), behind), meanOf(i, before));
        hn::StoreU(hn::DemoteTo(floats, difference), floats, values + i);
    });
}

/// Several vectors at once, so that their sums do not wait for each other.
template <std::size_t vectors>
HWY_INLINE void convolveFrom(const double* centre, const double* weights, std::size_t count, double* results) {
    const Doubles tag;
    const std::size_t lanes = hn::Lanes(tag);
    const auto first = hn::Set(tag, weights[0]);
    hn::Vec<Doubles> sums[vectors];
    for (std::size_t v = 0; v < vectors; ++v) sums[v] = hn::Mul(first, hn::LoadU(tag, centre + v * lanes));
    for (std::size_t distance = 1; distance < count; ++distance) {
        const auto weight = hn::Set(tag, weights[distance]);
        for (std::size_t v = 0; v < vectors; ++v) {
            const double* at = centre + v * lanes;
            sums[v] = hn::Add(sums[v],
                              hn::Mul(weight, hn::Add(hn::LoadU(tag, at - distance), hn::LoadU(tag, at + distance))));
        }
    }
    for (std::size_t v = 0; v < vectors; ++v) hn::StoreU(sums[v], tag, results + v * lanes);
}

void symmetric(const double* function, const double* weights, std::size_t weightCount, double* results,
               std::size_t count) {
    constexpr std::size_t together = 4;
    const std::size_t lanes = hn::Lanes(Doubles());
    std::size_t i = 0;
    for (; i + together * lanes <= count; i += together * lanes)
        convolveFrom<together>(function + i, weights, weightCount, results + i);
    for (; i + lanes <= count; i += lanes) convolveFrom<1>(function + i, weights, weightCount, results + i);
}

}  // namespace echolucent::profile_kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace echolucent {

namespace profile_kernels {
HWY_EXPORT(moments);
HWY_EXPORT(tableValues);
HWY_EXPORT(differences);
HWY_EXPORT(symmetric);
}  // namespace profile_kernels

void momentsFromSums(std::span<const std::int32_t> counts, std::span<const std::int32_t> sums,
                     std::span<const std::uint64_t> sumsOfSquares, double white, std::span<float> means,
                     std::span<float> spreads) {
    using namespace profile_kernels;
    HWY_DYNAMIC_DISPATCH(moments)
    (counts.data(), sums.data(), sumsOfSquares.data(), counts.size(), white, means.data(), spreads.data());
}

void lookUp(std::span<const double> table, std::span<const float> positions, std::span<float> values) {
    using namespace profile_kernels;
    HWY_DYNAMIC_DISPATCH(tableValues)
    (table.data(), table.size(), positions.data(), positions.size(), values.data());
}

void differencesOfMeans(std::span<const float> profile, int before, int behind, std::span<float> values) {
    using namespace profile_kernels;
    HWY_DYNAMIC_DISPATCH(differences)(profile.data(), before, behind, values.size(), values.data());
}

void convolve(const double* function, std::span<const double> weights, std::span<double> results) {
    using namespace profile_kernels;
    HWY_DYNAMIC_DISPATCH(symmetric)(function, weights.data(), weights.size(), results.data(), results.size());
}

}  // namespace echolucent
#endif
