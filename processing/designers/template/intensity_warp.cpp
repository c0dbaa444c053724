#include "processing/designers/template/intensity_warp.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "processing/parallel.h"

namespace echolucent {

namespace {

constexpr std::size_t binsPerStep = 2, steps = warpBins / binsPerStep;
constexpr std::ptrdiff_t placesPerBin = 8;
// The least slope is at most 1, so a warp can always stay within these places as it enters or leaves [0,1].
constexpr auto firstPlace = -static_cast<std::ptrdiff_t>(warpBins) * placesPerBin;
constexpr std::size_t places = 3 * warpBins * placesPerBin + 1;
// The inner edges of the first and last bin, which hold all that was cut off.
constexpr auto lowPlace = static_cast<std::size_t>(placesPerBin - firstPlace);
constexpr std::size_t highPlace = lowPlace + (warpBins - 2) * placesPerBin;

/// Cumulative distribution at the edges of the bins, linear between them. Voxels of the first or the last bin may lie
/// anywhere beyond its inner edge. So least() and largest() give the range of possible values.
class Cumulative {
public:
    explicit Cumulative(std::span<const double> shares) : m_edges(warpBins + 1, 0.0) {
        std::partial_sum(shares.begin(), shares.end(), m_edges.begin() + 1);
        for (double& edge : m_edges) edge /= m_edges.back();
    }
    /// At a place in bins.
    [[nodiscard]] double at(double place) const {
        const double inside = std::clamp(place, 0.0, static_cast<double>(warpBins));
        const auto bin = std::min(static_cast<std::size_t>(inside), warpBins - 1);
        return m_edges[bin] + (inside - static_cast<double>(bin)) * (m_edges[bin + 1] - m_edges[bin]);
    }
    [[nodiscard]] double least(double place) const {
        return isLow(place) ? 0.0 : isHigh(place) ? m_edges[warpBins - 1] : at(place);
    }
    [[nodiscard]] double largest(double place) const {
        return isLow(place) ? m_edges[1] : isHigh(place) ? 1.0 : at(place);
    }
    /// Whether a place lies within or beyond the first, or the last, bin, which hold all that was cut off.
    [[nodiscard]] static bool isLow(double place) { return place <= 1.0; }
    [[nodiscard]] static bool isHigh(double place) { return place >= static_cast<double>(warpBins - 1); }

private:
    std::vector<double> m_edges;
};

/// The weights of a comparison: for squared differences of logarithms of shares, for those of cumulative distributions,
/// and for squared logarithms of slopes. docs/designers/template.md says how they were chosen.
struct Weights {
    double logarithm, cumulative, slope;
};
Weights weightsOf(TemplateComparison comparison) {
    return comparison == TemplateComparison::logarithm ? Weights{1.0, 3.0, 0.003} : Weights{0.0, 1.0, 1e-6};
}

double square(double value) { return value * value; }

double placeInBins(std::size_t place) {
    return static_cast<double>(static_cast<std::ptrdiff_t>(place) + firstPlace) / placesPerBin;
}

/// The costs of all steps of all warps.
class Costs {
public:
    Costs(const Cumulative& reference, const Cumulative& other, const WarpRule& rule)
        : m_weights(weightsOf(rule.comparison)), m_reference(reference), m_other(other) {
        constexpr double one = binsPerStep * placesPerBin;
        // A slope of a whole number of places stays allowed despite rounding.
        m_shortest = static_cast<std::size_t>(std::ceil(rule.leastSlope * one - 1e-9));
        m_longest = static_cast<std::size_t>(std::floor(rule.largestSlope * one + 1e-9));
        for (std::size_t length = m_shortest; length <= m_longest; ++length)
            m_slopes.push_back(m_weights.slope * square(std::log(static_cast<double>(length) / one)));
        m_logShares.resize(places * lengths());
        parallelFor(std::size_t{0}, places, [&](std::size_t to) {
            for (std::size_t length = m_shortest; length <= std::min(m_longest, to); ++length) {
                const std::size_t from = to - length;
                logShare(to, length) = logOf(shareOf(from, to, from <= lowPlace, to >= highPlace));
            }
        });
    }

    [[nodiscard]] std::size_t shortest() const { return m_shortest; }
    [[nodiscard]] std::size_t lengths() const { return m_longest - m_shortest + 1; }
    [[nodiscard]] double slope(std::size_t length) const { return m_slopes[length - m_shortest]; }

    /// Cost of a node: the difference of the cumulative distributions.
    [[nodiscard]] double atNode(std::size_t step, std::size_t place) const {
        const auto v = static_cast<double>(step * binsPerStep);
        const double u = placeInBins(place);
        const double apart = std::max({0.0, m_reference.least(v) - m_other.largest(u),  //
                                       m_other.least(u) - m_reference.largest(v)});
        return m_weights.cumulative * square(apart);
    }

    /// The shares that a step along the reference's axis holds, as logarithms.
    struct Step {
        bool first, last;
        double share[2][2];      ///< [with all that lies before it][with all that lies behind it]
        double cutLow, cutHigh;  ///< cost of the step if it lies beyond an end of the other axis
    };
    [[nodiscard]] Step alongReference(std::size_t step) const {
        const double before = m_reference.at(static_cast<double>((step - 1) * binsPerStep));
        const double until = m_reference.at(static_cast<double>(step * binsPerStep));
        // The bin at that end must hold what the reference holds up to there.
        const auto cutOff = [&](double needed, double held) {
            return m_weights.logarithm * square(std::max(0.0, logOf(needed) - logOf(held)));
        };
        return {step == 1,
                step == steps,
                {{logOf(until - before), logOf(1.0 - before)}, {logOf(until), logOf(1.0)}},
                cutOff(until, m_other.at(1.0)),
                cutOff(1.0 - before, 1.0 - m_other.at(warpBins - 1))};
    }

    /// Cost of a step that ends at `to`: the difference of the shares along it.
    [[nodiscard]] double alongStep(const Step& step, std::size_t to, std::size_t length) const {
        if (m_weights.logarithm == 0.0) return 0.0;
        const std::size_t from = to - length;
        if (to <= lowPlace) return step.cutLow;
        if (from >= highPlace) return step.cutHigh;
        const bool low = step.first || from <= lowPlace, high = step.last || to >= highPlace;
        const double other = step.first || step.last ? logOf(shareOf(from, to, low, high)) : logShare(to, length);
        return m_weights.logarithm * square(step.share[low ? 1 : 0][high ? 1 : 0] - other);
    }

private:
    /// The share of voxels between two places; `low` adds all before, `high` all behind.
    [[nodiscard]] double shareOf(std::size_t from, std::size_t to, bool low, bool high) const {
        return (high ? 1.0 : m_other.at(placeInBins(to))) - (low ? 0.0 : m_other.at(placeInBins(from)));
    }
    /// Shares below `least` are no more than chance.
    [[nodiscard]] static double logOf(double share) {
        constexpr double least = 2e-4 * binsPerStep;
        return std::log(std::max(share, 0.0) + least);
    }
    [[nodiscard]] double& logShare(std::size_t to, std::size_t length) {
        return m_logShares[to * lengths() + length - m_shortest];
    }
    [[nodiscard]] double logShare(std::size_t to, std::size_t length) const {
        return m_logShares[to * lengths() + length - m_shortest];
    }

    Weights m_weights;
    const Cumulative& m_reference;
    const Cumulative& m_other;
    std::size_t m_shortest, m_longest;
    std::vector<double> m_slopes;
    std::vector<double> m_logShares;
};

/// The root of the mean cost of a path, without the price of its slopes.
double distanceAlong(const Costs& costs, const std::vector<std::size_t>& path) {
    double sum = costs.atNode(0, path[0]);
    for (std::size_t step = 1; step <= steps; ++step)
        sum += costs.atNode(step, path[step]) +
               costs.alongStep(costs.alongReference(step), path[step], path[step] - path[step - 1]);
    return std::sqrt(sum / static_cast<double>(steps + 1));
}

void requireShares(std::span<const double> shares) {
    double sum = 0.0;
    for (const double share : shares) sum += share >= 0.0 ? share : std::numeric_limits<double>::quiet_NaN();
    if (shares.size() != warpBins || !(std::abs(sum - 1.0) < 1e-6))
        throw std::invalid_argument("findWarp: a histogram has 256 shares, 0 or more, with a sum of 1");
}

/// The place of each node of the cheapest warp; empty if the work was cancelled.
std::optional<std::vector<std::size_t>> cheapestPath(const Costs& costs, const Progress& progress) {
    constexpr double never = std::numeric_limits<double>::infinity();
    std::vector<double> cost(places), next(places);
    for (std::size_t place = 0; place < places; ++place) cost[place] = costs.atNode(0, place);
    std::vector<std::uint16_t> lengths((steps + 1) * places);
    const std::size_t shortest = costs.shortest(), longest = shortest + costs.lengths() - 1;
    for (std::size_t step = 1; step <= steps; ++step) {
        if (progress.cancelled()) return std::nullopt;
        const Costs::Step along = costs.alongReference(step);
        parallelFor(LoopRange<std::size_t>(0, places, 256), [&](const auto& range) {
            for (std::size_t to = range.begin(); to < range.end(); ++to) {
                double least = never;
                std::size_t best = shortest;
                for (std::size_t length = shortest; length <= std::min(longest, to); ++length) {
                    const double before = cost[to - length] + costs.slope(length);
                    if (before >= least) continue;
                    const double whole = before + costs.alongStep(along, to, length);
                    if (whole >= least) continue;
                    least = whole;
                    best = length;
                }
                next[to] = least + costs.atNode(step, to);
                lengths[step * places + to] = static_cast<std::uint16_t>(best);
            }
        });
        std::swap(cost, next);
        progress.at(static_cast<double>(step) / steps);
    }
    std::vector<std::size_t> path(steps + 1);
    path[steps] = static_cast<std::size_t>(std::ranges::min_element(cost) - cost.begin());
    for (std::size_t step = steps; step > 0; --step) path[step - 1] = path[step] - lengths[step * places + path[step]];
    return path;
}

}  // namespace

double IntensityWarp::at(double reference) const {
    const double place = (reference > 0.0 ? std::min(reference, 1.0) : 0.0) * static_cast<double>(values.size() - 1);
    const auto before = std::min(static_cast<std::size_t>(place), values.size() - 2);
    return std::lerp(values[before], values[before + 1], place - static_cast<double>(before));
}

double IntensityWarp::inverse(double other) const {
    if (!(other > values.front())) return 0.0;
    if (other >= values.back()) return 1.0;
    const auto after = static_cast<std::size_t>(std::ranges::upper_bound(values, other) - values.begin());
    const double low = values[after - 1], high = values[after];
    return (static_cast<double>(after - 1) + (other - low) / (high - low)) / static_cast<double>(values.size() - 1);
}

std::optional<FoundWarp> findWarp(std::span<const double> reference, std::span<const double> other,
                                  const WarpRule& rule, const Progress& progress) {
    requireShares(reference);
    requireShares(other);
    if (!(rule.leastSlope >= 1.0 / 8.0 && rule.leastSlope <= 1.0 && rule.largestSlope >= 1.0 &&
          rule.largestSlope <= 8.0))
        throw std::invalid_argument("findWarp: slopes must be 1/8 to 1 and 1 to 8");
    const Cumulative ofReference(reference), ofOther(other);
    const Costs costs(ofReference, ofOther, rule);
    const auto path = cheapestPath(costs, progress);
    if (!path) return std::nullopt;
    FoundWarp found;
    found.warp.values.clear();
    for (const std::size_t place : *path)
        found.warp.values.push_back(placeInBins(place) / static_cast<double>(warpBins));
    std::vector<std::size_t> identity(steps + 1);
    for (std::size_t step = 0; step <= steps; ++step)
        identity[step] = step * binsPerStep * placesPerBin + static_cast<std::size_t>(-firstPlace);
    found.distanceBefore = distanceAlong(costs, identity);
    found.distance = distanceAlong(costs, *path);
    return found;
}

}  // namespace echolucent
