#include "processing/beam/beam_guess.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "processing/beam/coarse_echo.h"
#include "processing/beam/echo_along_axes.h"
#include "processing/beam/probe_view.h"
#include "processing/beam/sector_shape.h"
#include "processing/choice_names.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<4> evidenceNames{"none", "sector shape", "echo", "file"};

// The thresholds lie between the figures of scans with a known beam and those of scans without any trace of it;
// docs/beam.md has both.
constexpr double sureConfidence = 0.4;
constexpr double leastTissueFall = 0.3;   ///< natural logarithm over the whole extent
constexpr double leastTypicalFall = 1.5;  ///< likewise
constexpr double leastShadow = 0.06;      ///< difference of the correlations behind and before
constexpr double leastShadowSteadiness = 0.5;

/// Evidence for an axis.
struct Lead {
    BeamAxis axis = BeamAxis::plusZ;
    double confidence = 0.0;
    bool sure = false;
    const char* reason = "";
};

BeamAxis axisOf(int gridAxis, bool positive) { return static_cast<BeamAxis>(2 * gridAxis + (positive ? 0 : 1)); }

Lead leadOfShape(const CoarseEcho& coarse) {
    const std::array<double, 6> scores = sectorScores(coarse);
    const auto best = std::max_element(scores.begin(), scores.end());
    double second = 0.0;
    for (auto score = scores.begin(); score != scores.end(); ++score)
        if (score != best) second = std::max(second, *score);
    const double confidence = *best - second;
    return {static_cast<BeamAxis>(best - scores.begin()), confidence, confidence >= sureConfidence,
            "the scanned sector widens along it"};
}

/// A fall along each grid axis, and the share of the slices in which the echo falls.
struct Falls {
    std::array<double, 3> fall{}, share{};

    [[nodiscard]] std::size_t largest() const {
        const auto found =
            std::max_element(fall.begin(), fall.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
        return static_cast<std::size_t>(found - fall.begin());
    }
    /// How much the slices agree, [0,1]; below 0 if most of them contradict the fall.
    [[nodiscard]] double steadiness(std::size_t axis) const {
        return (fall[axis] > 0.0 ? 2.0 : -2.0) * (share[axis] - 0.5);
    }
};

/// A fall counts by its steadiness and by how far it exceeds those along the other axes.
Lead leadOfFalls(const Falls& falls, double least, const char* reason) {
    const std::size_t axis = falls.largest();
    const double own = std::abs(falls.fall[axis]);
    if (!(own > 0.0)) return {};
    double next = 0.0;
    for (std::size_t other = 0; other < 3; ++other)
        if (other != axis) next = std::max(next, std::abs(falls.fall[other]));
    const double confidence = std::max(0.0, falls.steadiness(axis)) * (1.0 - next / own);
    return {axisOf(static_cast<int>(axis), falls.fall[axis] > 0.0), confidence * std::min(1.0, own / least),
            own >= least && confidence >= sureConfidence, reason};
}

/// Shadows count only if the echo of one tissue falls the same way: either alone can be anatomy.
Lead leadOfShadows(const CoarseEcho& coarse, const Falls& tissue) {
    const std::size_t axis = tissue.largest();
    const double steadiness = tissue.steadiness(axis);
    if (!(steadiness >= leastShadowSteadiness)) return {};
    const bool positive = tissue.fall[axis] > 0.0;
    const ShadowCorrelation found = shadowsAlong(coarse, static_cast<int>(axis));
    const double passed = positive ? found.withBefore : found.withBehind;
    const double ahead = positive ? found.withBehind : found.withBefore;
    if (passed >= 0.0 || ahead - passed < leastShadow) return {};
    return {axisOf(static_cast<int>(axis), positive), steadiness, true, "shadows lie along it behind bright places"};
}

Lead leadOfEcho(const CoarseEcho& coarse) {
    const std::array<EchoAlongAxis, 3> axes = echoAlongAxes(coarse);
    Falls tissue, typical;
    for (std::size_t i = 0; i < 3; ++i) {
        tissue.fall[i] = axes[i].tissueFall;
        tissue.share[i] = axes[i].tissueShare;
        typical.fall[i] = axes[i].typicalFall;
        typical.share[i] = axes[i].typicalShare;
    }
    const Lead ofTypical = leadOfFalls(typical, leastTypicalFall, "the echo falls far along it");
    if (ofTypical.sure) return ofTypical;
    const Lead ofTissue = leadOfFalls(tissue, leastTissueFall, "the echo of one tissue falls steadily along it");
    if (ofTissue.sure) return ofTissue;
    const Lead ofShadows = leadOfShadows(coarse, tissue);
    if (ofShadows.sure) return ofShadows;
    return ofTissue.confidence > ofTypical.confidence ? ofTissue : ofTypical;
}

BeamGuess sureGuess(const Lead& lead, BeamEvidence evidence) {
    return {lead.axis, evidence, std::min(1.0, lead.confidence), true,
            "The beam axis is taken as " + std::string(nameOf(lead.axis)) + ": " + lead.reason + "."};
}

}  // namespace

std::string_view nameOf(BeamEvidence evidence) { return nameIn(evidenceNames, evidence); }

std::optional<BeamGuess> guessBeamAxis(const Volume& volume, const Progress& progress) {
    if (const auto& probe = volume.geometry().probe)
        return sureGuess({viewFromProbe(*probe).beamAxis, 1.0, true, "the file says where the probe was"},
                         BeamEvidence::file);
    const auto coarse = coarseEchoOf(volume, progress);
    if (!coarse) return std::nullopt;
    const Lead shape = leadOfShape(*coarse);
    if (shape.sure) return sureGuess(shape, BeamEvidence::sectorShape);
    if (progress.cancelled()) return std::nullopt;
    const Lead echo = leadOfEcho(*coarse);
    if (progress.cancelled()) return std::nullopt;
    if (echo.sure) return sureGuess(echo, BeamEvidence::echo);
    BeamGuess unsure;
    unsure.confidence = std::min(sureConfidence, std::max(shape.confidence, echo.confidence));
    unsure.sentence =
        "Where the probe was cannot be told from the shape of the data or from the echo: the beam axis stays +z.";
    return unsure;
}

}  // namespace echolucent
