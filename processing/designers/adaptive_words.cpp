#include "processing/designers/adaptive_words.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "processing/adaptive/method_reading.h"
#include "processing/adaptive/quiet_reading.h"
#include "processing/parameters/parameter.h"
#include "processing/tube_core/ramp.h"
#include "processing/tube_core/tube_core.h"

namespace echolucent {

namespace {

/// With at most two decimals.
std::string hundredthsInWords(double value) { return textOf(std::round(value * 100.0) / 100.0); }
std::string wholePercentInWords(double share) { return textOf(std::round(share * 100.0)) + " %"; }

std::string productSentence(const AdaptiveOtf& otf, const ProductRule& product) {
    return "The curve is the initial function times one basis function for each tube core, with a strength of " +
           hundredthsInWords(product.strength) + ", of which " + hundredthsInWords(sumOfD(otf)) + " is used.";
}

std::string rampSentence(const AdaptiveOtf& otf, const RampRule& ramp) {
    TubeCore unit;
    unit.lowIntensity = 0.0;
    unit.highIntensity = 1.0;
    std::string text =
        "The curve is the mean of one ramp for each tube core. A ramp begins at " + hundredthsInWords(ramp.begin) +
        " of the way from the intensity before its surface to that at it, or later if its fluid's speckle reaches "
        "farther, and is full at " +
        hundredthsInWords(std::max(ramp.end, ramp.begin + leastRampWidth)) + " of the way";
    const double atSurface = rampAt(1.0, unit, ramp);
    text +=
        atSurface < 1.0 ? ": at its own surface it has risen to " + wholePercentInWords(atSurface) + " at most." : ".";
    if (ramp.opacity < 1.0) text += " Full is an opacity of " + hundredthsInWords(ramp.opacity) + " per unit.";
    if (otf.everyWall)
        text += " An aim of " + hundredthsInWords(ramp.aim) + " mixes " + wholePercentInWords(1.0 - ramp.aim) +
                " of this mean with " + wholePercentInWords(ramp.aim) +
                " of the ramp that shows every surface found at its place: clear up to " +
                hundredthsInWords(otf.everyWall->begin) + ", with an opacity of " +
                hundredthsInWords(ramp.opacity * otf.everyWall->opacity) + " per unit from " +
                hundredthsInWords(otf.everyWall->end) + " on.";
    if (otf.trust < 1.0)
        text += " As few tube cores found a surface, " + wholePercentInWords(1.0 - otf.trust) +
                " of the curve is the initial function.";
    return text;
}

}  // namespace

bool tubeCoresMadeTheCurve(const AdaptiveOtf& otf) { return otf.tubesWithWeight > 0 && !otf.surfacesWhereDataBegin; }

std::string surfaceSentence(const AdaptiveOtf& otf) {
    const MeanInterface mean = meanInterfaceOf(otf);
    std::string text = std::to_string(surfacesFound(otf)) + " of " + std::to_string(otf.tubesMeetingVolume) +
                       " tube cores (columns of voxels along the view) found a surface behind darker tissue or "
                       "fluid, and " +
                       std::to_string(otf.tubesWithWeight) +
                       " of these have a weight. In front of it the intensity is about " + hundredthsInWords(mean.low);
    if (std::holds_alternative<ProductRule>(otf.config.curve))
        return text + " and becomes clearer, at it about " + hundredthsInWords(mean.high) + " and becomes more opaque.";
    const auto opacity = [&](double intensity) { return hundredthsInWords(opacityAt(otf.curve, intensity)); };
    return text + ", to which the curve gives an opacity of " + opacity(mean.low) + ", at it about " +
           hundredthsInWords(mean.high) + ", to which it gives " + opacity(mean.high) + ".";
}

std::string detectionSentence(const AdaptiveOtfConfig& config) {
    const auto* variance = std::get_if<VarianceRule>(&config.detection);
    if (variance == nullptr)
        return "Surfaces are looked for where it is much brighter behind than before, by the ratio of means.";
    return "A surface is the first significant local maximum of the variance of intensities along its tube core, "
           "tracked from coarse to fine scales." +
           (variance->significance > 0.0
                ? " Significant is a maximum of at least " + wholePercentInWords(variance->significance) +
                      " of the largest variance in its range."
                : std::string(" A maximum of any height counts as significant."));
}

std::string curveSentence(const AdaptiveOtf& otf) {
    const CurveRule used = quieterRule(otf.config.curve, otf.speckleLeft.value_or(1.0));
    if (const auto* product = std::get_if<ProductRule>(&used)) return productSentence(otf, *product);
    return rampSentence(otf, std::get<RampRule>(used));
}

std::string voxelsSentence(const AdaptiveOtf& otf) {
    if (otf.reduction == SpeckleReduction::off) return {};
    std::string text = "The tube cores look for surfaces in the voxels as they were measured.";
    if (otf.quiet.empty()) return text;
    text += " The intensities of which the curve is made are read at these surfaces in the quiet voxels";
    if (otf.speckleLeft)
        text += ", in which " + wholePercentInWords(*otf.speckleLeft) + " of the fluid's speckle is left";
    return text + ".";
}

std::string readingSentence(const AdaptiveOtf& otf) {
    const auto reading = readingOf(otf.config);
    if (!reading) return "Parameters of the method were changed.";
    switch (*reading) {
        case MethodReading::asPublished: {
            std::string text =
                "The method is read as it was published, with eq. 5 mended, which as printed cannot have the extremes "
                "that the paper states, and with a d_max of 0.03 at 225 tube cores, as the paper gives none.";
            if (!otf.quiet.empty())
                text +=
                    " The paper knows no reduction of speckle: its curve is made of the voxels as they were measured.";
            return text;
        }
        case MethodReading::settled: return "The open points of the published method are settled by experiment.";
        case MethodReading::firstVersion:
            return "The method runs with the default parameters of version 0.1 of this program.";
        case MethodReading::standard: return "The method runs with this program's default parameters.";
    }
    return {};
}

}  // namespace echolucent
