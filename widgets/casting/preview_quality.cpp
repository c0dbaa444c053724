#include "widgets/casting/preview_quality.h"

#include <algorithm>

namespace echolucent {

namespace {

constexpr double newestMeasureShare = 0.5;  // weight of the newest measure in a learnt cost
constexpr double smallestBudget = 1.0 / 3;  // of a frame, however slowly pictures reach the screen
constexpr double smallestLitEdit = 0.5;     // of a picture's budget for the rays, however long an edit's light takes
constexpr double reclassifyShare = 0.25;    // of the cost of sampling, until it is measured
constexpr double shadedRatio = 4.0;         // of the cost of sampling, until it is measured

double pixelsOf(const RayCastSettings& settings) { return static_cast<double>(settings.width) * settings.height; }
double samplesOf(const RayCastSettings& settings) { return pixelsOf(settings) / settings.step; }

/// Whether a picture needs a light volume.
bool isLit(const RayCastSettings& settings) { return settings.shading && settings.shading->asksWhatReaches(); }

void learn(double& cost, double measured) {
    cost = cost > 0.0 ? cost + newestMeasureShare * (measured - cost) : measured;
}

/// Shares of the budget at which another quality is taken.
struct Reluctance {
    double toCoarsen;  // if the quality's cost is above this share
    double toRefine;   // if the next finer quality's cost is not above this share
};
constexpr Reluctance usual{1.0, 0.7};
constexpr Reluctance withinSeries{1.5, 0.35};

/// The finest quality within the budget, searched from a given one.
template <typename Cost>
std::size_t qualityWithin(double budget, std::size_t quality, const Reluctance& reluctance, const Cost& cost) {
    while (quality + 1 < qualities.size() && cost(quality) > reluctance.toCoarsen * budget) ++quality;
    while (quality > 0 && cost(quality - 1) <= reluctance.toRefine * budget) --quality;
    return quality;
}

}  // namespace

void PreviewQuality::sampled(const RayCastSettings& settings, double milliseconds, double castShare) {
    learn(costOf(settings).sampling, milliseconds / (samplesOf(settings) * castShare));
    if (settings.pixelTolerance > 0.0) {
        m_castShare = castShare;
        m_castSharePixels = pixelsOf(settings);
    }
}

void PreviewQuality::reclassified(const RayCastSettings& settings, double milliseconds) {
    learn(costOf(settings).reclassifying, milliseconds / samplesOf(settings));
}

void PreviewQuality::couldNotKeep(const RayCastSettings& settings) {
    m_samplesNotKept = std::min(m_samplesNotKept, samplesOf(settings));
}

void PreviewQuality::drawn(double milliseconds) {
    // A longer drawing than a frame says nothing about the next one (a menu opened, the window was moved).
    if (++m_drawn > 1) learn(m_drawing, std::min(milliseconds, m_frame));
}

void PreviewQuality::lit(const RayCastSettings& settings, double milliseconds) {
    if (isLit(settings)) learn(m_light, std::min(milliseconds, m_frame));
}

double PreviewQuality::budgetFor(const RayCastSettings& asked) const {
    return std::max(budgetMilliseconds() - (isLit(asked) ? m_light : 0.0), smallestBudget * m_frame);
}

double PreviewQuality::budgetMilliseconds() const { return std::max(m_frame - m_drawing, smallestBudget * m_frame); }

std::size_t PreviewQuality::qualityInMotion(const RayCastSettings& asked) {
    m_samplesNotKept = std::numeric_limits<double>::infinity();  // another view has other samples
    if (samplingCost(asked) > 0.0)
        m_motionQuality = qualityWithin(budgetFor(asked), m_motionQuality, usual,
                                        [&](std::size_t quality) { return samplingTime(quality, asked); });
    return m_motionQuality;
}

std::size_t PreviewQuality::qualityAlone(const RayCastSettings& asked) {
    const std::size_t inMotion = qualityInMotion(asked), atRest = convergedQuality + 1;
    const double cost = samplingTime(atRest, asked);
    return cost > 0.0 && cost <= aloneFrames * m_frame ? std::min(inMotion, atRest) : inMotion;
}

std::size_t PreviewQuality::qualityForEdits(const RayCastSettings& asked, bool inSeries) {
    const bool lit = isLit(asked);
    const double budget = lit ? std::max(budgetFor(asked), smallestLitEdit * budgetMilliseconds()) : budgetFor(asked);
    if (samplingCost(asked) > 0.0)
        m_editQuality = qualityWithin(budget, m_editQuality, inSeries ? withinSeries : usual,
                                      [&](std::size_t quality) { return editCost(quality, asked); });
    return std::min(m_editQuality, m_motionQuality + (lit ? 1 : 0));
}

double PreviewQuality::samplingCost(const RayCastSettings& settings) const {
    if (settings.shading) return m_shaded.sampling > 0.0 ? m_shaded.sampling : shadedRatio * m_unshaded.sampling;
    return m_unshaded.sampling > 0.0 ? m_unshaded.sampling : m_shaded.sampling / shadedRatio;
}

double PreviewQuality::castShareOf(const RayCastSettings& settings) const {
    if (settings.pixelTolerance <= 0.0) return 1.0;
    // Of more pixels than were measured the share is smaller. Of fewer, as many must be cast.
    return std::min(1.0, m_castShare * std::max(1.0, m_castSharePixels / pixelsOf(settings)));
}

double PreviewQuality::samplingTime(std::size_t quality, const RayCastSettings& asked) const {
    const RayCastSettings settings = settingsAt(quality, asked);
    return samplingCost(asked) * samplesOf(settings) * castShareOf(settings);
}

double PreviewQuality::editCost(std::size_t quality, const RayCastSettings& asked) {
    const double samples = samplesOf(settingsAt(quality, asked));
    const double sampling = samplingCost(asked) * samples;
    if (samples >= m_samplesNotKept) return sampling;
    if (sampling > warmUpFrames * m_frame) return std::max(sampling, 2.0 * m_frame);
    const double reclassifying = costOf(asked).reclassifying;
    return reclassifying > 0.0 ? reclassifying * samples : reclassifyShare * sampling;
}

}  // namespace echolucent
