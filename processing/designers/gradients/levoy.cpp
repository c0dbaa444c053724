#include "processing/designers/gradients/levoy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "processing/adaptive/adapted_curve.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/designers/designer_contract.h"
#include "processing/designers/otsu.h"
#include "processing/intensity/intensity_counts.h"
#include "processing/parameters/parameter_rows.h"
#include "processing/sampling/gradient_magnitude.h"
#include "processing/volume/filled_volume.h"

namespace echolucent {

namespace {

constexpr auto levoyForms = parameter_rows::choicesOf<LevoyForm, 2>({"isovalues", "boundaries"});
constexpr auto levoyLevels = parameter_rows::choicesOf<LevoyLevels, 3>({"tube_cores", "otsu", "given"});
constexpr auto levoyGradientScales = parameter_rows::choicesOf<LevoyGradientScale, 2>({"largest", "quantile"});

constexpr int levoyIntensityNodes = 1021;  // three between each two bytes, so that bytes lie on nodes
constexpr int levoyGradientNodes = 256;

constexpr std::string_view levoyPage = "docs/designers/levoy.md";

bool levelsAreGiven(const LevoyConfig& config) { return config.levels == LevoyLevels::given; }
bool hasContours(const LevoyConfig& config) { return config.form == LevoyForm::isovalues; }
bool hasBoundaries(const LevoyConfig& config) { return config.form == LevoyForm::boundaries; }

const ParameterTable<LevoyConfig>& levoyTable() {
    using namespace parameter_rows;
    constexpr ParameterScope given{"levels", "given"}, isovalues{"form", "isovalues"}, boundaries{"form", "boundaries"};
    static const ParameterTable<LevoyConfig> table{{
        choice<levoyForms, &LevoyConfig::form>(
            {"form", "Form", "Contours of values, as thick everywhere, or boundaries, as opaque as they are steep", "",
             "Levoy 1988"}),
        choice<levoyLevels, &LevoyConfig::levels>(
            {"levels", "Levels", "What gives the levels of fluid and tissue", "", levoyPage}),
        number<&levelsAreGiven, &LevoyConfig::fluidLevel>(
            {"fluid_level", "Fluid level", "Intensity of fluid, as a share of white", "share", "chosen by looking"},
            {0, 1}, {.scope = given}),
        number<&levelsAreGiven, &LevoyConfig::tissueLevel>(
            {"tissue_level", "Tissue level", "Intensity of tissue, as a share of white", "share", "chosen by looking"},
            {0, 1}, {.scope = given}),
        number<&LevoyConfig::fluidOpacity>(
            {"fluid_opacity", "Fluid opacity", "Opacity of the fluid level", "", levoyPage}, {0, 1}),
        number<&LevoyConfig::tissueOpacity>(
            {"tissue_opacity", "Tissue opacity", "Opacity of the tissue level", "", levoyPage}, {0, 1}),
        number<&hasContours, &LevoyConfig::surfaceOpacity>(
            {"surface_opacity", "Surface opacity", "Opacity of the contour between fluid and tissue", "", levoyPage},
            {0, 1}, {.scope = isovalues}),
        number<&hasContours, &LevoyConfig::surfaceShare>(
            {"surface_share", "Place of the surface",
             "How far the value of the surface's contour lies from the fluid level to the tissue level", "share",
             levoyPage},
            {0, 1}, {.scope = isovalues}),
        number<&hasContours, &LevoyConfig::transitionWidth>(
            {"transition_width", "Transition width r", "Half the thickness of a contour", "units", levoyPage},
            {0.1, 100}, {.offered = ParameterRange{0.5, 10}, .scope = isovalues}),
        choice<levoyGradientScales, &hasBoundaries, &LevoyConfig::gradientScale>(
            {"gradient_scale", "Gradient scale", "Which gradient counts as the steepest: larger ones count as it", "",
             levoyPage},
            {.scope = boundaries}),
    }};
    return table;
}

/// The levels, where they come from, and what could not be done. Without levels both are 0.
struct Levels {
    double fluid = 0.0, tissue = 0.0;
    std::string origin{}, message{};
    std::vector<DesignFact> facts{};
    [[nodiscard]] bool found() const { return fluid != tissue; }
};

Levels otsuLevels(const Volume& shown) {
    const auto classes = otsuClasses(intensityCounts(shown));
    if (!classes) return {};
    return {
        classes->dark.mean, classes->bright.mean,
        "They are the means of the voxels below and above Otsu's threshold at " + inWords(classes->threshold) + "."};
}

/// Empty if the work was cancelled.
std::optional<Levels> tubeCoreLevels(const DesignerInput& input, const Progress& progress) {
    // Only the surfaces are read, so no curve is made for the shown voxels.
    AdaptiveOtfConfig method = input.method;
    method.curve = withoutEveryWall(method.curve);
    const auto otf = adaptOpacity(input.raw, input.view, method, progress);
    if (!otf) return std::nullopt;
    const MeanInterface mean = meanInterfaceOf(*otf);
    // No fluid lies before surfaces at which the data begin.
    if (otf->surfacesWhereDataBegin || !(mean.high > mean.low)) return Levels{};
    return Levels{mean.low,
                  mean.high,
                  "They are the means before and at the surfaces that " + std::to_string(otf->tubesWithWeight) +
                      " of " + std::to_string(otf->tubesMeetingVolume) + " tube cores found.",
                  {},
                  {{"surfaces_with_weight", "Surfaces with a weight", static_cast<double>(otf->tubesWithWeight)}}};
}

/// Empty if the work was cancelled.
std::optional<Levels> levelsOf(const LevoyConfig& config, const DesignerInput& input, const Progress& progress) {
    std::string message;
    switch (config.levels) {
        case LevoyLevels::given:
            if (config.fluidLevel != config.tissueLevel)
                return Levels{config.fluidLevel, config.tissueLevel, "They were given."};
            message = "The levels given for fluid and tissue are one: Otsu's levels are used.";
            break;
        case LevoyLevels::tubeCores: {
            auto levels = tubeCoreLevels(input, progress);
            if (!levels || levels->found()) return levels;
            message = "No tube core found a surface behind fluid: Otsu's levels are used.";
            break;
        }
        case LevoyLevels::otsu: break;
    }
    Levels levels = otsuLevels(input.shown);
    if (levels.found()) levels.message = std::move(message);
    return levels;
}

double atNode(double intensity) {
    return std::round(intensity * (levoyIntensityNodes - 1)) / (levoyIntensityNodes - 1);
}

/// The contours of a volume's levels without the clear ones.
std::vector<LevoyLevel> contoursOf(const LevoyConfig& config, const Levels& levels) {
    std::vector<LevoyLevel> contours{
        {atNode(levels.fluid), config.fluidOpacity},
        {atNode(levels.fluid + config.surfaceShare * (levels.tissue - levels.fluid)), config.surfaceOpacity},
        {atNode(levels.tissue), config.tissueOpacity}};
    std::erase_if(contours, [](const LevoyLevel& level) { return level.opacity == 0.0; });
    return contours;
}

TwoDimensionalOtf isovalueTable(const std::vector<LevoyLevel>& contours, double width, double largestGradient) {
    return tabulated(levoyIntensityNodes, levoyGradientNodes, largestGradient, [&](double intensity, double gradient) {
        double clear = 1.0;
        for (const LevoyLevel& level : contours) clear *= 1.0 - isovalueOpacity(intensity, gradient, level, width);
        return 1.0 - clear;
    });
}

/// Along the gradient the opacity is a straight line up to the gradient that counts as 1, and constant beyond.
TwoDimensionalOtf boundaryTable(std::span<const LevoyLevel> levels, double gradientScale) {
    return tabulated(levoyIntensityNodes, 2, gradientScale, [&](double intensity, double gradient) {
        return boundaryOpacity(intensity, gradient / gradientScale, levels);
    });
}

void explainIsovalues(const LevoyConfig& config, const std::vector<LevoyLevel>& contours, Design& design) {
    for (const LevoyLevel& level : contours)
        design.explanation.push_back("The contour of " + inWords(level.intensity) + " has the opacity " +
                                     inWords(level.opacity) + " on it and reaches " + inWords(config.transitionWidth) +
                                     " units to either side, wherever the gradient says how far it is.");
    design.facts.push_back({"transition_width", "Transition width", config.transitionWidth, "units"});
}

void explainBoundaries(const LevoyConfig& config, double scale, bool byLargest, Design& design) {
    design.explanation.push_back(
        "Opacity grows with the gradient: it is " + inWords(config.fluidOpacity) + " at the fluid level and " +
        inWords(config.tissueOpacity) + " at the tissue level where intensity changes by " + inWords(scale) +
        " per unit or more, " +
        (byLargest ? "the largest gradient of the voxels." : "which 99 % of the voxels do not exceed."));
    design.facts.push_back({"gradient_scale", "Gradient that counts as the steepest", scale, "per unit"});
}

Design parabola(const Volume& shown) {
    Design design{PowerCurve{2, 1.0}};
    design.message = intensityCounts(shown).total == 0 ? "No voxel carries data: x^2 is used."
                                                       : "All voxels with data have one intensity, so that there is "
                                                         "no boundary: x^2 is used.";
    return design;
}

}  // namespace

double isovalueOpacity(double intensity, double gradient, const LevoyLevel& level, double width) {
    const double apart = std::abs(level.intensity - intensity), reach = width * gradient;
    if (apart == 0.0) return level.opacity;
    return apart < reach ? level.opacity * (1.0 - apart / reach) : 0.0;
}

double boundaryOpacity(double intensity, double scaledGradient, std::span<const LevoyLevel> levels) {
    const double steepness = std::clamp(scaledGradient, 0.0, 1.0);
    if (intensity <= levels.front().intensity) return steepness * levels.front().opacity;
    for (std::size_t n = 0; n + 1 < levels.size(); ++n) {
        const LevoyLevel &one = levels[n], &next = levels[n + 1];
        if (intensity <= next.intensity)
            return steepness *
                   (next.opacity * (intensity - one.intensity) + one.opacity * (next.intensity - intensity)) /
                   (next.intensity - one.intensity);
    }
    return steepness * levels.back().opacity;
}

const ParameterTable<LevoyConfig>& parametersOf(const LevoyConfig&) { return levoyTable(); }

std::optional<Design> design(const LevoyConfig& config, const DesignerInput& input, const Progress& progress) {
    requireDesignable("LevoyConfig", parametersOf(config), config, input);
    const auto levels = levelsOf(config, input, partOf(progress, 0.0, 0.8));
    if (!levels || progress.cancelled()) return std::nullopt;
    const auto range = gradientRange(input.shown, filledVoxels(input.shown), partOf(progress, 0.8, 0.95));
    if (!range) return std::nullopt;
    if (!levels->found() || !(range->largest > 0.0)) return parabola(input.shown);

    Design design{PowerCurve{2, 1.0}};
    design.message = levels->message;
    design.explanation = {"The fluid level is " + inWords(levels->fluid) + ", the tissue level " +
                          inWords(levels->tissue) + ". " + levels->origin};
    design.facts = {{"fluid_level", "Fluid level", levels->fluid}, {"tissue_level", "Tissue level", levels->tissue}};
    std::ranges::copy(levels->facts, std::back_inserter(design.facts));
    if (config.form == LevoyForm::isovalues) {
        const auto contours = contoursOf(config, *levels);
        design.classification = Classification(isovalueTable(contours, config.transitionWidth, range->largest));
        explainIsovalues(config, contours, design);
    } else {
        // If fewer than one voxel in a hundred has a gradient, the quantile is 0 within its accuracy.
        constexpr double none = 3e-5;
        const bool byLargest = config.gradientScale == LevoyGradientScale::largest || !(range->quantile99 > none);
        const double scale = byLargest ? range->largest : range->quantile99;
        std::array<LevoyLevel, 2> ascending{LevoyLevel{levels->fluid, config.fluidOpacity},
                                            LevoyLevel{levels->tissue, config.tissueOpacity}};
        if (ascending[0].intensity > ascending[1].intensity) std::swap(ascending[0], ascending[1]);
        design.classification = Classification(boundaryTable(ascending, scale));
        explainBoundaries(config, scale, byLargest, design);
    }
    design.facts.push_back({"largest_gradient", "Largest gradient", range->largest, "per unit"});
    design.facts.push_back({"gradient_quantile", "Gradient that 99 % do not exceed", range->quantile99, "per unit"});
    progress.at(1.0);
    return design;
}

}  // namespace echolucent
