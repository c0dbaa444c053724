#include "processing/near_cut/tissue_level.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

namespace echolucent {

namespace {

/// Sorts numbers of which none is below 0: such numbers have the order of their bits. Whoever opens a volume waits for
/// this sort. A sort by comparisons takes four times as long, also a vectorised one.
std::vector<float> sorted(std::vector<float> values) {
    constexpr int digits = 3, bitsOfDigit = 11;
    const auto digitOf = [](float value, int digit) {
        return std::bit_cast<std::uint32_t>(value) >> (bitsOfDigit * digit) & ((1U << bitsOfDigit) - 1U);
    };
    std::array<std::array<std::size_t, 1U << bitsOfDigit>, digits> places{};
    for (const float value : values)
        for (int digit = 0; digit < digits; ++digit) ++places[static_cast<std::size_t>(digit)][digitOf(value, digit)];
    std::vector<float> moved(values.size());
    for (int digit = 0; digit < digits; ++digit) {
        auto& place = places[static_cast<std::size_t>(digit)];
        std::exclusive_scan(place.begin(), place.end(), place.begin(), std::size_t{0});
        for (const float value : values) moved[place[digitOf(value, digit)]++] = value;
        values.swap(moved);
    }
    return values;
}

}  // namespace

std::optional<double> tissueLevel(std::vector<float> intensities) {
    if (intensities.empty()) return std::nullopt;
    intensities = sorted(std::move(intensities));
    const auto count = static_cast<double>(intensities.size());
    const double total = std::accumulate(intensities.begin(), intensities.end(), 0.0);
    double below = 0.0, best = -1.0, level = total / count;
    for (std::size_t i = 0; i + 1 < intensities.size(); ++i) {
        below += static_cast<double>(intensities[i]);
        const auto dark = static_cast<double>(i + 1);
        const double bright = (total - below) / (count - dark), apart = bright - below / dark;
        // The variance between the classes, but for a constant factor.
        if (const double between = dark * (count - dark) * apart * apart; between > best) {
            best = between;
            level = bright;
        }
    }
    if (!(level > 0.0)) return std::nullopt;
    return level;
}

}  // namespace echolucent
