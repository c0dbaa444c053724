#include "processing/volume/black_level.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace echolucent {

namespace {

using Float = std::numeric_limits<float>;

/// The share of the highest value above which values of a narrow range lie.
constexpr double narrowFrom = 63.0 / 64.0;
/// A lowest value that so few voxels hold is no padding and no outside.
constexpr std::int64_t fewAtLowest = 8;

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
    if (extent.lowest >= 0.0 || extent.atLowest <= fewAtLowest) return std::nullopt;
    const double reach = extent.highest - extent.leastAboveLowest;
    if (!(reach > 0.0) || !(extent.leastAboveLowest - extent.lowest > reach)) return std::nullopt;
    return extent.lowest;
}

/// Finite values in rising order that stand for all that are not `left`: every 3^k-th, so that they need little memory.
/// No side of a grid is likely to be a multiple of 3^k.
std::vector<double> sampleWithout(double left, const ValueBlocks& values) {
    constexpr std::size_t most = std::size_t{3} << 16;
    constexpr std::size_t thinner = 3;
    std::vector<double> sample;
    std::size_t every = 1, toSkip = 0;
    values([&](std::span<const double> block) {
        for (const double value : block) {
            if (value == left || !std::isfinite(value)) continue;
            if (toSkip > 0) {
                --toSkip;
                continue;
            }
            if (sample.size() == most) {
                for (std::size_t i = 0; i < most / thinner; ++i) sample[i] = sample[i * thinner];
                sample.resize(most / thinner);
                every *= thinner;
            }
            sample.push_back(value);
            toSkip = every - 1;
        }
    });
    std::sort(sample.begin(), sample.end());
    return sample;
}

/// What lies above a lowest value that 2 % of the voxels or more hold, as the outside of a volume does. Interpolation
/// and means of blocks fill the gap between them with a few values, which do not count.
struct AboveOutside {
    double low = 0.0, high = 0.0;       ///< the ends of what counts
    std::int64_t below = 0, above = 0;  ///< how many values of a sample count, and lie below or above 0
};

/// The least of the sample that is reached from its lower quarter through values that lie close together: each step
/// down of a 16th of the range meets a 200th of the sample or more.
double denseLowEnd(const std::vector<double>& sample, double high) {
    constexpr std::ptrdiff_t steps = 16, sparse = 200;
    const auto count = static_cast<std::ptrdiff_t>(sample.size());
    auto low = sample.begin() + count / 4;
    const double step = high / steps - *low / steps;
    while (low != sample.begin()) {
        const auto next = std::lower_bound(sample.begin(), low, *low - step);
        if (next == low || (low - next) * sparse < count) break;
        low = next;
    }
    return *low;
}

std::optional<AboveOutside> aboveOutside(const ValueBlocks& values, const ValueExtent& extent) {
    constexpr std::int64_t fiftieth = 50, hundredth = 100, rareInSample = 1000;
    const std::int64_t all = extent.below + extent.above;
    if (extent.lowest >= 0.0 || extent.atLowest <= fewAtLowest || extent.atLowest * fiftieth < all ||
        (all - extent.atLowest) * hundredth <= extent.atLowest)
        return std::nullopt;
    const std::vector<double> sample = sampleWithout(extent.lowest, values);
    if (sample.empty() || sample.front() == sample.back()) return std::nullopt;
    AboveOutside found;
    found.high = *(sample.end() - 1 - static_cast<std::int64_t>(sample.size()) / rareInSample);
    found.low = denseLowEnd(sample, found.high);
    const auto begin = std::lower_bound(sample.begin(), sample.end(), found.low);
    found.below = std::lower_bound(begin, sample.end(), 0.0) - begin;
    found.above = sample.end() - std::upper_bound(begin, sample.end(), 0.0);
    return found;
}

std::int64_t countBelow(double level, const ValueBlocks& values) {
    std::int64_t count = 0;
    values([&](std::span<const double> block) {
        for (const double value : block) count += std::isfinite(value) && value < level ? 1 : 0;
    });
    return count;
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
    if (!extent.any) return false;
    if (extent.below > 0) return true;
    if (extent.above == 0) return false;
    return !holdsRange(extent.highest) || extent.leastAboveZero < static_cast<double>(Float::min()) ||
           (extent.leastAboveZero > narrowFrom * extent.highest && extent.leastAboveZero < extent.highest);
}

bool mayHideMuch(const ValueExtent& extent) {
    constexpr std::int64_t tenth = 10;
    const auto padding = paddingOf(extent);
    const std::int64_t below = extent.below - (padding ? extent.atLowest : 0);
    if (below == 0)
        return extent.leastAboveZero > narrowFrom * extent.highest && extent.leastAboveZero != extent.highest;
    return below * tenth > below + extent.above;
}

BlackLevel blackLevelOf(const ValueBlocks& values, bool wholeNumbers, const ValueExtent& extent) {
    constexpr std::int64_t tenth = 10, hundredth = 100;
    constexpr double hidden = 0.01;
    BlackLevel black;
    black.lowest = extent.lowest;
    if (!mayHideMuch(extent)) return black;
    const auto padding = paddingOf(extent);
    const std::int64_t below = extent.below - (padding ? extent.atLowest : 0);
    if (below == 0) {
        black.level = extent.leastAboveZero;
        black.padding = padding;
        return black;
    }
    if (const auto rest = padding ? std::nullopt : aboveOutside(values, extent)) {
        if (rest->below * tenth <= rest->below + rest->above) return black;
        if (rest->low / 2 - extent.lowest / 2 > rest->high / 2 - rest->low / 2) {
            const bool isShallow = !(-rest->low > hidden * rest->high - hidden * rest->low);
            if (rest->above * hundredth > rest->below && isShallow) return black;
            black.level = rest->low;
            black.below = countBelow(rest->low, values);
            black.padding = extent.lowest;
            return black;
        }
    }
    const WhiteLevel mirrored =
        whiteLevelOf(turned(values, padding, [](double value) { return -value; }), wholeNumbers);
    const auto isDeepBeside = [&](double high) { return mirrored.level > hidden * high + hidden * mirrored.level; };
    // Fewer than one of a hundred above 0 may be hot voxels, which say nothing of how deep the others lie. The high end
    // takes two passes, and no end is higher than the highest value.
    if (extent.above * hundredth > below && !isDeepBeside(extent.highest) &&
        !isDeepBeside(whiteLevelOf(values, wholeNumbers).level))
        return black;
    black.level = -mirrored.level;
    black.below = mirrored.above + (padding ? extent.atLowest : 0);
    black.padding = padding;
    return black;
}

ValueScale scaleFrom(double black, const ValueBlocks& values, bool wholeNumbers, const ValueExtent& extent) {
    // The range of doubles may be larger than the largest of them; its half is not.
    const bool halved = std::isinf(extent.highest - black);
    // Ranges of whole numbers are whole; and no end lies beyond the values. That spares two passes. A black that a file
    // states may lie far from all of them.
    if (wholeNumbers && holdsRange(std::max(extent.highest - black, std::abs(black)))) return {black, 1.0};
    if (black == 0.0 && holdsRange(extent.highest) && holdsRange(extent.leastAboveZero)) return {0.0, 1.0};
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
