#include "io/voxels/stored_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "io/voxels/typed_bytes.h"

namespace echolucent {

namespace {

/// Calls visit(span of doubles) with the file's values in blocks.
template <typename Visit>
void forEachBlock(const StoredValues& values, const Visit& visit) {
    constexpr std::size_t blockLength = 4096;
    std::array<double, blockLength> block{};
    withStoredType(values.type, [&]<typename T>(T) {
        for (const VoxelBytes& bytes : values.phases)
            for (std::size_t begin = 0; begin < bytes.size() / sizeof(T); begin += blockLength) {
                const std::size_t count = std::min(blockLength, bytes.size() / sizeof(T) - begin);
                for (std::size_t i = 0; i < count; ++i)
                    block[i] = values.rescale.of(static_cast<double>(storedAt<T>(bytes, begin + i)));
                if (!visit(std::span<const double>(block.data(), count))) return;
            }
    });
}

bool isUnsigned(StoredType type) {
    return type == StoredType::uint8 || type == StoredType::uint16 || type == StoredType::uint32 ||
           type == StoredType::uint64;
}

/// Whether two values above 0 lie so far apart that values near the highest cannot be all there are.
bool areSpread(const StoredValues& values) {
    ValueExtent extent;
    bool spread = false;
    forEachBlock(values, [&](std::span<const double> block) {
        for (const double value : block)
            if (value > 0.0) extent.add(value);
        spread = extent.above > 0 && !mayNeedWindow(extent) && extent.leastAboveZero < extent.highest;
        return !spread;
    });
    return spread;
}

/// Whether all values are 0, or above 0 and ordinary in float32.
bool arePlain(const StoredValues& values) {
    constexpr auto least = static_cast<double>(std::numeric_limits<float>::min());
    constexpr auto most = static_cast<double>(std::numeric_limits<float>::max());
    bool plain = true;
    forEachBlock(values, [&](std::span<const double> block) {
        int odd = 0;
        for (const double value : block) {
            const auto isFinite = static_cast<int>(value - value == 0.0);
            odd |= isFinite & static_cast<int>(value != 0.0) & static_cast<int>(!(value >= least && value <= most));
        }
        plain = odd == 0;
        return plain;
    });
    return plain;
}

/// As arePlain(), but faster, because floats that are not rescaled show it by their bits.
bool arePlainFloats(const std::vector<VoxelBytes>& phases) {
    constexpr std::uint32_t least = 0x00800000, infinity = 0x7F800000, exponent = infinity;
    return std::ranges::all_of(phases, [](const VoxelBytes& bytes) {
        std::uint32_t odd = 0;
        for (std::size_t i = 0; i < bytes.size() / sizeof(float); ++i) {
            const auto bits = storedAt<std::uint32_t>(bytes, i);
            const auto isNormal = static_cast<std::uint32_t>(bits - least < infinity - least);
            const auto isZero = static_cast<std::uint32_t>((bits & ~0x80000000U) == 0);
            const auto isNotFinite = static_cast<std::uint32_t>((bits & exponent) == exponent);
            odd |= (isNormal | isZero | isNotFinite) ^ 1U;
        }
        return odd == 0;
    });
}

/// The stored value nearest to `end` that still gives a finite value of the file.
float farthest(const ValueScale& scale, float end) {
    const double ofFile = scale.storedValue(std::copysign(std::numeric_limits<double>::max(), end));
    if (std::abs(ofFile) < std::abs(static_cast<double>(end))) end = static_cast<float>(ofFile);
    while (!std::isfinite(scale.fileValue(end))) end = std::nextafter(end, 0.0F);
    return end;
}

/// Whether whole numbers stay whole if `black` is taken off them, from 0 to `most`.
bool stayWhole(const ValueScale& scale, const ValueExtent& extent, double most) {
    constexpr double exactBelow = 9007199254740992.0;  // up to here doubles hold every whole number
    return scale.factor == 1.0 && scale.black == std::floor(scale.black) && std::abs(scale.black) < exactBelow &&
           extent.lowest >= scale.black && extent.highest - scale.black <= most;
}

}  // namespace

bool isWholeNumber(StoredType type) { return type != StoredType::float32 && type != StoredType::float64; }

bool areOrdinary(const StoredValues& values) {
    const bool asStored = values.rescale.isIdentity();
    if (asStored && values.type == StoredType::uint8) return true;
    const bool isFloat = asStored && values.type == StoredType::float32;
    if (isFloat ? !arePlainFloats(values.phases) : !(asStored && isUnsigned(values.type)) && !arePlain(values))
        return false;
    return (asStored && values.type == StoredType::int8) || areSpread(values);
}

ValueExtent extentOf(const StoredValues& values) {
    ValueExtent extent;
    forEachBlock(values, [&](std::span<const double> block) {
        for (const double value : block) extent.add(value);
        return true;
    });
    return extent;
}

ValueBlocks blocksOf(const StoredValues& values) {
    return [values](const std::function<void(std::span<const double>)>& take) {
        forEachBlock(values, [&](std::span<const double> block) {
            take(block);
            return true;
        });
    };
}

ConvertedVoxels convertToScale(std::vector<VoxelBytes> phases, StoredType type, const Rescale& rescale,
                               const ValueScale& scale, const ValueExtent& extent) {
    ConvertedVoxels result;
    result.scale = scale;
    const char* kept = "float32";
    withStoredType(type, [&]<typename T>(T) {
        const auto keepAs = [&]<typename To>(To, const auto& become) {
            for (VoxelBytes& bytes : phases)
                result.phases.emplace_back(valuesBecoming<T, To>(std::move(bytes), become));
        };
        if constexpr (std::is_integral_v<T>) {
            using Whole = std::conditional_t<sizeof(T) == 1, std::uint8_t, std::uint16_t>;
            if (rescale.isIdentity() && stayWhole(scale, extent, std::numeric_limits<Whole>::max())) {
                kept = sizeof(Whole) == 1 ? "uint8" : "uint16";
                return keepAs(Whole{}, [black = scale.black](T value) {
                    return static_cast<Whole>(static_cast<double>(value) - black);
                });
            }
        }
        const double most = farthest(scale, std::numeric_limits<float>::max());
        const double least = farthest(scale, std::numeric_limits<float>::lowest());
        keepAs(float{}, [&](T value) {
            const double stored = scale.storedValue(rescale.of(static_cast<double>(value)));
            return static_cast<float>(
                std::isfinite(rescale.of(static_cast<double>(value))) ? std::clamp(stored, least, most) : stored);
        });
    });
    result.story = fmt::format("{}{}, kept as {}{}", nameOf(type), rescale.isIdentity() ? "" : ", rescaled", kept,
                               scale.black != 0.0 ? " less black" : "");
    return result;
}

}  // namespace echolucent
