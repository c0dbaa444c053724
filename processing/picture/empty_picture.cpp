#include "processing/picture/empty_picture.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <utility>
#include <variant>

namespace echolucent {

namespace {

std::string intensityText(double intensity) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), intensity, std::chars_format::fixed, 3).ptr;
    return {text.data(), end};
}

/// The lowest and highest intensity that the occupied bins hold.
std::pair<double, double> rangeOf(const IntensityHistogram& data) {
    const auto& counts = data.counts;
    const auto occupied = [](std::uint64_t count) { return count > 0; };
    const auto bins = static_cast<double>(counts.size());
    const auto low = std::find_if(counts.begin(), counts.end(), occupied) - counts.begin();
    const auto end = counts.rend() - std::find_if(counts.rbegin(), counts.rend(), occupied);
    return {static_cast<double>(low) / bins, static_cast<double>(end) / bins};
}

double largestOpacity(const OpacityCurve& curve, double low, double high) {
    constexpr int samples = 2049;
    double largest = 0.0;
    for (int i = 0; i < samples; ++i)
        largest = std::max(largest, opacityAt(curve, low + (high - low) * i / (samples - 1)));
    // A peak may be narrower than the distance between samples.
    if (const auto* manual = std::get_if<ManualCurve>(&curve))
        for (const CurveNode& node : manual->nodes)
            if (node.intensity >= low && node.intensity <= high) largest = std::max(largest, node.opacity);
    return largest;
}

}  // namespace

bool showsNothing(const OpacityCurve& curve, const IntensityHistogram& data) {
    constexpr double clear = 2e-5;
    if (data.total == 0) return true;
    const auto [low, high] = rangeOf(data);
    return largestOpacity(curve, low, high) < clear;
}

std::string whyNothingShows(const OpacityCurve& curve, const IntensityHistogram& data) {
    if (!showsNothing(curve, data)) return {};
    if (data.total == 0) return "Nothing is shown: no voxel of the volume is data.";
    const auto [low, high] = rangeOf(data);
    return "Nothing is shown: the curve is 0 over all intensities of the data (" + intensityText(low) + " to " +
           intensityText(high) + "). Let it rise below " + intensityText(high) + ", or choose another curve.";
}

}  // namespace echolucent
