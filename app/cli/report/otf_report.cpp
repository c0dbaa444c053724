#include "app/cli/report/otf_report.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/cli/report/opening_report.h"
#include "app/cli/report/report_json.h"
#include "processing/adaptive/adapted_curve.h"
#include "processing/adaptive/halved_lengths.h"
#include "processing/adaptive/method_parameters.h"
#include "processing/adaptive/method_reading.h"
#include "processing/adaptive/quiet_reading.h"
#include "processing/tube_core/slabs/tube_grid.h"

namespace echolucent::cli {

namespace {

Json maybe(const std::optional<double>& value) { return value ? finiteJson(*value) : Json(nullptr); }
Json maybe(const std::optional<Vec3>& value) { return value ? vectorJson(*value) : Json(nullptr); }

/// The status of the tube core at an index. One that is never placed does not say what lies there.
std::string_view statusOf(const AdaptiveOtf& otf, std::size_t tube) {
    if (isNeverPlaced(otf.config.grid, tube)) return "never placed";
    switch (otf.tubes[tube].status) {
        case TubeStatus::surface: return "surface";
        case TubeStatus::none: return "none";
        case TubeStatus::outside: return "outside";
    }
    return "";
}

/// a of the initial function, as --opacity-scale sets it. For a manual curve the factor on its file's opacities.
double opacityScaleOf(const OpacityCurve& curve, double manualFactor) {
    if (const auto* power = std::get_if<PowerCurve>(&curve)) return power->scale;
    if (const auto* linear = std::get_if<LinearCurve>(&curve)) return linear->slope;
    return manualFactor;
}

Json initialFunction(const OpacityCurve& curve) {
    Json made;
    if (const auto* power = std::get_if<PowerCurve>(&curve)) {
        made["exponent"] = power->exponent;
        made["scale"] = power->scale;
    } else if (const auto* linear = std::get_if<LinearCurve>(&curve)) {
        made["lower"] = linear->lower;
        made["slope"] = linear->slope;
        made["upper"] = linear->upper;
    } else if (const auto* manual = std::get_if<ManualCurve>(&curve)) {
        made["nodes"] = Json::array();
        for (const CurveNode& node : manual->nodes)
            made["nodes"].push_back({{"intensity", node.intensity}, {"opacity", node.opacity}});
    }
    return made;
}

Json readingName(const AdaptiveOtfConfig& config) {
    const auto reading = readingOf(config);
    return reading ? Json(echolucent::nameOf(*reading)) : Json(nullptr);
}

Json valueOf(const ParameterValue& value) {
    return std::visit([](const auto& one) { return Json(one); }, value);
}

Json foundRampJson(const std::optional<FoundRamp>& ramp) {
    if (!ramp) return nullptr;
    return {{"begin", ramp->begin}, {"end", ramp->end}, {"opacity", ramp->opacity}};
}

/// Named like the command line's options. Parameters that do not apply are left out.
Json methodParametersJson(const AdaptiveOtf& otf, const OtfContext& context) {
    const AdaptiveOtfConfig config = configUsed(otf);
    Json all{{"reading", readingName(otf.config)},
             {"initial", withoutFolders(context.initialName)},
             {"initial_function", initialFunction(config.initial)},
             {"opacity_scale", opacityScaleOf(config.initial, context.manualFactor)},
             {"tube_grid", Json::array({config.grid.columns, config.grid.rows})},
             {"without_tubes", config.grid.withoutTubes},
             {"tube_spacing_units", Json::array({otf.tubeSpacingUnits[0], otf.tubeSpacingUnits[1]})},
             {"unit_mm", otf.tubeLengthUnit}};
    for (const Parameter<AdaptiveOtfConfig>& row : methodParameters())
        if (const auto value = row.get(config)) all[std::string(row.name)] = valueOf(*value);
    all["d_max"] = otf.dMax;
    all["tubes_meeting_volume"] = otf.tubesMeetingVolume;
    all["least_contrast"] = maybe(otf.leastContrast);
    all["fluid_intensity"] = maybe(otf.fluidIntensity);
    all["trust"] = otf.trust;
    if (asksForEveryWall(config.curve)) all["every_wall"] = foundRampJson(otf.everyWall);
    all["surfaces_where_data_begin"] = otf.surfacesWhereDataBegin;
    all["lengths_halved"] = otf.lengthsHalved;
    const CurveRule used = quieterRule(config.curve, otf.speckleLeft.value_or(1.0));
    if (const auto* ramp = std::get_if<RampRule>(&used)) {
        all["quiet_ramp_begin"] = ramp->begin;
        all["quiet_ramp_end"] = ramp->end;
    }
    addAdjustment(all, context.adjustment);
    return all;
}

Json tubeObject(const TubeCore& tube, std::string_view status) {
    return {{"u", tube.column},
            {"v", tube.row},
            {"status", status},
            {"entry_voxel", maybe(tube.entryVoxel)},
            {"surface_voxel", maybe(tube.surfaceVoxel)},
            {"i_low", maybe(tube.lowIntensity)},
            {"i_high", maybe(tube.highIntensity)},
            {"i_low_max", maybe(tube.lowIntensityMax)},
            {"slope", maybe(tube.slope)},
            {"edge_to_noise", maybe(tube.edgeToNoise)},
            {"contrast", maybe(tube.contrast)},
            {"fluid_spread", maybe(tube.fluidSpread)},
            {"w_intensity", tube.intensityWeight},
            {"w_slope", tube.slopeWeight},
            {"w_extra", tube.extraWeight},
            {"d", tube.d}};
}

/// A tube core, with its values in the quiet voxels if there are any.
Json tubeObject(const AdaptiveOtf& otf, std::size_t tube) {
    Json object = tubeObject(otf.tubes[tube], statusOf(otf, tube));
    if (otf.quiet.empty()) return object;
    const QuietInterface& quiet = otf.quiet[tube];
    object["quiet"] = {
        {"i_low", maybe(quiet.low)}, {"i_high", maybe(quiet.high)}, {"fluid_spread", maybe(quiet.fluidSpread)}};
    return object;
}

Json curveObject(const AdaptiveOtf& otf) {
    Json intensities = Json::array(), logOpacities = Json::array(), opacities = Json::array();
    for (std::size_t i = 0; i < otf.logOpacity.size(); ++i) {
        intensities.push_back(AdaptiveOtf::intensityOf(i));
        logOpacities.push_back(finiteJson(otf.logOpacity[i]));
        opacities.push_back(otf.curve.opacities[i]);
    }
    return {{"intensity", intensities}, {"log_opacity", logOpacities}, {"opacity", opacities}};
}

/// The shortest text that reads back as the same double; empty if there is no number.
std::string numberCell(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? fmt::format("{}", *value) : std::string();
}

std::string vectorCells(const std::optional<Vec3>& value) {
    return value ? fmt::format("{},{},{}", (*value)[0], (*value)[1], (*value)[2]) : std::string(",,");
}

}  // namespace

void addAdjustment(Json& parameters, const CurveAdjustment& adjustment) {
    for (const Parameter<CurveAdjustment>& row : adjustmentParameters())
        parameters[std::string(row.name)] = valueOf(*row.get(adjustment));
}

std::string jsonReport(const Volume& volume, const AdaptiveOtf& otf, const OtfContext& context) {
    const VolumeGeometry& geometry = volume.geometry();
    const StageTimes& times = otf.times;
    const ChosenBeam& beam = context.beam;
    Json report;
    report["message"] = otf.message;
    report["made_of"] = context.madeOf;
    report["volume"] = {{"size", Json::array({geometry.size[0], geometry.size[1], geometry.size[2]})},
                        {"spacing_mm", vectorJson(geometry.spacing)},
                        {"spacing_known", geometry.spacingKnown},
                        {"type", volume.typeName()},
                        {"white_level", volume.whiteValue()}};
    if (volume.blackValue() != 0.0) report["volume"]["black_level"] = volume.blackValue();
    report["view"] = {{"direction_voxel", vectorJson(otf.directionVoxel)},
                      {"beam_axis", echolucent::nameOf(otf.view.beamAxis)},
                      {"azimuth", otf.view.azimuthDegrees},
                      {"elevation", otf.view.elevationDegrees},
                      {"front_bowed", otf.view.cutSurface.has_value()},
                      {"near_mm", frontDepthMm(otf.view)},
                      {"front_forward", frontForwardJson(otf.view)}};
    report["beam"] = {
        {"axis", echolucent::nameOf(beam.axis)}, {"source", beam.source}, {"confidence", maybe(beam.confidence)}};
    report["reduction"] = echolucent::nameOf(otf.reduction);
    if (otf.speckleLeft) report["speckle_left"] = *otf.speckleLeft;
    report["parameters"] = methodParametersJson(otf, context);
    report["times_ms"] = {{"sampling", times.sampling},
                          {"cells", times.cells},
                          {"detection", times.detection},
                          {"weights", times.weights},
                          {"curve", times.curve},
                          {"total", times.total},
                          {"finding", context.findingMilliseconds},
                          {"quietening", context.quieteningMilliseconds}};
    report["tubes"] = Json::array();
    for (std::size_t t = 0; t < otf.tubes.size(); ++t) report["tubes"].push_back(tubeObject(otf, t));
    report["otf"] = curveObject(otf);
    if (!context.explanation.is_null()) report["explanation"] = context.explanation;
    // A file name in another encoding must not end the program.
    return report.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string curveTable(const AdaptiveOtf& otf) {
    std::string table = "intensity,opacity,log_opacity,initial_opacity\n";
    for (std::size_t i = 0; i < otf.logOpacity.size(); ++i)
        table += fmt::format("{},{},{},{}\n", AdaptiveOtf::intensityOf(i), otf.curve.opacities[i],
                             numberCell(otf.logOpacity[i]), opacityAt(otf.config.initial, AdaptiveOtf::intensityOf(i)));
    return table;
}

std::string tubeTable(const AdaptiveOtf& otf) {
    std::string table =
        "u,v,status,entry_x,entry_y,entry_z,surface_x,surface_y,surface_z,i_low,i_high,i_low_max,slope,edge_to_noise,"
        "w_intensity,w_slope,w_extra,d\n";
    for (std::size_t t = 0; t < otf.tubes.size(); ++t) {
        const TubeCore& tube = otf.tubes[t];
        table +=
            fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", tube.column, tube.row, statusOf(otf, t),
                        vectorCells(tube.entryVoxel), vectorCells(tube.surfaceVoxel), numberCell(tube.lowIntensity),
                        numberCell(tube.highIntensity), numberCell(tube.lowIntensityMax), numberCell(tube.slope),
                        numberCell(tube.edgeToNoise), tube.intensityWeight, tube.slopeWeight, tube.extraWeight, tube.d);
    }
    return table;
}

std::string summary(const Volume& volume, const AdaptiveOtf& otf) {
    const auto& size = volume.geometry().size;
    std::string text = fmt::format("{}x{}x{} {}, view {} turned by {} and {} degrees, front {} mm\n", size[0], size[1],
                                   size[2], volume.typeName(), echolucent::nameOf(otf.view.beamAxis),
                                   otf.view.azimuthDegrees, otf.view.elevationDegrees, frontDepthMm(otf.view));
    text += fmt::format("{} of {} tube cores meet the volume; {} have a surface, {} with a weight\n",
                        otf.tubesMeetingVolume, otf.tubes.size(), surfacesFound(otf), otf.tubesWithWeight);
    if (const std::size_t left = otf.config.grid.withoutTubes.size(); left > 0)
        text += fmt::format("{} of them {} never placed\n", left, left == 1 ? "is" : "are");
    if (otf.lengthsHalved)
        text += "The volume has few voxels: all lengths along the tube cores are half of what was set.\n";
    text += fmt::format("d_max {:.4g}, sum of d {:.4g}\n", otf.dMax, sumOfD(otf));
    text += fmt::format("{:.2f} ms: sampling {:.2f}, cells {:.2f}, detection {:.2f}, weights {:.2f}, curve {:.2f}\n",
                        otf.times.total, otf.times.sampling, otf.times.cells, otf.times.detection, otf.times.weights,
                        otf.times.curve);
    if (!otf.message.empty()) text += otf.message + "\n";
    return text;
}

}  // namespace echolucent::cli
