#include "processing/motion/otf_smoothing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "processing/choice_names.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<4> smoothingNames{"none", "mean", "mls", "least-flicker"};
constexpr std::size_t framesOfPaper = 5;
constexpr std::size_t orderOfPaper = 2;

/// The taps, newest first. Of all non-negative weights with a mean age of two frames, they have the least second
/// difference over their sum (docs/motion.md derives them; a test proves the optimum).
constexpr std::array<double, 6> leastFlickerTaps{63, 114, 124, 96, 51, 14};

/// A power of time, less the lower powers, must keep more than this share of its length.
constexpr double leastRemainder = 1e-10;

using Column = std::vector<double>;

double dot(const Column& left, const Column& right) {
    double sum = 0.0;
    for (std::size_t i = 0; i < left.size(); ++i) sum += left[i] * right[i];
    return sum;
}

/// How far each time lies before the newest one, as a share [0,1] of the span from the oldest to the newest.
/// Differences come first and in extended precision: epoch milliseconds keep every digit, and no span overflows or
/// underflows.
std::vector<double> sharesOfSpan(std::span<const double> times) {
    const long double newest = times.back(), span = newest - static_cast<long double>(times.front());
    std::vector<double> shares;
    for (const double time : times)
        shares.push_back(times.size() == 1 ? 0.0
                                           : static_cast<double>((newest - static_cast<long double>(time)) / span));
    return shares;
}

std::vector<double> polynomialWeights(std::span<const double> times) {
    // Ages from -1 (newest) to 1: in this range the powers differ most.
    Column centred = sharesOfSpan(times);
    for (double& age : centred) age = 2.0 * age - 1.0;
    std::vector<Column> orthonormal;
    Column power(times.size(), 1.0);
    for (std::size_t order = 0; order <= std::min(orderOfPaper, times.size() - 1); ++order) {
        Column column = power;
        const double before = std::sqrt(dot(column, column));
        // Two passes of Gram-Schmidt are orthogonal to rounding (Giraud 2005).
        for (int pass = 0; pass < 2; ++pass)
            for (const Column& earlier : orthonormal) {
                const double share = dot(earlier, column);
                for (std::size_t i = 0; i < column.size(); ++i) column[i] -= share * earlier[i];
            }
        const double norm = std::sqrt(dot(column, column));
        if (!(norm > leastRemainder * before)) break;
        for (double& value : column) value /= norm;
        orthonormal.push_back(column);
        for (std::size_t i = 0; i < power.size(); ++i) power[i] *= centred[i];
    }
    // The newest row of Q Q^T needs no R, so nothing is divided by R.
    std::vector<double> weights(times.size(), 0.0);
    for (const Column& column : orthonormal)
        for (std::size_t i = 0; i < weights.size(); ++i) weights[i] += column.back() * column[i];
    return weights;
}

/// The weight at an age in frames, linear between the taps.
double leastFlickerTapAt(double age) {
    const auto before = std::min(static_cast<std::size_t>(age), leastFlickerTaps.size() - 1);
    const std::size_t after = std::min(before + 1, leastFlickerTaps.size() - 1);
    return std::lerp(leastFlickerTaps[before], leastFlickerTaps[after], age - static_cast<double>(before));
}

/// For how long each frame stands: half of the time to the frame before and half of the time to the frame after. The
/// oldest and the newest frame stand outwards for as long as inwards. A single frame has 1.
std::vector<double> heldShares(const std::vector<double>& ages) {
    const std::size_t count = ages.size();
    std::vector<double> held(count, 1.0);
    if (count < 2) return held;
    for (std::size_t i = 0; i < count; ++i) {
        const double older = i > 0 ? ages[i - 1] - ages[i] : ages[0] - ages[1];
        const double newer = i + 1 < count ? ages[i] - ages[i + 1] : ages[count - 2] - ages[count - 1];
        held[i] = 0.5 * (older + newer);
    }
    return held;
}

std::vector<double> leastFlickerWeights(std::span<const double> times) {
    std::vector<double> ages = sharesOfSpan(times);
    for (double& age : ages) age *= static_cast<double>(times.size() - 1);
    std::vector<double> weights = heldShares(ages);
    double sum = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] *= leastFlickerTapAt(ages[i]);
    for (double& weight : weights) weight /= sum;
    return weights;
}

double clampedOpacity(double opacity) { return opacity > 0.0 ? std::min(opacity, 1.0) : 0.0; }

}  // namespace

std::string_view nameOf(OtfSmoothing smoothing) { return nameIn(smoothingNames, smoothing); }

std::optional<OtfSmoothing> otfSmoothingFromName(std::string_view name) {
    return choiceNamed<OtfSmoothing>(smoothingNames, name);
}

std::size_t framesUsed(OtfSmoothing smoothing) {
    switch (smoothing) {
        case OtfSmoothing::none: return 1;
        case OtfSmoothing::mean:
        case OtfSmoothing::movingLeastSquares: return framesOfPaper;
        case OtfSmoothing::leastFlicker: return leastFlickerTaps.size();
    }
    return 1;
}

std::vector<double> smoothingWeights(OtfSmoothing smoothing, std::span<const double> times) {
    if (times.empty() || times.size() > framesUsed(smoothing))
        throw std::invalid_argument("smoothingWeights: more or fewer times than the smoothing uses");
    for (std::size_t i = 0; i < times.size(); ++i)
        if (!std::isfinite(times[i]) || (i > 0 && !(times[i] > times[i - 1])))
            throw std::invalid_argument("smoothingWeights: times must be finite and ascend");
    switch (smoothing) {
        case OtfSmoothing::none: return {1.0};
        case OtfSmoothing::mean: return std::vector<double>(times.size(), 1.0 / static_cast<double>(times.size()));
        case OtfSmoothing::movingLeastSquares: return polynomialWeights(times);
        case OtfSmoothing::leastFlicker: return leastFlickerWeights(times);
    }
    return {};
}

SmoothingGains gainsOf(std::span<const double> weights) {
    SmoothingGains gains{.delay = 0.0, .noise = 0.0, .flicker = 0.0, .leastWeight = 1.0};
    const auto count = static_cast<std::ptrdiff_t>(weights.size());
    const auto at = [&](std::ptrdiff_t i) { return i >= 0 && i < count ? weights[static_cast<std::size_t>(i)] : 0.0; };
    double squares = 0.0, squaredDifferences = 0.0;
    for (std::ptrdiff_t i = 0; i < count + 2; ++i) {
        const double difference = at(i) - 2.0 * at(i - 1) + at(i - 2);
        squaredDifferences += difference * difference;
        squares += at(i) * at(i);
        if (i < count) gains.delay += at(i) * static_cast<double>(count - 1 - i);
        if (i < count) gains.leastWeight = std::min(gains.leastWeight, at(i));
    }
    // The second difference of independent noise has the variance 1 + 4 + 1.
    constexpr double unsmoothedSquares = 6.0;
    gains.noise = std::sqrt(squares);
    gains.flicker = std::sqrt(squaredDifferences / unsmoothedSquares);
    return gains;
}

SmoothingGains gainsOf(OtfSmoothing smoothing) {
    std::vector<double> times(framesUsed(smoothing));
    for (std::size_t i = 0; i < times.size(); ++i) times[i] = static_cast<double>(i);
    return gainsOf(smoothingWeights(smoothing, times));
}

SampledCurve OtfHistory::add(double time, const SampledCurve& unsmoothed) {
    if (!std::isfinite(time)) throw std::invalid_argument("OtfHistory: the time must be finite");
    if (!m_frames.empty() && time < m_frames.back().time)
        throw std::invalid_argument("OtfHistory: the time must not descend");
    if (!m_frames.empty() && unsmoothed.opacities.size() != m_frames.back().opacities.size())
        throw std::invalid_argument("OtfHistory: the number of samples must not change");
    if (!m_frames.empty() && time == m_frames.back().time) m_frames.pop_back();
    m_frames.push_back({time, unsmoothed.opacities});
    for (double& opacity : m_frames.back().opacities) opacity = clampedOpacity(opacity);
    if (m_frames.size() > framesUsed(m_smoothing)) m_frames.pop_front();

    std::vector<double> times;
    for (const Frame& frame : m_frames) times.push_back(frame.time);
    const std::vector<double> weights = smoothingWeights(m_smoothing, times);
    const std::vector<double>& newest = m_frames.back().opacities;
    SampledCurve shown{newest};
    // Adds differences to the newest, so that equal frames give exactly the same OTF.
    for (std::size_t frame = 0; frame + 1 < m_frames.size(); ++frame)
        for (std::size_t i = 0; i < newest.size(); ++i)
            shown.opacities[i] += weights[frame] * (m_frames[frame].opacities[i] - newest[i]);
    for (double& opacity : shown.opacities) opacity = clampedOpacity(opacity);
    return shown;
}

}  // namespace echolucent
