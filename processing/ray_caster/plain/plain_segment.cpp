#include "processing/ray_caster/plain/plain_segment.h"

#include <algorithm>
#include <cmath>

namespace echolucent::plain_casting {

namespace {

constexpr double largestExtinction = 40.0;  // what opacity 1 counts as
constexpr int evenIntervals = 4096;
/// Closer ends are one point: a mean over them would lose its digits.
constexpr double closest = 1e-9;

/// Where a curve has a corner or a step.
std::vector<double> cornersOf(const OpacityCurve& curve) {
    std::vector<double> corners;
    if (const auto* manual = std::get_if<ManualCurve>(&curve)) {
        for (const CurveNode& node : manual->nodes) corners.push_back(node.intensity);
    } else if (const auto* linear = std::get_if<LinearCurve>(&curve)) {
        corners = {linear->lower, linear->upper};
    } else if (const auto* sampled = std::get_if<SampledCurve>(&curve)) {
        const std::size_t count = sampled->opacities.size();
        for (std::size_t i = 1; i + 1 < count; ++i)
            corners.push_back(static_cast<double>(i) / static_cast<double>(count - 1));
    }
    return corners;
}

}  // namespace

SegmentIntegral::SegmentIntegral(const OpacityCurve& curve) : m_curve(curve) {
    for (int i = 0; i <= evenIntervals; ++i) m_ends.push_back(static_cast<double>(i) / evenIntervals);
    for (const double corner : cornersOf(curve))
        if (corner > 0.0 && corner < 1.0) m_ends.push_back(corner);
    std::sort(m_ends.begin(), m_ends.end());
    m_ends.erase(std::unique(m_ends.begin(), m_ends.end()), m_ends.end());
    m_before.assign(m_ends.size(), Sums{});
    for (std::size_t i = 1; i < m_ends.size(); ++i) {
        const Sums part = integrated(m_ends[i - 1], m_ends[i]);
        for (std::size_t c = 0; c < part.size(); ++c) m_before[i][c] = m_before[i - 1][c] + part[c];
    }
}

SegmentIntegral::Sums SegmentIntegral::at(double intensity) const {
    const double tau = std::min(-std::log1p(-opacityAt(m_curve, intensity)), largestExtinction);
    return {tau, tau * intensity};
}

SegmentIntegral::Sums SegmentIntegral::integrated(double low, double high) const {
    // Abscissae and weights of four points on [-1, 1].
    static constexpr std::array<double, 4> places{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                                  0.8611363115940526};
    static constexpr std::array<double, 4> weights{0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                                   0.3478548451374538};
    const double middle = 0.5 * (low + high), half = 0.5 * (high - low);
    Sums sums{};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Sums here = at(middle + half * places[i]);
        for (std::size_t c = 0; c < sums.size(); ++c) sums[c] += half * weights[i] * here[c];
    }
    return sums;
}

Extinction SegmentIntegral::between(double first, double second) const {
    const double low = std::min(first, second), high = std::max(first, second);
    Sums sums{};
    double width = high - low;
    if (width < closest) {
        sums = at(first);
        width = 1.0;
    } else {
        const auto from = std::lower_bound(m_ends.begin(), m_ends.end(), low);
        const auto after = std::upper_bound(m_ends.begin(), m_ends.end(), high);
        if (from < after) {
            const auto i = static_cast<std::size_t>(from - m_ends.begin());
            const auto j = static_cast<std::size_t>(after - m_ends.begin()) - 1;
            const Sums left = integrated(low, m_ends[i]), right = integrated(m_ends[j], high);
            for (std::size_t c = 0; c < sums.size(); ++c)
                sums[c] = left[c] + (m_before[j][c] - m_before[i][c]) + right[c];
        } else {
            sums = integrated(low, high);
        }
    }
    return {sums[0] / width, sums[0] > 0.0 ? sums[1] / sums[0] : first};
}

}  // namespace echolucent::plain_casting
