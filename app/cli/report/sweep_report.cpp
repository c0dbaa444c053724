#include "app/cli/report/sweep_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/cli/report/report_json.h"
#include "processing/adaptive/adaptive_otf_result.h"

namespace echolucent::cli {

namespace {

Json gainsJson(OtfSmoothing smoothing) {
    const SmoothingGains gains = gainsOf(smoothing);
    return {{"delay_frames", gains.delay},
            {"noise_gain", gains.noise},
            {"flicker_gain", gains.flicker},
            {"least_weight", gains.leastWeight}};
}

Json ratio(double shown, double unsmoothed) { return unsmoothed > 0.0 ? Json(shown / unsmoothed) : Json(nullptr); }

Json figures(double unsmoothed, double shown) {
    return {{"unsmoothed", unsmoothed}, {"shown", shown}, {"ratio", ratio(shown, unsmoothed)}};
}

std::string nameOfSmoothing(const SweepReport& report) {
    return report.smoothing ? std::string(nameOf(*report.smoothing)) : "static";
}

}  // namespace

std::vector<SampledCurve> unsmoothedOf(std::span<const SweptOtf> frames) {
    std::vector<SampledCurve> otfs;
    for (const SweptOtf& frame : frames) otfs.push_back(frame.unsmoothed);
    return otfs;
}

std::vector<SampledCurve> shownOf(std::span<const SweptOtf> frames) {
    std::vector<SampledCurve> otfs;
    for (const SweptOtf& frame : frames) otfs.push_back(frame.shown);
    return otfs;
}

std::string sweepJson(const SweepReport& report) {
    Json json;
    json["made_of"] = report.madeOf;
    json["view"] = {{"beam_axis", nameOf(report.start.beamAxis)}, {"azimuth", report.start.azimuthDegrees},
                    {"elevation", report.start.elevationDegrees}, {"front_bowed", report.start.cutSurface.has_value()},
                    {"near_mm", frontDepthMm(report.start)},      {"front_forward", frontForwardJson(report.start)}};
    json["motion"] = {{"axis", nameOf(report.motion.axis)},
                      {"probe", movesProbe(report.motion.scenario) ? "moving" : "still"},
                      {"object", movesObject(report.motion.scenario) ? "moving" : "still"}};
    json["smoothing"] = nameOfSmoothing(report);
    json["gains"] = report.smoothing ? gainsJson(*report.smoothing) : Json(nullptr);
    json["otf_flicker"] = figures(otfFlicker(unsmoothedOf(report.frames)), otfFlicker(shownOf(report.frames)));
    json["picture_change"] = json["picture_flicker"] = nullptr;
    if (report.unsmoothedPictures && report.shownPictures) {
        json["picture_change"] = figures(report.unsmoothedPictures->change, report.shownPictures->change);
        json["picture_flicker"] = figures(report.unsmoothedPictures->flicker, report.shownPictures->flicker);
    }
    json["frames"] = Json::array();
    for (const SweptOtf& frame : report.frames)
        json["frames"].push_back({{"frame", json["frames"].size()},
                                  {"degrees", frame.frame.degrees},
                                  {"phase", frame.frame.phase},
                                  {"sum_of_d", frame.sumOfD},
                                  {"tubes_with_surface", frame.tubesWithWeight}});
    // A file name in another encoding must not end the program.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string sweepTable(std::span<const SweptOtf> frames) {
    std::string table = "frame,degrees,phase,sum_of_d,tubes_with_surface";
    for (int i = 0; i < AdaptiveOtf::sampleCount; ++i) table += fmt::format(",opacity_{}", i);
    table += '\n';
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const SweptOtf& frame = frames[i];
        table += fmt::format("{},{},{},{},{}", i, frame.frame.degrees, frame.frame.phase, frame.sumOfD,
                             frame.tubesWithWeight);
        for (const double opacity : frame.shown.opacities) table += fmt::format(",{}", opacity);
        table += '\n';
    }
    return table;
}

std::string sweepSummary(const SweepReport& report) {
    const double unsmoothed = otfFlicker(unsmoothedOf(report.frames)), shown = otfFlicker(shownOf(report.frames));
    std::string text = fmt::format("{} frames, {}: flicker of the OTF {:.3g} unsmoothed, {:.3g} shown",
                                   report.frames.size(), nameOfSmoothing(report), unsmoothed, shown);
    if (unsmoothed > 0.0) text += fmt::format(" ({:.3f} of it)", shown / unsmoothed);
    if (report.smoothing) text += fmt::format(", {:.1f} frames late", gainsOf(*report.smoothing).delay);
    return text + '\n';
}

}  // namespace echolucent::cli
