#include "app/cli/report/opening_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/study/study_checksum.h"

namespace echolucent::cli {

namespace {

const ImportFact* factNamed(const Study& study, const std::string& name) {
    const auto found = std::ranges::find(study.facts, name, &ImportFact::name);
    return found == study.facts.end() ? nullptr : &*found;
}

std::string sideText(const OpeningFinds& finds) {
    if (finds.side) return {};
    const ViewDirection& lean = finds.lean;
    if (lean == ViewDirection{}) return "The scan is looked into along the beam.";
    return fmt::format(
        "The scan is looked into from the probe: azimuth {:.4g}, elevation {:.4g} and roll {:.4g} degrees.",
        lean.azimuth, lean.elevation, lean.roll);
}

/// The answer of the search, and what became of it if that is another than it suggests.
std::string frontText(const DocumentStudy& opened) {
    const auto& cut = opened.finds->cut;
    if (!cut) return opened.finds->beam.sure ? "" : "No front is looked for along a beam that is not sure.";
    const bool suggested = cut->answer == NearCutAnswer::wallBeforeFluid;
    const bool taken = opened.document.scene.front.source == FrontSource::found;
    return cut->message + (suggested && !taken ? " Nothing is cut." : "");
}

Json directionJson(const ViewDirection& direction) {
    return {{"azimuth", direction.azimuth}, {"elevation", direction.elevation}, {"roll", direction.roll}};
}

Json findsJson(const DocumentStudy& opened) {
    const Scene& scene = opened.document.scene;
    const ChosenBeam beam = beamOf(opened);
    Json found;
    found["beam"] = {{"axis", nameOf(beam.axis)},
                     {"source", beam.source},
                     {"confidence", beam.confidence ? Json(*beam.confidence) : Json()},
                     {"lean", directionJson(opened.document.beam.lean)}};
    found["side"] = directionJson(scene.side);
    found["front"] = nullptr;
    if (const auto& cut = opened.finds->cut)
        found["front"] = {{"answer", nameOf(cut->answer)},
                          {"depth_mm", cut->nearCutMm},
                          {"confidence", cut->confidence},
                          {"sure", cut->sure},
                          {"taken", scene.front.source == FrontSource::found}};
    found["reduction"] = nameOf(scene.look.reduction);
    const ImportFact* noData = factNamed(opened.study, "voxels without data");
    found["no_data"] = noData != nullptr ? Json{{"share", noData->value}, {"source", noData->source}} : Json();
    return found;
}

}  // namespace

std::string findsText(const DocumentStudy& opened) {
    const ImportFact* noData = factNamed(opened.study, "voxels without data");
    std::string text;
    for (const std::string& sentence :
         {opened.finds->beam.sentence, sideText(*opened.finds), frontText(opened),
          fmt::format("Speckle reduction: {}.", nameOf(opened.document.scene.look.reduction)),
          noData != nullptr ? fmt::format("Voxels without data: {} ({}).", noData->value, noData->source) : ""})
        if (!sentence.empty()) text += (text.empty() ? "" : "\n") + sentence;
    return text;
}

Result<Json> madeOf(const Invocation& invocation, const DocumentStudy& opened) {
    const auto& file = std::get<StudyFile>(opened.document.study);
    const auto checksum = checksumOf(opened.study.files);
    if (!checksum) return tl::unexpected<Failure>(checksum.error());
    Json arguments = Json::array();
    for (const std::string& argument : invocation.arguments) arguments.push_back(withoutFolders(argument));
    return Json{{"program", invocation.program},
                {"command", arguments},
                {"study",
                 {{"file", withoutFolders(file.path)},
                  {"checksum", checksum->text},
                  {"bytes", checksum->bytes},
                  {"files", checksum->files},
                  {"series", file.options.series},
                  {"phase", opened.document.scene.phase}}},
                {"found", findsJson(opened)}};
}

std::string withoutFolders(const std::string& argument) {
    const std::size_t end = argument.find_last_not_of('/');
    if (end == std::string::npos) return argument;
    const std::size_t slash = argument.find_last_of('/', end);
    if (slash == std::string::npos) return argument.substr(0, end + 1);
    // What stands before the path: "--json=", "manual:".
    const std::size_t sign = argument.find_first_of("=:");
    const std::size_t before = sign < slash ? sign + 1 : 0;
    return argument.substr(0, before) + argument.substr(slash + 1, end - slash);
}

}  // namespace echolucent::cli
