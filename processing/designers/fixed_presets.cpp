#include "processing/designers/fixed_presets.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "processing/designers/designer_contract.h"
#include "processing/designers/fetal_preset.h"
#include "processing/intensity/intensity_counts.h"
#include "processing/parameters/parameter_rows.h"

namespace echolucent {

namespace {

constexpr double lowOpacity = 0.2, highOpacity = 0.8, fullOpacity = 0.95;

/// Appends the part within [0,1] of the line from the last node to the next.
void appendWithin(ManualCurve& curve, CurveNode& last, const CurveNode& next) {
    const auto opacityAtEdge = [&](double edge) {
        return last.opacity +
               (next.opacity - last.opacity) * (edge - last.intensity) / (next.intensity - last.intensity);
    };
    if (last.intensity < 0.0 && next.intensity > 0.0) curve.nodes.push_back({0.0, opacityAtEdge(0.0)});
    if (next.intensity >= 0.0 && next.intensity <= 1.0) curve.nodes.push_back(next);
    if (last.intensity < 1.0 && next.intensity > 1.0) curve.nodes.push_back({1.0, opacityAtEdge(1.0)});
    last = next;
}

ManualCurve echoRamp(const EchoRampConfig& config) {
    const double above = std::nextafter(config.threshold, 2.0);
    ManualCurve curve;
    CurveNode last{-1.0, 0.0};
    for (const CurveNode& node :
         {CurveNode{config.threshold - config.edge, 0.0}, CurveNode{config.threshold, lowOpacity},
          CurveNode{above, highOpacity}, CurveNode{std::max(above, config.threshold + config.edge), fullOpacity}})
        appendWithin(curve, last, node);
    return curve;
}

/// A design with the curve unchanged, and the share of voxels that the curve shows.
Design presetDesign(ManualCurve curve, const Volume& shown, const std::string& name) {
    const IntensityCounts counts = intensityCounts(shown);
    Design design{std::move(curve)};
    std::uint64_t visible = 0;
    for (std::size_t i = 0; i < counts.counts.size(); ++i)
        if (opacityAt(design.classification.curve(), counts.intensities[i]) > 0.0) visible += counts.counts[i];
    const double share = counts.total > 0 ? static_cast<double>(visible) / static_cast<double>(counts.total) : 0.0;
    design.facts = {{"shown_share", "Voxels that it shows", share, "share"}};
    design.explanation = {name + " is the same curve for every volume: it shows " + percentInWords(share) +
                          " of the voxels of this one."};
    if (counts.total == 0)
        design.message = "No voxel carries data: " + name + " shows nothing and stays as it is.";
    else if (visible == 0)
        design.message = "No voxel is bright enough for " + name + ": it shows nothing and stays as it is.";
    return design;
}

const ParameterTable<EchoRampConfig>& echoRampTable() {
    using namespace parameter_rows;
    constexpr std::string_view source = "SlicerHeart, Echo Volume Render";
    static const ParameterTable<EchoRampConfig> table{{
        number<&EchoRampConfig::threshold>(
            {"threshold", "Threshold", "Intensity from which on opacity is high: white times this share", "share",
             source},
            {0, 1}),
        number<&EchoRampConfig::edge>(
            {"edge", "Edge width", "How far the ramp reaches below and above the threshold", "share", source}, {0, 1},
            {.offered = ParameterRange{0, 0.2}}),
    }};
    return table;
}

}  // namespace

const ParameterTable<FetalPresetConfig>& parametersOf(const FetalPresetConfig&) {
    static const ParameterTable<FetalPresetConfig> table;
    return table;
}
const ParameterTable<EchoRampConfig>& parametersOf(const EchoRampConfig&) { return echoRampTable(); }

std::optional<Design> design(const FetalPresetConfig& config, const DesignerInput& input, const Progress& progress) {
    requireDesignable("FetalPresetConfig", parametersOf(config), config, input);
    Design design = presetDesign(ManualCurve{{fetalPresetNodes.begin(), fetalPresetNodes.end()}}, input.shown,
                                 "3D Slicer's fetal preset");
    if (progress.cancelled()) return std::nullopt;
    progress.at(1.0);
    design.explanation.emplace_back(
        "It is clear up to level 60 of 255, rises to 0.6 at level 120 and to 0.8 at white.");
    return design;
}

std::optional<Design> design(const EchoRampConfig& config, const DesignerInput& input, const Progress& progress) {
    requireDesignable("EchoRampConfig", parametersOf(config), config, input);
    Design design = presetDesign(echoRamp(config), input.shown, "SlicerHeart's echo ramp");
    if (progress.cancelled()) return std::nullopt;
    progress.at(1.0);
    design.explanation.push_back("It is clear up to " + inWords(config.threshold - config.edge) + ", rises to 0.2 at " +
                                 inWords(config.threshold) + ", is 0.8 just above and 0.95 from " +
                                 inWords(config.threshold + config.edge) + " on.");
    design.facts.push_back({"threshold", "Threshold", config.threshold});
    design.facts.push_back({"edge", "Edge width", config.edge});
    return design;
}

}  // namespace echolucent
