#include "processing/speckle_reduction/joint_bilateral_row.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "processing/speckle_reduction/joint_bilateral_row.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace echolucent::joint_bilateral_row::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <typename Tag>
HWY_INLINE void meanAt(Tag tag, const float* guide, const float* values, std::span<const BilateralTap> taps,
                       float* result) {
    const auto middle = hn::LoadU(tag, guide), one = hn::Set(tag, 1.0F);
    auto sum = hn::Zero(tag), weights = hn::Zero(tag);
    for (const BilateralTap& tap : taps) {
        const auto apart = hn::Sub(hn::LoadU(tag, guide + tap.offset), middle);
        const auto near = hn::Max(hn::Sub(one, hn::Mul(apart, apart)), hn::Zero(tag));
        const auto weight = hn::Mul(hn::Mul(near, near), hn::Set(tag, tap.weight));
        sum = hn::Add(sum, hn::Mul(weight, hn::LoadU(tag, values + tap.offset)));
        weights = hn::Add(weights, weight);
    }
    hn::StoreU(hn::Div(sum, weights), tag, result);
}

void means(const float* guide, const float* values, std::span<const BilateralTap> taps, std::size_t count,
           float* results) {
    const hn::CappedTag<float, 16> whole;
    const std::size_t lanes = hn::Lanes(whole);
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) meanAt(whole, guide + i, values + i, taps, results + i);
    for (; i < count; ++i) meanAt(hn::CappedTag<float, 1>(), guide + i, values + i, taps, results + i);
}

}  // namespace echolucent::joint_bilateral_row::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace echolucent {

namespace joint_bilateral_row {
HWY_EXPORT(means);
}  // namespace joint_bilateral_row

void bilateralRow(const float* guide, const float* values, std::span<const BilateralTap> taps, std::size_t count,
                  float* results) {
    using namespace joint_bilateral_row;
    HWY_DYNAMIC_DISPATCH(means)(guide, values, taps, count, results);
}

}  // namespace echolucent
#endif
