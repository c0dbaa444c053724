#include "processing/designers/gradients/contour_spectrum.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "processing/designers/designer_contract.h"
#include "processing/designers/gradients/isovalue_spectrum.h"
#include "processing/parameters/parameter_rows.h"

namespace echolucent {

namespace {

constexpr std::string_view contourSpectrumPage = "docs/designers/contour-spectrum.md";

/// The threshold has no meaning unless a person chooses it.
bool thresholdIsGiven(const ContourSpectrumConfig& config) { return config.choice == IsovalueChoice::given; }

constexpr auto isovalueChoices = parameter_rows::choicesOf<IsovalueChoice>(isovalueChoiceNames);

const ParameterTable<ContourSpectrumConfig>& contourSpectrumTable() {
    using namespace parameter_rows;
    using Config = ContourSpectrumConfig;
    static const ParameterTable<Config> table{{
        choice<isovalueChoices, &Config::choice>(
            {"isovalue", "Isovalue",
             "Where the ramp stands: where the isosurfaces are steepest, or at a given threshold", "",
             "Bajaj, Pascucci, Schikore 1997"}),
        number<&thresholdIsGiven, &Config::threshold>(
            {"threshold", "Threshold", "Intensity of the middle of the ramp", "", contourSpectrumPage}, {0, 1},
            {.scope = {"isovalue", "given"}}),
        number<&Config::leastArea>(
            {"least_area", "Least area",
             "Isosurfaces that are smaller than this share of the largest one are not asked, because they are noise",
             "share", contourSpectrumPage},
            {0, 1}),
        number<&Config::halfWidth>({"half_width", "Half-width", "How far the ramp reaches to both sides of its middle",
                                    "", contourSpectrumPage},
                                   {0, 1}, {.offered = ParameterRange{0, 0.5}}),
        number<&Config::opacity>(
            {"opacity", "Opacity", "Opacity of what is brighter than the ramp", "", contourSpectrumPage}, {0, 1}),
    }};
    return table;
}

/// The part of the ramp within [0,1].
ManualCurve rampAt(double threshold, const ContourSpectrumConfig& config) {
    const double begin = threshold - config.halfWidth, end = threshold + config.halfWidth;
    const auto at = [&](double intensity) { return config.opacity * (intensity - begin) / (end - begin); };
    ManualCurve ramp;
    ramp.nodes.push_back(begin < 0.0 ? CurveNode{0.0, at(0.0)} : CurveNode{begin, 0.0});
    ramp.nodes.push_back(end > 1.0 ? CurveNode{1.0, at(1.0)} : CurveNode{end, config.opacity});
    return ramp;
}

/// Area and volume as a person reads them.
struct Lengths {
    double perUnit;  ///< mm; 1 if the spacing is a guess
    std::string area, volume, length;

    explicit Lengths(const VolumeGeometry& geometry)
        : perUnit(geometry.spacingKnown ? geometry.unit() : 1.0),
          area(geometry.spacingKnown ? "mm²" : "units²"),
          volume(geometry.spacingKnown ? "mm³" : "units³"),
          length(geometry.spacingKnown ? "mm" : "units") {}
};

std::vector<double> times(std::vector<double> values, double factor) {
    for (double& value : values) value *= factor;
    return values;
}

std::vector<DesignPlot> spectrumPlots(const ContourSpectrum& spectrum, const Lengths& lengths) {
    std::vector<double> isovalues(ContourSpectrum::count);
    for (std::size_t i = 0; i < isovalues.size(); ++i) isovalues[i] = ContourSpectrum::isovalue(i);
    const double unit = lengths.perUnit;
    return {{"area", "Area A(w)", lengths.area, isovalues, times(spectrum.area, unit * unit)},
            {"volume", "Volume above V(w)", lengths.volume, isovalues, times(spectrum.volume, unit * unit * unit)},
            {"gradient_integral", "Gradient integral G(w)", lengths.length, isovalues,
             times(spectrum.gradientIntegral, unit)},
            {"mean_gradient", "Mean gradient G/A", "per unit", isovalues, spectrum.meanGradient()}};
}

void addFacts(const ContourSpectrum& spectrum, double threshold, const std::vector<SpectrumMaximum>& maxima,
              const Lengths& lengths, Design& design) {
    const auto at = static_cast<std::size_t>(std::lround(threshold * (ContourSpectrum::count - 1)));
    const double unit = lengths.perUnit;
    const double area = spectrum.area[at];
    design.facts = {
        {"threshold", "Threshold", threshold, ""},
        {"area", "Area at the threshold", area * unit * unit, lengths.area},
        {"volume_above", "Volume above the threshold", spectrum.volume[at] * unit * unit * unit, lengths.volume},
        {"mean_gradient", "Mean gradient at the threshold", area > 0.0 ? spectrum.gradientIntegral[at] / area : 0.0,
         "per unit"}};
    for (std::size_t i = 0; i < std::min(maxima.size(), mostMaximumFacts); ++i) {
        const std::string number = std::to_string(i + 1);
        design.facts.push_back({"maximum_" + number, "Maximum " + number, maxima[i].isovalue, ""});
    }
}

/// Why no isovalue is the steepest.
std::string whyNoMaximum(const ContourSpectrum& spectrum) {
    if (!(spectrum.volume[0] > 0.0)) return "The volume holds no data";
    if (!(*std::ranges::max_element(spectrum.area) > 0.0)) return "All data has one intensity and no isosurface";
    return "No isosurface is steeper than those beside it";
}

}  // namespace

const ParameterTable<ContourSpectrumConfig>& parametersOf(const ContourSpectrumConfig&) {
    return contourSpectrumTable();
}

std::optional<Design> design(const ContourSpectrumConfig& config, const DesignerInput& input,
                             const Progress& progress) {
    requireDesignable("ContourSpectrumConfig", parametersOf(config), config, input);
    const auto spectrum = contourSpectrum(input.shown, progress);
    if (!spectrum) return std::nullopt;
    const Lengths lengths(input.shown.geometry());
    const bool given = config.choice == IsovalueChoice::given;
    const std::vector<SpectrumMaximum> maxima = maximaOf(*spectrum, config.leastArea);
    Design design{PowerCurve{2, config.opacity}};
    design.plots = spectrumPlots(*spectrum, lengths);
    if (!given && maxima.empty()) {
        design.message = whyNoMaximum(*spectrum) + ": the opacity grows with the square of the intensity.";
        return design;
    }
    const double threshold = given ? config.threshold : maxima.front().isovalue;
    design.classification = rampAt(threshold, config);
    addFacts(*spectrum, threshold, maxima, lengths, design);
    if (!(*std::ranges::max_element(spectrum->area) > 0.0))
        design.message = whyNoMaximum(*spectrum) + ": the ramp stands at the given threshold all the same.";
    design.explanation.push_back(
        given ? "The ramp stands at the given threshold " + roundedInWords(threshold, 0.001) + "."
              : "The isosurfaces are steepest at intensity " + roundedInWords(threshold, 0.001) +
                    ", where the intensity rises by " + roundedInWords(maxima.front().meanGradient, 0.001) +
                    " per unit in the mean: the ramp stands there.");
    design.explanation.push_back("The isosurface of this intensity has an area of " +
                                 roundedInWords(design.facts[1].value, 1.0) + " " + lengths.area + ", and " +
                                 roundedInWords(design.facts[2].value, 1.0) + " " + lengths.volume +
                                 " of the volume are brighter.");
    const std::size_t first = given ? 0 : 1, end = std::min(maxima.size(), mostMaximumFacts);
    if (first < end) {
        std::string others = given ? "Isosurfaces are steepest at" : "Isosurfaces are steep, too, at";
        for (std::size_t i = first; i < end; ++i)
            others += (i > first ? ", " : " ") + roundedInWords(maxima[i].isovalue, 0.001);
        design.explanation.push_back(others + ".");
    }
    return design;
}

}  // namespace echolucent
