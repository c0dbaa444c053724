#include "processing/volume/black_level.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace echolucent {

namespace {

using Float = std::numeric_limits<float>;

/// The values but for `padding`, each turned into another by `become`.
template <typename Become>
ValueBlocks turned(const ValueBlocks& values, const std::optional<double>& padding, const Become& become) {
    return [&values, padding, become](const std::function<void(std::span<const double>)>& take) {
        std::vector<double> others;
        values([&](std::span<const double> block) {
            others.clear();
            for (const double value : block)
                if (!padding || value != *padding) others.push_back(become(value));
            take(others);
        });
    };
}

bool holdsRange(double range) {
    return range >= static_cast<double>(Float::min()) && range <= static_cast<double>(Float::max());
}

/// A value that many voxels hold, farther below all others than they reach.
std::optional<double> paddingOf(const ValueExtent& extent) {
    constexpr std::int64_t fewVoxels = 8;
    if (extent.lowest >= 0.0 || extent.atLowest <= fewVoxels) return std::nullopt;
    const double reach = extent.highest - extent.leastAboveLowest;
    if (!(reach > 0.0) || !(extent.leastAboveLowest - extent.lowest > reach)) return std::nullopt;
    return extent.lowest;
}

}  // namespace

void ValueExtent::add(double value) {
    if (!std::isfinite(value)) return;
    if (!any) {
        lowest = highest = leastAboveLowest = value;
        any = true;
    }
    if (value < lowest) {
        leastAboveLowest = lowest;
        lowest = value;
        atLowest = 0;
    } else if (value > lowest && (leastAboveLowest == lowest || value < leastAboveLowest)) {
        leastAboveLowest = value;
    }
    if (value == lowest) ++atLowest;
    highest = std::max(highest, value);
    below += value < 0.0 ? 1 : 0;
    if (value > 0.0) {
        leastAboveZero = above == 0 ? value : std::min(leastAboveZero, value);
        ++above;
    }
}

bool mayNeedWindow(const ValueExtent& extent) {
    constexpr double narrow = 63.0 / 64.0;
    if (!extent.any) return false;
    if (extent.below > 0) return true;
    if (extent.above == 0) return false;
    return !holdsRange(extent.highest) || extent.leastAboveZero < static_cast<double>(Float::min()) ||
           (extent.leastAboveZero > narrow * extent.highest && extent.leastAboveZero < extent.highest);
}

BlackLevel blackLevelOf(const ValueBlocks& values, bool wholeNumbers, const ValueExtent& extent) {
    constexpr std::int64_t tenth = 10;
    constexpr double hidden = 0.01, narrow = 63.0 / 64.0;
    BlackLevel black;
    black.lowest = extent.lowest;
    const auto padding = paddingOf(extent);
    const std::int64_t below = extent.below - (padding ? extent.atLowest : 0);
    if (below == 0) {
        if (extent.leastAboveZero <= narrow * extent.highest || extent.leastAboveZero == extent.highest) return black;
        black.level = extent.leastAboveZero;
        black.padding = padding;
        return black;
    }
    if (below * tenth <= below + extent.above) return black;
    const WhiteLevel mirrored =
        whiteLevelOf(turned(values, padding, [](double value) { return -value; }), wholeNumbers);
    // Fewer than one of a hundred above 0 may be hot voxels, which say nothing of how deep the others lie.
    if (extent.above * 100 > below) {
        const double high = whiteLevelOf(values, wholeNumbers).level;
        if (!(mirrored.level > hidden * high + hidden * mirrored.level)) return black;
    }
    black.level = -mirrored.level;
    black.below = mirrored.above + (padding ? extent.atLowest : 0);
    black.padding = padding;
    return black;
}

ValueScale scaleFrom(double black, const ValueBlocks& values, bool wholeNumbers, const ValueExtent& extent) {
    // The range of doubles may be larger than the largest of them; its half is not.
    const bool halved = std::isinf(extent.highest - black);
    const double part = halved ? 0.5 : 1.0;
    const auto above = [black, part](double value) { return value * part - black * part; };
    double range = whiteLevelOf(turned(values, std::nullopt, above), wholeNumbers && !halved).level;
    // All values may be one, which is black.
    if (!(range > 0.0)) range = std::abs(black) * part;
    if (!(range > 0.0) || (!halved && holdsRange(range))) return {black, 1.0};
    return {black, std::ldexp(1.0, std::ilogb(range))};
}

bool suitsAsBlack(double declared, const BlackLevel& measured, const ValueExtent& extent) {
    constexpr double whiteBeyond = 8.0;
    if (!std::isfinite(declared) || declared >= extent.highest) return false;
    // Divided first: the range of doubles may be larger than the largest of them.
    return measured.level / (2 * whiteBeyond) - declared / (2 * whiteBeyond) <= extent.highest / 2 - measured.level / 2;
}

}  // namespace echolucent
