#include "processing/detection/variance_surface.h"

#include <algorithm>
#include <cmath>

namespace echolucent {

namespace {

double at(std::span<const double> function, int i) { return function[static_cast<std::size_t>(i)]; }

IndexRange plateauAround(std::span<const double> function, int i) {
    IndexRange plateau{i, i};
    const int last = static_cast<int>(function.size()) - 1;
    while (plateau.first > 0 && at(function, plateau.first - 1) == at(function, i)) --plateau.first;
    while (plateau.last < last && at(function, plateau.last + 1) == at(function, i)) ++plateau.last;
    return plateau;
}

bool standsOut(std::span<const double> function, const IndexRange& plateau) {
    const int last = static_cast<int>(function.size()) - 1;
    return plateau.first > 0 && plateau.last < last && at(function, plateau.first - 1) < at(function, plateau.first) &&
           at(function, plateau.last + 1) < at(function, plateau.last);
}

}  // namespace

std::optional<int> firstSignificantMaximum(std::span<const double> function, IndexRange range, double significance) {
    range.first = std::max(range.first, 0);
    range.last = std::min(range.last, static_cast<int>(function.size()) - 1);
    if (range.last < range.first) return std::nullopt;
    const double threshold =
        significance * *std::max_element(function.begin() + range.first, function.begin() + range.last + 1);
    for (int i = range.first; i <= range.last;) {
        const IndexRange plateau = plateauAround(function, i);
        const int middle = (plateau.first + plateau.last) / 2;
        if (standsOut(function, plateau) && middle >= range.first && middle <= range.last &&
            at(function, i) >= threshold)
            return middle;
        i = plateau.last + 1;
    }
    return std::nullopt;
}

IndexRange valleyToValley(std::span<const double> function, int position) {
    IndexRange range{position, position};
    const int last = static_cast<int>(function.size()) - 1;
    while (range.first > 0 && at(function, range.first - 1) <= at(function, range.first)) --range.first;
    while (range.last < last && at(function, range.last + 1) <= at(function, range.last)) ++range.last;
    return range;
}

void takeOffFloor(std::span<const double> function, double quantile, std::vector<double>& result) {
    result.assign(function.begin(), function.end());
    if (result.empty() || quantile == 0.0) return;
    const auto rank = static_cast<std::ptrdiff_t>(quantile * static_cast<double>(result.size() - 1));
    std::nth_element(result.begin(), result.begin() + rank, result.end());
    const double floor = result[static_cast<std::size_t>(rank)];
    std::transform(function.begin(), function.end(), result.begin(),
                   [floor](double value) { return std::max(0.0, value - floor); });
}

namespace {

IndexRange around(int position, double halfWidth) {
    const int half = static_cast<int>(std::floor(halfWidth));
    return {position - half, position + half};
}

/// Tracks through `scratch.aboveFloor`, and tells `trace`, if it is given.
std::vector<int> track(const IndexRange& whole, ScaleSmoother& smoother, const VarianceRule& rule,
                       DetectionScratch& scratch, std::vector<TrackedScale>* trace) {
    const std::size_t scales = smoother.space().scales();
    IndexRange range = whole;
    smoother.begin(scratch.aboveFloor);
    std::vector<int> tracked;
    for (std::size_t scale = 0; scale <= scales; ++scale) {
        const bool unsmoothed = scale == scales;
        if (unsmoothed && tracked.empty()) return {};
        if (!unsmoothed) smoother.smooth(scale, scratch.smoothed);
        const std::vector<double>& function = unsmoothed ? scratch.aboveFloor : scratch.smoothed;
        const auto maximum = firstSignificantMaximum(function, range, rule.significance);
        if (trace != nullptr)
            trace->push_back({unsmoothed ? std::nullopt : std::optional(smoother.space().sigma(scale)), function,
                              IndexRange{std::max(range.first, whole.first), std::min(range.last, whole.last)},
                              maximum});
        if (!maximum && tracked.empty()) {
            if (rule.coarsestMustHaveMaximum) return {};
            continue;
        }
        tracked.push_back(maximum ? *maximum : tracked.back());
        if (!maximum || unsmoothed) continue;
        range = rule.trackingRangeSigmas > 0.0
                    ? around(*maximum, rule.trackingRangeSigmas * smoother.space().sigma(scale))
                    : valleyToValley(function, *maximum);
    }
    return tracked;
}

}  // namespace

std::vector<int> trackSurface(std::span<const double> interfaceFunction, ScaleSmoother& smoother,
                              const VarianceRule& rule, DetectionScratch& scratch, std::vector<TrackedScale>* trace) {
    const IndexRange whole{0, static_cast<int>(interfaceFunction.size()) - 1};
    const bool hasMaximum =
        smoother.space().scales() > 0 && firstSignificantMaximum(interfaceFunction, whole, 0.0).has_value();
    if (!hasMaximum && trace == nullptr) return {};
    takeOffFloor(interfaceFunction, rule.floorQuantile, scratch.aboveFloor);
    std::vector<int> tracked;
    if (hasMaximum) tracked = track(whole, smoother, rule, scratch, trace);
    if (trace != nullptr && (trace->empty() || trace->back().sigma))
        trace->push_back({std::nullopt, scratch.aboveFloor, {}, std::nullopt});
    return tracked;
}

}  // namespace echolucent
