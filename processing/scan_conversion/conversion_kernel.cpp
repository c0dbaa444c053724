#include "processing/scan_conversion/conversion_kernel.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <type_traits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "processing/scan_conversion/conversion_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace echolucent::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::CappedTag<float, 16>;
using Integers = hn::RebindToSigned<Floats>;
using Words = hn::RebindToUnsigned<Floats>;
using FloatVector = hn::Vec<Floats>;
using IntegerVector = hn::Vec<Integers>;

HWY_INLINE FloatVector between(FloatVector low, FloatVector high, FloatVector share) {
    return hn::Add(low, hn::Mul(share, hn::Sub(high, low)));
}

/// The indices of lines of many keys, as LineLookup says.
HWY_INLINE FloatVector lineAt(const LineLookup& lines, FloatVector key) {
    const Floats d;
    const Integers integers;
    FloatVector place = hn::Mul(hn::Sub(key, hn::Set(d, lines.firstKey())), hn::Set(d, lines.entriesPerKey()));
    place = hn::Min(hn::Max(place, hn::Zero(d)), hn::Set(d, lines.lastPlace()));
    const IntegerVector entry = hn::ConvertTo(integers, place);
    const FloatVector low = hn::GatherIndex(d, lines.indices(), entry);
    const FloatVector high = hn::GatherIndex(d, lines.indices() + 1, entry);
    return between(low, high, hn::Sub(place, hn::ConvertTo(d, entry)));
}

/// Interpolates between the value at `offset` and the next one.
template <typename Value>
HWY_INLINE FloatVector alongBeam(const Value* values, IntegerVector offset, FloatVector share, bool oneByOne) {
    const Floats d;
    const Integers integers;
    const Words words;
    if constexpr (std::is_same_v<Value, float>) {
        return between(hn::GatherIndex(d, values, offset), hn::GatherIndex(d, values + 1, offset), share);
    } else {
        IntegerVector pair;
        if (oneByOne) {
            constexpr std::size_t most = 16;
            HWY_ALIGN std::array<std::int32_t, most> offsets{}, pairs{};
            hn::Store(offset, integers, offsets.data());
            for (std::size_t lane = 0; lane < hn::Lanes(integers); ++lane)
                std::memcpy(&pairs[lane], values + offsets[lane], 2 * sizeof(Value));
            pair = hn::Load(integers, pairs.data());
        } else {
            const IntegerVector bytes = sizeof(Value) == 1 ? offset : hn::Add(offset, offset);
            pair = hn::GatherOffset(integers, reinterpret_cast<const std::int32_t*>(values), bytes);
        }
        constexpr int bits = 8 * sizeof(Value);
        const auto mask = hn::Set(words, (std::uint32_t{1} << bits) - 1);
        const auto both = hn::BitCast(words, pair);
        const FloatVector low = hn::ConvertTo(d, hn::BitCast(integers, hn::And(both, mask)));
        const FloatVector high = hn::ConvertTo(d, hn::BitCast(integers, hn::And(hn::ShiftRight<bits>(both), mask)));
        return between(low, high, share);
    }
}

/// The voxels at places `index` of a row.
template <typename Value>
HWY_INLINE FloatVector interpolated(const ConversionRow<Value>& row, FloatVector index) {
    const Floats d;
    const Integers integers;
    const FloatVector across = hn::Add(hn::Set(d, row.firstMm), hn::Mul(index, hn::Set(d, row.spacingMm)));
    const FloatVector along = hn::Set(d, row.alongMm);
    FloatVector range = along, key = across;
    if (row.angular) {
        range = hn::Sqrt(hn::Add(hn::Mul(across, across), hn::Mul(along, along)));
        key = hn::Div(across, hn::Max(hn::Add(range, along), hn::Set(d, 1e-20F)));
    }
    const FloatVector lastSample = hn::Set(d, static_cast<float>(row.samples - 1));
    FloatVector sample = hn::Mul(hn::Sub(range, hn::Set(d, row.rangeStartMm)), hn::Set(d, row.samplesPerMm));
    sample = hn::Min(hn::Max(sample, hn::Zero(d)), lastSample);
    const FloatVector line = lineAt(*row.lines, key);

    const IntegerVector atSample = hn::Min(hn::ConvertTo(integers, sample), hn::Set(integers, row.samples - 2));
    const IntegerVector atLine = hn::Min(hn::ConvertTo(integers, line), hn::Set(integers, row.lineCount - 2));
    const FloatVector sampleShare = hn::Sub(sample, hn::ConvertTo(d, atSample));
    const FloatVector lineShare = hn::Sub(line, hn::ConvertTo(d, atLine));
    const IntegerVector offset = hn::Add(hn::Mul(atLine, hn::Set(integers, row.samples)), atSample);
    const auto inPlane = [&](const Value* plane) {
        return between(alongBeam(plane, offset, sampleShare, row.endsHere),
                       alongBeam(plane + row.samples, offset, sampleShare, row.endsHere), lineShare);
    };
    return between(inPlane(row.nearPlane), inPlane(row.farPlane), hn::Set(d, row.planeShare));
}

template <typename Value>
void convertRunOf(const ConversionRow<Value>& row, std::int32_t first, std::int32_t end, Value* out) {
    const Floats d;
    constexpr std::int32_t atOnce = 128;
    HWY_ALIGN std::array<float, atOnce> values;
    const auto lanes = static_cast<std::int32_t>(hn::Lanes(d));
    for (std::int32_t from = first; from < end; from += atOnce) {
        const std::int32_t count = std::min(atOnce, end - from);
        for (std::int32_t i = 0; i < count; i += lanes) {
            auto value = interpolated(row, hn::Iota(d, static_cast<float>(from + i)));
            if constexpr (!std::is_same_v<Value, float>)
                value = hn::Add(value, hn::Set(d, 0.5F));  // rounds the cast below
            hn::Store(value, d, values.data() + i);
        }
        for (std::int32_t i = 0; i < count; ++i) {
            const float value = values[static_cast<std::size_t>(i)];
            if constexpr (std::is_same_v<Value, float>)
                out[from + i] = value;
            else
                out[from + i] = static_cast<Value>(static_cast<std::int32_t>(value));
        }
    }
}

void convertBytes(const ConversionRow<std::uint8_t>& row, std::int32_t first, std::int32_t end, std::uint8_t* out) {
    convertRunOf(row, first, end, out);
}
void convertWords(const ConversionRow<std::uint16_t>& row, std::int32_t first, std::int32_t end, std::uint16_t* out) {
    convertRunOf(row, first, end, out);
}
void convertFloats(const ConversionRow<float>& row, std::int32_t first, std::int32_t end, float* out) {
    convertRunOf(row, first, end, out);
}

}  // namespace echolucent::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace echolucent {

HWY_EXPORT(convertBytes);
HWY_EXPORT(convertWords);
HWY_EXPORT(convertFloats);

void convertRun(const ConversionRow<std::uint8_t>& row, std::int32_t first, std::int32_t end, std::uint8_t* out) {
    HWY_DYNAMIC_DISPATCH(convertBytes)(row, first, end, out);
}
void convertRun(const ConversionRow<std::uint16_t>& row, std::int32_t first, std::int32_t end, std::uint16_t* out) {
    HWY_DYNAMIC_DISPATCH(convertWords)(row, first, end, out);
}
void convertRun(const ConversionRow<float>& row, std::int32_t first, std::int32_t end, float* out) {
    HWY_DYNAMIC_DISPATCH(convertFloats)(row, first, end, out);
}

}  // namespace echolucent
#endif
