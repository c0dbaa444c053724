#include "processing/speckle_reduction/row_sums.h"

#include <type_traits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "processing/speckle_reduction/row_sums.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace echolucent::row_sums::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 16>;
using OneFloat = hn::CappedTag<float, 1>;

/// Calls run(tag, i) for the vectors of [0, count) that begin at i: whole vectors first, then single floats.
template <typename Run>
HWY_INLINE void forVectors(std::size_t count, const Run& run) {
    const std::size_t lanes = hn::Lanes(Floats());
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) run(Floats(), i);
    for (; i < count; ++i) run(OneFloat(), i);
}

template <typename Tag, typename Voxel>
HWY_INLINE hn::Vec<Tag> floatsAt(Tag tag, const Voxel* voxels) {
    if constexpr (std::is_same_v<Voxel, float>) {
        return hn::LoadU(tag, voxels);
    } else {
        const hn::Rebind<Voxel, Tag> stored;
        const hn::RebindToSigned<Tag> ints;
        return hn::ConvertTo(tag, hn::PromoteTo(ints, hn::LoadU(stored, voxels)));
    }
}

template <typename Voxel>
HWY_INLINE void sumAll(const VoxelRows<Voxel>& rows, std::span<const float> taps, float* sums) {
    forVectors(rows.count, [&](auto tag, std::size_t i) HWY_ATTR {
        auto sum = hn::Zero(tag);
        const Voxel* row = rows.first + i;
        for (std::size_t t = 0; t < taps.size(); ++t, row += rows.stride)
            sum = hn::Add(sum, hn::Mul(hn::Set(tag, taps[t]), floatsAt(tag, row)));
        hn::StoreU(sum, tag, sums + i);
    });
}

template <typename Voxel>
HWY_INLINE void sumData(const VoxelRows<Voxel>& rows, std::span<const float> taps, float* sums, float* weightSums) {
    forVectors(rows.count, [&](auto tag, std::size_t i) HWY_ATTR {
        auto sum = hn::Zero(tag), weightSum = hn::Zero(tag);
        const Voxel* row = rows.first + i;
        const std::uint8_t* mask = rows.mask + i;
        for (std::size_t t = 0; t < taps.size(); ++t, row += rows.stride, mask += rows.stride) {
            const auto hasData = hn::Ne(floatsAt(tag, mask), hn::Zero(tag));
            const auto weight = hn::Set(tag, taps[t]);
            // A product with a weight of 0 is not safe: the voxel may be NaN. So take zero instead.
            sum = hn::Add(sum, hn::Mul(weight, hn::IfThenElseZero(hasData, floatsAt(tag, row))));
            weightSum = hn::Add(weightSum, hn::IfThenElseZero(hasData, weight));
        }
        hn::StoreU(sum, tag, sums + i);
        hn::StoreU(weightSum, tag, weightSums + i);
    });
}

template <typename Voxel>
HWY_INLINE void sum(const VoxelRows<Voxel>& rows, std::span<const float> taps, float* sums, float* weightSums) {
    if (rows.mask != nullptr)
        sumData(rows, taps, sums, weightSums);
    else
        sumAll(rows, taps, sums);
}

template <typename Voxel>
HWY_INLINE void store(std::span<const float> sums, const float* weights, const StoredRange& range, Voxel* voxels) {
    forVectors(sums.size(), [&](auto tag, std::size_t i) HWY_ATTR {
        const auto weight = hn::LoadU(tag, weights + i);
        const auto divisor = hn::IfThenElse(hn::Gt(weight, hn::Zero(tag)), weight, hn::Set(tag, 1.0F));
        const auto mean = hn::Div(hn::LoadU(tag, sums.data() + i), divisor);
        const auto kept = hn::Min(hn::Max(mean, hn::Set(tag, range.lowest)), hn::Set(tag, range.highest));
        if constexpr (std::is_same_v<Voxel, float>) {
            hn::StoreU(kept, tag, voxels + i);
        } else {
            const hn::Rebind<Voxel, decltype(tag)> stored;
            hn::StoreU(hn::DemoteTo(stored, hn::NearestInt(kept)), stored, voxels + i);
        }
    });
}

using Taps = std::span<const float>;
void sumBytes(const VoxelRows<std::uint8_t>& rows, Taps taps, float* sums, float* weightSums) {
    sum(rows, taps, sums, weightSums);
}
void sumWords(const VoxelRows<std::uint16_t>& rows, Taps taps, float* sums, float* weightSums) {
    sum(rows, taps, sums, weightSums);
}
void sumFloats(const VoxelRows<float>& rows, Taps taps, float* sums, float* weightSums) {
    sum(rows, taps, sums, weightSums);
}
void storeBytes(Taps sums, const float* weights, const StoredRange& range, std::uint8_t* voxels) {
    store(sums, weights, range, voxels);
}
void storeWords(Taps sums, const float* weights, const StoredRange& range, std::uint16_t* voxels) {
    store(sums, weights, range, voxels);
}
void storeFloats(Taps sums, const float* weights, const StoredRange& range, float* voxels) {
    store(sums, weights, range, voxels);
}

}  // namespace echolucent::row_sums::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace echolucent {

namespace row_sums {
HWY_EXPORT(sumBytes);
HWY_EXPORT(sumWords);
HWY_EXPORT(sumFloats);
HWY_EXPORT(storeBytes);
HWY_EXPORT(storeWords);
HWY_EXPORT(storeFloats);
}  // namespace row_sums

using namespace row_sums;

void sumRows(const VoxelRows<std::uint8_t>& rows, std::span<const float> taps, float* sums, float* weightSums) {
    HWY_DYNAMIC_DISPATCH(sumBytes)(rows, taps, sums, weightSums);
}
void sumRows(const VoxelRows<std::uint16_t>& rows, std::span<const float> taps, float* sums, float* weightSums) {
    HWY_DYNAMIC_DISPATCH(sumWords)(rows, taps, sums, weightSums);
}
void sumRows(const VoxelRows<float>& rows, std::span<const float> taps, float* sums, float* weightSums) {
    HWY_DYNAMIC_DISPATCH(sumFloats)(rows, taps, sums, weightSums);
}
void storeMeans(std::span<const float> sums, const float* weights, const StoredRange& range, std::uint8_t* voxels) {
    HWY_DYNAMIC_DISPATCH(storeBytes)(sums, weights, range, voxels);
}
void storeMeans(std::span<const float> sums, const float* weights, const StoredRange& range, std::uint16_t* voxels) {
    HWY_DYNAMIC_DISPATCH(storeWords)(sums, weights, range, voxels);
}
void storeMeans(std::span<const float> sums, const float* weights, const StoredRange& range, float* voxels) {
    HWY_DYNAMIC_DISPATCH(storeFloats)(sums, weights, range, voxels);
}

}  // namespace echolucent
#endif
