#include "processing/designers/gradients/kindlmann.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "processing/designers/designer_contract.h"
#include "processing/designers/gradients/boundary_position.h"
#include "processing/designers/gradients/histogram_volume.h"
#include "processing/parameters/parameter_rows.h"

namespace echolucent {

namespace {

constexpr int kindlmannGradientNodes = 64;

bool isHat(const KindlmannConfig& config) { return config.emphasis == BoundaryEmphasis::hat; }

constexpr std::string_view theirs = "Kindlmann and Durkin 1998, section 5";
constexpr std::string_view kindlmannPage = "docs/designers/kindlmann.md";

constexpr auto kindlmannDimensions = parameter_rows::choicesOf<KindlmannDimensions>(kindlmannDimensionsNames);
constexpr auto boundaryEmphases = parameter_rows::choicesOf<BoundaryEmphasis>(boundaryEmphasisNames);

/// The drawn function has no row, so it is checked here.
std::string problemOfDrawn(const KindlmannConfig& config) {
    const std::vector<EmphasisNode>& nodes = config.drawn;
    if (nodes.size() < 2 || nodes.size() > mostEmphasisNodes)
        return "the drawn emphasis must have 2 to " + std::to_string(mostEmphasisNodes) + " nodes";
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!inRange(nodes[i].position, {-8, 8})) return "the positions of the drawn emphasis must be -8 to 8";
        if (!inRange(nodes[i].opacity, {0, 1})) return "the opacities of the drawn emphasis must be 0 to 1";
        if (i > 0 && nodes[i].position < nodes[i - 1].position)
            return "the positions of the drawn emphasis must not descend";
    }
    return {};
}

const ParameterTable<KindlmannConfig>& kindlmannTable() {
    using namespace parameter_rows;
    using Config = KindlmannConfig;
    // The numbers of the hat do not apply to a drawn function.
    constexpr ParameterScope ofHat{"emphasis", "hat"};
    static const ParameterTable<Config> table{
        {
            choice<kindlmannDimensions, &Config::dimensions>(
                {"dimensions", "Dimensions",
                 "Whether opacity follows the intensity alone, or the intensity and the gradient magnitude", "",
                 theirs}),
            number<&Config::prefilter>(
                {"prefilter", "Prefilter",
                 "Standard deviation of the Gaussian under which derivatives are taken; 0 takes them "
                 "of the voxels themselves",
                 "units", kindlmannPage},
                {0, 8}, {.offered = ParameterRange{0, 4}}),
            number<&Config::smoothing>(
                {"smoothing", "Smoothing over the intensity",
                 "Standard deviation of the Gaussian that smooths the mean derivatives over the intensity",
                 "levels of 255", kindlmannPage},
                {0, 16}),
            number<&Config::threshold>(
                {"threshold", "Gradient threshold",
                 "Share of the largest mean gradient magnitude that is taken for the floor of speckle and noise",
                 "share", kindlmannPage},
                {0, 0.9}),
            choice<boundaryEmphases, &Config::emphasis>(
                {"emphasis", "Boundary emphasis",
                 "Whether the opacity over the position in a boundary is a hat or was drawn by hand", "", theirs}),
            number<&isHat, &Config::centre>(
                {"centre", "Centre of the hat",
                 "Position in the boundary where the opacity is largest; 0 is its middle, below 0 is its darker side",
                 "standard deviations", theirs},
                {-4, 4}, {.scope = ofHat}),
            number<&isHat, &Config::halfWidth>({"half_width", "Half-width of the hat",
                                                "How far from its centre the hat ends", "standard deviations", theirs},
                                               {0.05, 8}, {.offered = ParameterRange{0.05, 4}, .scope = ofHat}),
            number<&isHat, &Config::peak>({"peak", "Peak of the hat", "Largest opacity of the hat", "per unit", theirs},
                                          {0, 1}, {.scope = ofHat}),
        },
        {},
        problemOfDrawn};
    return table;
}

double drawnAt(const std::vector<EmphasisNode>& nodes, double position) {
    const auto behind = std::ranges::upper_bound(nodes, position, {}, &EmphasisNode::position);
    if (behind == nodes.begin()) return nodes.front().opacity;
    const EmphasisNode& before = *(behind - 1);
    if (behind == nodes.end()) return before.opacity;
    const double share = (position - before.position) / (behind->position - before.position);
    return std::lerp(before.opacity, behind->opacity, share);
}

/// A number with three significant digits.
std::string threeDigitsInWords(double number) {
    if (number == 0.0) return "0";
    const double scale = std::pow(10.0, 2 - static_cast<int>(std::floor(std::log10(std::abs(number)))));
    return textOf(std::round(number * scale) / scale);
}

std::string level(double intensity) { return textOf(std::round(255.0 * intensity)); }

/// Intensities at which the position passes 0, from the darker to the brighter side.
std::vector<double> middles(const std::vector<double>& positions) {
    std::vector<double> found;
    for (std::size_t i = 1; i < positions.size(); ++i) {
        const double before = positions[i - 1], here = positions[i];
        // Comparisons with NaN are false.
        if (!(before < 0.0 && here >= 0.0)) continue;
        const double share = -before / (here - before);
        found.push_back((static_cast<double>(i) - 1.0 + share) / (static_cast<double>(positions.size()) - 1.0));
    }
    return found;
}

struct Findings {
    HistogramVolume histogram;
    MeanDerivatives means;
    std::optional<BoundaryWidth> width;
    std::vector<double> positions;  ///< over the intensity; empty without a width
};

std::string counted(double number, std::string_view thing) {
    return threeDigitsInWords(number) + " " + std::string(thing) + (number == 1.0 ? "" : "s");
}

std::string sentenceOfWidth(const BoundaryWidth& width) {
    std::string text = "The largest mean gradient is " + threeDigitsInWords(width.largestGradient) +
                       " per unit, mean second derivatives lie between " + threeDigitsInWords(width.leastSecond) +
                       " and " + threeDigitsInWords(width.largestSecond) + " per square unit: ";
    const std::string prefilter = "the prefilter of " + counted(width.prefilter, "unit");
    if (width.sigma == 0.0) return text + "what they belong to is sharper than " + prefilter + " can tell.";
    text += "boundaries are blurred by a standard deviation of " + counted(width.sigma, "unit");
    if (width.prefilter > 0.0) text += ", without that of " + prefilter;
    return text + ".";
}

std::string sentenceOfMiddles(const std::vector<double>& positions) {
    const std::vector<double> found = middles(positions);
    constexpr std::size_t most = 4;
    if (found.empty()) return "No intensity lies in the middle of a boundary alone.";
    std::string text = "The middle of boundaries lies at intensity ";
    for (std::size_t i = 0; i < std::min(found.size(), most); ++i) text += (i > 0 ? ", " : "") + level(found[i]);
    if (found.size() > most) text += " and " + std::to_string(found.size() - most) + " more";
    return text + " of 255.";
}

std::string sentenceOfEmphasis(const KindlmannConfig& config) {
    if (config.emphasis == BoundaryEmphasis::drawn)
        return "Opacity follows the position in the boundary as it was drawn, over " +
               std::to_string(config.drawn.size()) + " nodes.";
    const std::string place = config.centre == 0.0
                                  ? "in the middle of a boundary"
                                  : counted(std::abs(config.centre), "standard deviation") + " to the " +
                                        (config.centre < 0.0 ? "darker" : "brighter") + " side of a boundary's middle";
    return "Opacity is " + threeDigitsInWords(config.peak) + " " + place + " and falls to 0 within " +
           counted(config.halfWidth, "standard deviation") + " to both sides.";
}

std::vector<DesignFact> kindlmannFacts(const Findings& findings) {
    const double data = static_cast<double>(findings.histogram.dataVoxels);
    std::vector<DesignFact> facts;
    if (findings.width) {
        const BoundaryWidth& width = *findings.width;
        facts = {{"sigma", "Blur of the boundaries", width.sigma, "units"},
                 {"smoothed_sigma", "Blur under the prefilter", width.smoothed, "units"},
                 {"largest_mean_gradient", "Largest mean gradient", width.largestGradient, "per unit"},
                 {"largest_second", "Largest mean second derivative", width.largestSecond, "per square unit"},
                 {"least_second", "Least mean second derivative", width.leastSecond, "per square unit"}};
    }
    const double used = static_cast<double>(findings.histogram.usedVoxels);
    facts.push_back({"voxels_used", "Voxels that count", data > 0.0 ? used / data : 0.0, "share"});
    return facts;
}

std::vector<DesignPlot> kindlmannPlots(const Findings& findings) {
    std::vector<double> intensities;
    intensities.reserve(HistogramVolume::intensityNodes);
    for (int i = 0; i < HistogramVolume::intensityNodes; ++i)
        intensities.push_back(static_cast<double>(i) / (HistogramVolume::intensityNodes - 1));
    std::vector<DesignPlot> plots{
        {"mean_gradient", "Mean gradient g(v)", "per unit", intensities, findings.means.gradient},
        {"mean_second", "Mean second derivative h(v)", "per square unit", intensities, findings.means.second}};
    if (findings.width)
        plots.push_back({"position", "Position p(v)", "standard deviations", intensities, findings.positions});
    return plots;
}

double opacityOf(const KindlmannConfig& config, double position) {
    return std::isnan(position) ? 0.0 : std::clamp(emphasisAt(config, position), 0.0, 1.0);
}

Classification classified(const KindlmannConfig& config, const Findings& findings) {
    if (config.dimensions == KindlmannDimensions::one) {
        std::vector<double> opacities(findings.positions.size());
        std::ranges::transform(findings.positions, opacities.begin(),
                               [&](double position) { return opacityOf(config, position); });
        return SampledCurve{std::move(opacities)};
    }
    TwoDimensionalOtf otf{
        HistogramVolume::intensityNodes, kindlmannGradientNodes, findings.histogram.largestGradient, {}};
    for (const double position : boundaryPositions(findings.histogram, *findings.width, config.threshold))
        otf.opacities.push_back(static_cast<float>(opacityOf(config, position)));
    return Classification(std::move(otf));
}

bool showsSomething(const Classification& classification) {
    const auto above = [](auto opacity) { return opacity > 0; };
    if (classification.isTwoDimensional())
        return std::ranges::any_of(classification.twoDimensional()->opacities, above);
    return std::ranges::any_of(std::get<SampledCurve>(classification.curve()).opacities, above);
}

/// The widest sigma of a boundary, units: most of its transition, four sigma, must fit into the longest edge.
double widestSigma(const VolumeGeometry& geometry) {
    double longest = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        longest = std::max(longest,
                           geometry.spacing[axis] * static_cast<double>(geometry.size[static_cast<std::size_t>(axis)]));
    return 0.25 * longest / geometry.unit();
}

}  // namespace

const ParameterTable<KindlmannConfig>& parametersOf(const KindlmannConfig&) { return kindlmannTable(); }

double emphasisAt(const KindlmannConfig& config, double position) {
    if (config.emphasis == BoundaryEmphasis::drawn) return drawnAt(config.drawn, position);
    return config.peak * std::max(0.0, 1.0 - std::abs(position - config.centre) / config.halfWidth);
}

std::optional<Design> design(const KindlmannConfig& config, const DesignerInput& input, const Progress& progress) {
    requireDesignable("KindlmannConfig", parametersOf(config), config, input);
    const bool flat = config.dimensions == KindlmannDimensions::one;
    std::optional<HistogramVolume> histogram =
        histogramVolume(input.shown, {config.prefilter, flat ? 0 : kindlmannGradientNodes}, progress);
    if (!histogram) return std::nullopt;
    Findings findings{std::move(*histogram), {}, {}, {}};
    findings.means = meanDerivatives(findings.histogram, config.smoothing);
    findings.width = boundaryWidth(findings.means, config.prefilter, widestSigma(input.shown.geometry()));
    if (findings.width) findings.positions = boundaryPositions(findings.means, *findings.width, config.threshold);

    Design result{PowerCurve{}, {}, kindlmannFacts(findings), kindlmannPlots(findings), {}};
    if (!findings.width) {
        result.message = "No boundary was found in this volume; the parabola x² is shown in its place.";
        return result;
    }
    const BoundaryWidth& width = *findings.width;
    result.explanation = {sentenceOfWidth(width)};
    Classification found = classified(config, findings);
    if (width.isSharperThanBoundaries()) {
        result.message =
            "What was found is no boundary but speckle or thin layers: with " + counted(width.smoothed, "unit") +
            " it is sharper than a boundary can be under the prefilter of " + counted(width.prefilter, "unit") +
            "; the parabola x² is shown in its place, and another prefilter may find boundaries.";
    } else if (!showsSomething(found)) {
        result.message =
            "Nothing of the boundaries that were found is emphasised; the parabola x² is shown in their place.";
    } else {
        result.classification = std::move(found);
    }
    result.explanation.push_back(sentenceOfMiddles(findings.positions));
    if (result.message.empty()) result.explanation.push_back(sentenceOfEmphasis(config));
    return result;
}

}  // namespace echolucent
