#include "processing/tube_core/surface_detection.h"

#include <algorithm>

namespace echolucent {

namespace {

double at(std::span<const double> function, int i) { return function[static_cast<std::size_t>(i)]; }

/// The plateau of equal values around i.
IndexRange plateauAround(std::span<const double> function, int i) {
    IndexRange plateau{i, i};
    const int last = static_cast<int>(function.size()) - 1;
    while (plateau.first > 0 && at(function, plateau.first - 1) == at(function, i)) --plateau.first;
    while (plateau.last < last && at(function, plateau.last + 1) == at(function, i)) ++plateau.last;
    return plateau;
}

bool standsOut(std::span<const double> function, const IndexRange& plateau) {
    const int last = static_cast<int>(function.size()) - 1;
    return plateau.first > 0 && plateau.last < last &&
           at(function, plateau.first - 1) < at(function, plateau.first) &&
           at(function, plateau.last + 1) < at(function, plateau.last);
}

}  // namespace

std::optional<int> firstSignificantMaximum(std::span<const double> function, IndexRange range, double significance,
                                           SignificanceFrom from) {
    range.first = std::max(range.first, 0);
    range.last = std::min(range.last, static_cast<int>(function.size()) - 1);
    if (range.last < range.first) return std::nullopt;
    const auto [smallest, largest] =
        std::minmax_element(function.begin() + range.first, function.begin() + range.last + 1);
    const double origin = from == SignificanceFrom::smallestInRange ? *smallest : 0.0;
    const double threshold = origin + significance * (*largest - origin);
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

std::vector<int> trackSurface(std::span<const double> interfaceFunction, std::span<const GaussianKernel> kernels,
                              const TrackingRule& rule, DetectionScratch& scratch) {
    IndexRange range{0, static_cast<int>(interfaceFunction.size()) - 1};
    if (kernels.empty() || !firstSignificantMaximum(interfaceFunction, range, 0.0)) return {};
    std::vector<int> tracked;
    for (std::size_t scale = 0; scale < kernels.size(); ++scale) {
        kernels[scale].smooth(interfaceFunction, scratch.smoothed, scratch.padded);
        const bool between = scale > 0 && scale + 1 < kernels.size();
        const auto maximum = firstSignificantMaximum(
            scratch.smoothed, range, rule.significance,
            between && rule.aboveSmallest ? SignificanceFrom::smallestInRange : SignificanceFrom::zero);
        if (!maximum && tracked.empty()) return {};
        tracked.push_back(maximum ? *maximum : tracked.back());
        if (maximum) range = valleyToValley(scratch.smoothed, *maximum);
    }
    tracked.push_back(firstSignificantMaximum(interfaceFunction, range, rule.significance).value_or(tracked.back()));
    return tracked;
}

}  // namespace echolucent
