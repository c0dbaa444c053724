#include "processing/ray_caster/sample_run.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "processing/ray_caster/sample_run.cpp"
#include <hwy/foreach_target.h>

#include "processing/ray_caster/sample_run-inl.h"

HWY_BEFORE_NAMESPACE();
namespace echolucent::ray_casting::HWY_NAMESPACE {

template <typename Voxel>
HWY_INLINE FloatVector tablePosition(FloatVector value, float toTable) {
    const Floats floats;
    const auto scaled = hn::Mul(value, hn::Set(floats, toTable));
    const auto position =
        hn::Min(hn::Max(scaled, hn::Zero(floats)), hn::Set(floats, static_cast<float>(TransferTable::intervals)));
    if constexpr (std::is_same_v<Voxel, float>) {
        const auto finite = hn::Le(hn::Abs(value), hn::Set(floats, std::numeric_limits<float>::max()));
        // Positions next to nothing are 0: they would make the blending work on subnormal numbers, which is slow.
        const auto normal = hn::IfThenElseZero(hn::Gt(position, hn::Set(floats, 1e-12f)), position);
        return hn::IfThenElse(finite, normal, hn::Set(floats, notFinitePosition));
    } else {
        return position;
    }
}

template <typename Voxel>
HWY_INLINE FloatVector trilinearPosition(const VoxelBlock<Voxel>& block, DataAround data, float toTable, FloatVector x,
                                         FloatVector y, FloatVector z) {
    if (data == DataAround::complete) return tablePosition<Voxel>(trilinear(block, x, y, z), toTable);
    const Floats floats;
    const Weighted values = trilinearData(block, x, y, z);
    const auto enough = hn::Ge(values.weight, hn::Set(floats, 0.5f));
    const auto mean = hn::Div(values.sum, hn::IfThenElse(enough, values.weight, hn::Set(floats, 1.0f)));
    return hn::IfThenElse(enough, tablePosition<Voxel>(mean, toTable), hn::Set(floats, noDataPosition));
}

template <typename Voxel>
HWY_INLINE FloatVector nearestPosition(const VoxelBlock<Voxel>& block, DataAround data, float toTable, FloatVector x,
                                       FloatVector y, FloatVector z) {
    const Floats floats;
    const auto offset = nearestOffset(block, x, y, z);
    const auto position = tablePosition<Voxel>(pairAt(block.first, bytes<Voxel>(offset)).left, toTable);
    if (data == DataAround::complete) return position;
    const auto hasData = hn::Gt(pairAt(block.mask, offset).left, hn::Zero(floats));
    return hn::IfThenElse(hasData, position, hn::Set(floats, noDataPosition));
}

template <typename Voxel, Interpolation interpolation>
HWY_INLINE void positionsAlong(const VoxelBlock<Voxel>& block, DataAround data, const SampleRun& run, int count,
                               float toTable, float* positions) {
    const Floats floats;
    const auto last = hn::Set(floats, static_cast<float>(count - 1));
    for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(floats))) {
        // Lanes beyond the last sample repeat it: they must read nothing else.
        const auto index = hn::Min(hn::Iota(floats, static_cast<float>(i)), last);
        const auto x = coordinate(run.start[0], run.step[0], index), y = coordinate(run.start[1], run.step[1], index);
        const auto z = coordinate(run.start[2], run.step[2], index);
        hn::StoreU(interpolation == Interpolation::nearest ? nearestPosition(block, data, toTable, x, y, z)
                                                           : trilinearPosition(block, data, toTable, x, y, z),
                   floats, positions + i);
    }
}

/// The difference of two samples; `complete` falls where a voxel of either has no data.
template <typename Voxel>
HWY_INLINE FloatVector difference(const VoxelBlock<Voxel>& block, DataAround data, const FloatVector (&before)[3],
                                  const FloatVector (&after)[3], FloatVector& complete) {
    if (data == DataAround::complete)
        return hn::Sub(trilinear(block, after[0], after[1], after[2]),
                       trilinear(block, before[0], before[1], before[2]));
    const Weighted low = trilinearData(block, before[0], before[1], before[2]);
    const Weighted high = trilinearData(block, after[0], after[1], after[2]);
    complete = hn::Min(complete, hn::Min(low.weight, high.weight));
    return hn::Sub(high.sum, low.sum);
}

template <typename Voxel>
HWY_INLINE void differencesAlong(const VoxelBlock<Voxel>& block, DataAround data, const SampleRun& run,
                                 const float* samples, int count, const Float4& reach, float scale,
                                 Gradients& gradients) {
    const Floats floats;
    float* const targets[3] = {gradients.x.data(), gradients.y.data(), gradients.z.data()};
    for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(floats))) {
        const auto index = hn::LoadU(floats, samples + i);
        const auto x = coordinate(run.start[0], run.step[0], index), y = coordinate(run.start[1], run.step[1], index);
        const auto z = coordinate(run.start[2], run.step[2], index);
        auto complete = hn::Set(floats, 1.0f);
        const auto reachX = hn::Set(floats, reach[0]), reachY = hn::Set(floats, reach[1]);
        const auto reachZ = hn::Set(floats, reach[2]);
        const auto alongX = difference(block, data, {hn::Sub(x, reachX), y, z}, {hn::Add(x, reachX), y, z}, complete);
        const auto alongY = difference(block, data, {x, hn::Sub(y, reachY), z}, {x, hn::Add(y, reachY), z}, complete);
        const auto alongZ = difference(block, data, {x, y, hn::Sub(z, reachZ)}, {x, y, hn::Add(z, reachZ)}, complete);
        auto valid = hn::Gt(complete, hn::Set(floats, 1.0f - missingWeight));
        if constexpr (std::is_same_v<Voxel, float>) {
            // Voxels that are not finite count as missing too, mask or not.
            const auto sum = hn::Add(hn::Add(hn::Abs(alongX), hn::Abs(alongY)), hn::Abs(alongZ));
            valid = hn::And(valid, hn::Le(sum, hn::Set(floats, std::numeric_limits<float>::max())));
        }
        const auto factor = hn::Set(floats, scale);
        hn::StoreU(hn::IfThenElseZero(valid, hn::Mul(alongX, factor)), floats, targets[0] + i);
        hn::StoreU(hn::IfThenElseZero(valid, hn::Mul(alongY, factor)), floats, targets[1] + i);
        hn::StoreU(hn::IfThenElseZero(valid, hn::Mul(alongZ, factor)), floats, targets[2] + i);
    }
}

HWY_INLINE FloatVector dot(FloatVector x, FloatVector y, FloatVector z, const Float4& v) {
    const Floats floats;
    return hn::Add(hn::Add(hn::Mul(x, hn::Set(floats, v[0])), hn::Mul(y, hn::Set(floats, v[1]))),
                   hn::Mul(z, hn::Set(floats, v[2])));
}

HWY_INLINE FloatVector highlightAt(const DirectionalLight& light, FloatVector cosine) {
    const Floats floats;
    const Ints ints;
    const auto position = hn::Mul(hn::Min(hn::Max(cosine, hn::Zero(floats)), hn::Set(floats, 1.0f)),
                                  hn::Set(floats, static_cast<float>(DirectionalLight::highlightIntervals)));
    const auto left = hn::ConvertTo(ints, position);
    return between(hn::GatherIndex(floats, light.highlight, left), hn::GatherIndex(floats, light.highlight + 1, left),
                   hn::Sub(position, hn::ConvertTo(floats, left)));
}

void light(const DirectionalLight& source, const Gradients& gradients, int count, float* factors) {
    const Floats floats;
    const auto one = hn::Set(floats, 1.0f), zero = hn::Zero(floats), wrap = hn::Set(floats, source.wrap);
    for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(floats))) {
        const auto x = hn::LoadU(floats, gradients.x.data() + i), y = hn::LoadU(floats, gradients.y.data() + i);
        const auto z = hn::LoadU(floats, gradients.z.data() + i);
        const auto square = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
        const auto hasGradient = hn::Gt(square, zero);
        const auto safeSquare = hn::IfThenElse(hasGradient, square, one);
        // The normal points against the gradient, to the darker side.
        const auto perLength = hn::Neg(hn::Div(one, hn::Sqrt(safeSquare)));
        const auto share = hn::IfThenElseZero(
            hasGradient, hn::Div(safeSquare, hn::Add(safeSquare, hn::Set(floats, source.floorSquare))));
        const auto towards = hn::Mul(dot(x, y, z, source.towardsLight), perLength);
        const auto facing = hn::Max(zero, hn::Div(hn::Add(towards, wrap), hn::Add(one, wrap)));
        const auto diffuse =
            hn::Add(hn::Mul(share, facing), hn::Mul(hn::Sub(one, share), hn::Set(floats, source.evenLight)));
        const auto factor = hn::Add(hn::Set(floats, source.ambient), hn::Mul(hn::Set(floats, source.diffuse), diffuse));
        const auto bright = hn::Mul(share, highlightAt(source, hn::Mul(dot(x, y, z, source.half), perLength)));
        hn::StoreU(hn::Add(factor, bright), floats, factors + i);
    }
}

// Highway's dispatch tables need plain functions.
#define ECHOLUCENT_SAMPLERS(Voxel, Name)                                                                              \
    void trilinear##Name(const VoxelBlock<Voxel>& block, DataAround data, const SampleRun& run, int count,            \
                         float toTable, float* positions) {                                                           \
        positionsAlong<Voxel, Interpolation::trilinear>(block, data, run, count, toTable, positions);                 \
    }                                                                                                                 \
    void nearest##Name(const VoxelBlock<Voxel>& block, DataAround data, const SampleRun& run, int count,              \
                       float toTable, float* positions) {                                                             \
        positionsAlong<Voxel, Interpolation::nearest>(block, data, run, count, toTable, positions);                   \
    }                                                                                                                 \
    void gradients##Name(const VoxelBlock<Voxel>& block, DataAround data, const SampleRun& run, const float* samples, \
                         int count, const Float4& reach, float scale, Gradients& gradients) {                         \
        differencesAlong<Voxel>(block, data, run, samples, count, reach, scale, gradients);                           \
    }
ECHOLUCENT_SAMPLERS(std::uint8_t, Bytes)
ECHOLUCENT_SAMPLERS(std::uint16_t, Words)
ECHOLUCENT_SAMPLERS(float, Floating)
#undef ECHOLUCENT_SAMPLERS

}  // namespace echolucent::ray_casting::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace echolucent::ray_casting {

#define ECHOLUCENT_SAMPLERS(Voxel, Name)                                                                             \
    HWY_EXPORT(trilinear##Name);                                                                                     \
    HWY_EXPORT(nearest##Name);                                                                                       \
    HWY_EXPORT(gradients##Name);                                                                                     \
    template <>                                                                                                      \
    void tablePositionsAlong(const VoxelBlock<Voxel>& block, Interpolation interpolation, DataAround data,           \
                             const SampleRun& run, int count, float toTable, Batch& positions) {                     \
        if (interpolation == Interpolation::nearest)                                                                 \
            HWY_DYNAMIC_DISPATCH(nearest##Name)(block, data, run, count, toTable, positions.data());                 \
        else                                                                                                         \
            HWY_DYNAMIC_DISPATCH(trilinear##Name)(block, data, run, count, toTable, positions.data());               \
    }                                                                                                                \
    template <>                                                                                                      \
    void gradientsAlong(const VoxelBlock<Voxel>& block, DataAround data, const SampleRun& run, const Batch& samples, \
                        int count, Float4 reach, float scale, Gradients& gradients) {                                \
        HWY_DYNAMIC_DISPATCH(gradients##Name)(block, data, run, samples.data(), count, reach, scale, gradients);     \
    }
ECHOLUCENT_SAMPLERS(std::uint8_t, Bytes)
ECHOLUCENT_SAMPLERS(std::uint16_t, Words)
ECHOLUCENT_SAMPLERS(float, Floating)
#undef ECHOLUCENT_SAMPLERS

HWY_EXPORT(light);
void lightOf(const DirectionalLight& source, const Gradients& gradients, int count, Batch& factors) {
    HWY_DYNAMIC_DISPATCH(light)(source, gradients, count, factors.data());
}

}  // namespace echolucent::ray_casting
#endif
