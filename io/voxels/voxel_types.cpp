#include "io/voxels/voxel_types.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include <fmt/format.h>

#include "io/voxels/typed_bytes.h"

namespace echolucent {

static_assert(std::endian::native == std::endian::little, "files are written and decoded for little-endian machines");

namespace {

struct TypeFacts {
    StoredType type;
    std::string_view name;
    std::int64_t bytes;
};
constexpr std::array<TypeFacts, 10> typeFacts{{{StoredType::uint8, "uint8", 1},
                                               {StoredType::int8, "int8", 1},
                                               {StoredType::uint16, "uint16", 2},
                                               {StoredType::int16, "int16", 2},
                                               {StoredType::uint32, "uint32", 4},
                                               {StoredType::int32, "int32", 4},
                                               {StoredType::uint64, "uint64", 8},
                                               {StoredType::int64, "int64", 8},
                                               {StoredType::float32, "float32", 4},
                                               {StoredType::float64, "float64", 8}}};

using Bytes = VoxelBytes;

template <typename T>
struct Range {
    T low = 0;
    T high = 0;
};

template <typename T>
Range<T> rangeOf(const std::vector<Bytes>& phases) {
    Range<T> range;
    for (const Bytes& bytes : phases)
        for (std::size_t i = 0; i < bytes.size() / sizeof(T); ++i) {
            const T value = storedAt<T>(bytes, i);
            range.low = std::min(range.low, value);
            range.high = std::max(range.high, value);
        }
    return range;
}

template <typename Word, typename Swap>
void swapBytes(Bytes& bytes, const Swap& swap) {
    for (std::size_t i = 0; i + sizeof(Word) <= bytes.size(); i += sizeof(Word)) {
        Word word;
        std::memcpy(&word, &bytes[i], sizeof(word));
        word = swap(word);
        std::memcpy(&bytes[i], &word, sizeof(word));
    }
}

template <typename From, typename To>
void convertAll(std::vector<Bytes>& phases, ConvertedVoxels& result) {
    for (Bytes& bytes : phases) {
        if constexpr (std::is_same_v<From, To>)
            result.phases.emplace_back(voxelsIn<To>(std::move(bytes)));
        else
            result.phases.emplace_back(
                valuesBecoming<From, To>(std::move(bytes), [](From value) { return static_cast<To>(value); }));
    }
}

/// Keeps integers whole if they fit into 8 or 16 unsigned bits, else as float32.
template <typename T>
ConvertedVoxels convertIntegers(std::vector<Bytes> phases, std::string_view name) {
    ConvertedVoxels result;
    const Range<T> range = rangeOf<T>(phases);
    if (sizeof(T) == 1 && range.low >= 0) {
        for (Bytes& bytes : phases) result.phases.emplace_back(voxelsIn<std::uint8_t>(std::move(bytes)));
        result.story = fmt::format("{}, kept as uint8", name);
    } else if (range.low >= 0 && static_cast<std::uint64_t>(range.high) <= 65535) {
        convertAll<T, std::uint16_t>(phases, result);
        result.story = fmt::format("{}, kept as uint16", name);
    } else {
        convertAll<T, float>(phases, result);
        result.story = fmt::format("{}, kept as float32", name);
        if (range.low < 0)
            result.warning = "The voxels have negative values down to " + std::to_string(range.low) +
                             "; these count as intensity 0.";
        else if (static_cast<double>(range.high) > 16777216.0)
            result.warning = "Voxel values above 16777216 were rounded to float32.";
    }
    return result;
}

/// A sentence if float32 voxels hold values below 0; else empty.
std::string warningOfNegatives(const std::vector<Voxels>& phases) {
    float low = 0;
    for (const Voxels& voxels : phases)
        for (const float value : std::get<VoxelArray<float>>(voxels))
            if (std::isfinite(value)) low = std::min(low, value);
    if (low >= 0) return {};
    return fmt::format("The voxels have negative values down to {}; these count as intensity 0.", low);
}

template <typename From>
void rescaleAll(std::vector<Bytes>& phases, const Rescale& rescale, ConvertedVoxels& result) {
    for (Bytes& bytes : phases) {
        result.phases.emplace_back(valuesBecoming<From, float>(
            std::move(bytes), [&](From value) { return static_cast<float>(rescale.of(static_cast<double>(value))); }));
    }
}

/// The smallest and the largest finite value; no value if there is none.
template <typename T>
std::optional<std::array<double, 2>> finiteRange(const std::vector<Bytes>& phases) {
    T low = std::numeric_limits<T>::infinity(), high = -low;
    for (const Bytes& bytes : phases)
        for (std::size_t i = 0; i < bytes.size() / sizeof(T); ++i) {
            const T value = storedAt<T>(bytes, i);
            if (!std::isfinite(value)) continue;
            low = std::min(low, value);
            high = std::max(high, value);
        }
    if (low > high) return std::nullopt;
    return std::array{static_cast<double>(low), static_cast<double>(high)};
}

ConvertedVoxels convertFloats(std::vector<Bytes> phases, StoredType type) {
    ConvertedVoxels result;
    if (type == StoredType::float64) {
        convertAll<double, float>(phases, result);
        result.story = "float64, kept as float32";
    } else {
        convertAll<float, float>(phases, result);
        result.story = "float32";
    }
    result.warning = warningOfNegatives(result.phases);
    return result;
}

template <typename T>
void reduceToLumaOf(Bytes& bytes) {
    const std::size_t count = bytes.size() / (3 * sizeof(T));
    for (std::size_t i = 0; i < count; ++i) {
        const double luma = 0.299 * storedAt<T>(bytes, 3 * i) + 0.587 * storedAt<T>(bytes, 3 * i + 1) +
                            0.114 * storedAt<T>(bytes, 3 * i + 2);
        const T value = static_cast<T>(std::lround(luma));
        std::memcpy(bytes.data() + i * sizeof(T), &value, sizeof(T));
    }
    bytes.resize(count * sizeof(T));
    bytes.shrink_to_fit();
}

}  // namespace

std::string_view nameOf(StoredType type) { return typeFacts[static_cast<std::size_t>(type)].name; }

std::int64_t bytesOf(StoredType type) { return typeFacts[static_cast<std::size_t>(type)].bytes; }

std::optional<StoredType> storedTypeFromName(std::string_view name) {
    for (const TypeFacts& facts : typeFacts)
        if (facts.name == name) return facts.type;
    return std::nullopt;
}

std::optional<std::string> problemOf(const Rescale& rescale, double smallest, double largest) {
    const double low = rescale.of(smallest), high = rescale.of(largest);
    constexpr double most = std::numeric_limits<float>::max();
    constexpr double least = std::numeric_limits<float>::min();
    if (std::abs(low) <= most && std::abs(high) <= most && std::abs(high - low) >= least &&
        static_cast<float>(low) != static_cast<float>(high))
        return std::nullopt;
    return fmt::format("is {:.6g} with intercept {:.6g}, which makes values from {:.6g} to {:.6g}", rescale.slope,
                       rescale.intercept, low, high);
}

std::array<double, 2> rangeOf(StoredType type) {
    const double bits = 8.0 * static_cast<double>(bytesOf(type));
    switch (type) {
        case StoredType::uint8:
        case StoredType::uint16:
        case StoredType::uint32:
        case StoredType::uint64: return {0.0, std::exp2(bits) - 1};
        case StoredType::int8:
        case StoredType::int16:
        case StoredType::int32:
        case StoredType::int64: return {-std::exp2(bits - 1), std::exp2(bits - 1) - 1};
        case StoredType::float32:
        case StoredType::float64: break;
    }
    return {-1.0, 1.0};
}

std::optional<std::string> problemInDouble(const Rescale& rescale, double smallest, double largest) {
    const double low = rescale.of(smallest), high = rescale.of(largest);
    if (std::isfinite(low) && std::isfinite(high) && low != high) return std::nullopt;
    return fmt::format("is {:.6g} with intercept {:.6g}, which makes values from {:.6g} to {:.6g}", rescale.slope,
                       rescale.intercept, low, high);
}

std::optional<std::string> problemOfFloats(const std::vector<VoxelBytes>& phases, StoredType type,
                                           const Rescale& rescale) {
    const bool isDouble = type == StoredType::float64;
    if ((!isDouble && type != StoredType::float32) || rescale.isIdentity()) return std::nullopt;
    const auto range = isDouble ? finiteRange<double>(phases) : finiteRange<float>(phases);
    if (!range) return std::nullopt;
    const auto [low, high] = *range;
    // Voxels that were all the same before may stay so.
    if (std::isfinite(rescale.of(low)) && std::isfinite(rescale.of(high))) {
        if (low == high || rescale.of(low) != rescale.of(high)) return std::nullopt;
        return fmt::format("makes one value of all voxels, which are stored from {:.6g} to {:.6g}", low, high);
    }
    return fmt::format("makes values from {:.6g} to {:.6g}, larger than float64 can hold", rescale.of(low),
                       rescale.of(high));
}

void toMachineByteOrder(VoxelBytes& bytes, StoredType type, bool bigEndian) {
    if (!bigEndian) return;
    switch (bytesOf(type)) {
        case 2: return swapBytes<std::uint16_t>(bytes, [](std::uint16_t value) { return __builtin_bswap16(value); });
        case 4: return swapBytes<std::uint32_t>(bytes, [](std::uint32_t value) { return __builtin_bswap32(value); });
        case 8: return swapBytes<std::uint64_t>(bytes, [](std::uint64_t value) { return __builtin_bswap64(value); });
        default: return;
    }
}

void reduceToLuma(VoxelBytes& bytes, StoredType type) {
    if (type == StoredType::uint16)
        reduceToLumaOf<std::uint16_t>(bytes);
    else
        reduceToLumaOf<std::uint8_t>(bytes);
}

ConvertedVoxels convertVoxels(std::vector<VoxelBytes> phases, StoredType type) {
    ConvertedVoxels result;
    switch (type) {
        case StoredType::uint8:
            for (Bytes& bytes : phases) result.phases.emplace_back(voxelsIn<std::uint8_t>(std::move(bytes)));
            result.story = "uint8";
            return result;
        case StoredType::uint16:
            convertAll<std::uint16_t, std::uint16_t>(phases, result);
            result.story = "uint16";
            return result;
        case StoredType::int8: return convertIntegers<std::int8_t>(std::move(phases), nameOf(type));
        case StoredType::int16: return convertIntegers<std::int16_t>(std::move(phases), nameOf(type));
        case StoredType::uint32: return convertIntegers<std::uint32_t>(std::move(phases), nameOf(type));
        case StoredType::int32: return convertIntegers<std::int32_t>(std::move(phases), nameOf(type));
        case StoredType::uint64: return convertIntegers<std::uint64_t>(std::move(phases), nameOf(type));
        case StoredType::int64: return convertIntegers<std::int64_t>(std::move(phases), nameOf(type));
        case StoredType::float32:
        case StoredType::float64: return convertFloats(std::move(phases), type);
    }
    return result;
}

ConvertedVoxels convertRescaledVoxels(std::vector<VoxelBytes> phases, StoredType type, const Rescale& rescale) {
    ConvertedVoxels result;
    withStoredType(type, [&]<typename T>(T) { rescaleAll<T>(phases, rescale, result); });
    result.story = fmt::format("{}, rescaled and kept as float32", nameOf(type));
    result.warning = warningOfNegatives(result.phases);
    return result;
}

}  // namespace echolucent
