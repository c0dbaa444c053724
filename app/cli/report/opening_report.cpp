#include "app/cli/report/opening_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>

#include "io/study/study_assembly.h"
#include "io/study/study_checksum.h"

namespace echolucent::cli {

namespace {

const ImportFact* factNamed(const Study& study, const std::string& name) {
    const auto found = std::ranges::find(study.facts, name, &ImportFact::name);
    return found == study.facts.end() ? nullptr : &*found;
}

std::string sideText(const OpeningFinds& finds) {
    if (finds.sides) {
        const JudgedSide& taken = finds.sides->sides[*finds.place];
        if (finds.source == SideSource::found && *finds.place == finds.sides->best) return finds.sides->sentence;
        return fmt::format("The scan is looked into from side {}, \"{}\".", taken.side.number, taken.side.name);
    }
    if (finds.source == SideSource::person) return {};
    const ViewDirection& lean = finds.lean;
    if (lean == ViewDirection{}) return "The scan is looked into along the beam.";
    return fmt::format(
        "The scan is looked into from the probe: azimuth {:.4g}, elevation {:.4g} and roll {:.4g} degrees.",
        lean.azimuth, lean.elevation, lean.roll);
}

bool isFrontTaken(const DocumentStudy& opened) {
    const Front& front = opened.document.scene.front;
    return front.source == FrontSource::found && cuts(front);
}

std::string exposureText(const OpeningFinds& finds) {
    if (finds.exposure == 1.0) return {};
    return fmt::format("The scan begins with a face that is almost white: pictures are {:.2g} times as bright.",
                       finds.exposure);
}

/// The answer of the search for the front. If it suggests a cut that is not taken, the text says so.
std::string frontText(const DocumentStudy& opened) {
    const auto& cut = opened.finds->cut;
    if (!cut) return {};
    if (opened.document.scene.front.surface) return messageOfFront(*cut);
    const bool suggested = cut->answer == NearCutAnswer::wallBeforeFluid;
    return cut->message + (suggested && !isFrontTaken(opened) ? " Nothing is cut." : "");
}

Json directionJson(const ViewDirection& direction) {
    return {{"azimuth", direction.azimuth}, {"elevation", direction.elevation}, {"roll", direction.roll}};
}

/// The six sides, and which one was taken; null if none was looked for.
Json sidesJson(const OpeningFinds& finds) {
    if (!finds.sides) return nullptr;
    Json sides = Json::array();
    for (std::size_t i = 0; i < finds.sides->sides.size(); ++i) {
        const JudgedSide& judged = finds.sides->sides[i];
        sides.push_back({{"number", judged.side.number},
                         {"side", judged.side.word},
                         {"name", judged.side.name},
                         {"score", judged.score.total},
                         {"front_mm", makesFront(judged.front) ? Json(judged.front.nearCutMm) : Json()},
                         {"taken", i == *finds.place}});
    }
    return {{"source", nameOf(finds.source)}, {"list", sides}};
}

/// What was found on opening; null if the document was read from a file.
Json findsJson(const DocumentStudy& opened) {
    if (!opened.finds) return nullptr;
    const Scene& scene = opened.document.scene;
    const ChosenBeam beam = beamOf(opened);
    Json found;
    found["beam"] = {{"axis", nameOf(beam.axis)},
                     {"source", beam.source},
                     {"confidence", beam.confidence ? Json(*beam.confidence) : Json()},
                     {"lean", directionJson(opened.document.beam.lean)}};
    found["side"] = directionJson(scene.side);
    found["sides"] = sidesJson(*opened.finds);
    found["front"] = nullptr;
    if (const auto& cut = opened.finds->cut)
        found["front"] = {{"answer", nameOf(cut->answer)},
                          {"depth_mm", cut->nearCutMm},
                          {"confidence", cut->confidence},
                          {"sure", cut->sure},
                          {"bowed", scene.front.surface.has_value()},
                          {"taken", isFrontTaken(opened)}};
    found["exposure"] = scene.exposure;
    found["reduction"] = nameOf(scene.look.reduction);
    const ImportFact* noData = factNamed(opened.study, "voxels without data");
    found["no_data"] = nullptr;
    if (noData != nullptr) found["no_data"] = {{"share", noDataShare(opened.study.phases)}, {"source", noData->source}};
    return found;
}

/// The path of a study that is a folder; else it is empty.
std::string folderOf(const StudyReference& study) {
    const auto* file = std::get_if<StudyFile>(&study);
    std::error_code unreadable;
    return file != nullptr && std::filesystem::is_directory(file->path, unreadable) ? file->path : "";
}

/// The document that was read; null if options made it.
Result<Json> documentJson(const DocumentStudy& opened) {
    if (opened.file.empty()) return Json();
    const auto checksum = checksumOf({opened.file});
    if (!checksum) return tl::unexpected<Failure>(checksum.error());
    return Json{{"file", withoutFolders(opened.file)},
                {"checksum", checksum->text},
                {"bytes", checksum->bytes},
                {"pane", opened.pane + 1}};
}

Result<Json> studyJson(const DocumentStudy& opened) {
    const int phase = phaseOf(opened.document, opened.pane);
    if (const auto* scan = std::get_if<SimulatedScan>(&opened.document.study))
        return Json{{"scene", nameOf(scan->scene)}, {"size", scan->size}, {"seed", scan->seed}, {"phase", phase}};
    const auto& file = std::get<StudyFile>(opened.document.study);
    const auto checksum = checksumOf(opened.study.files);
    if (!checksum) return tl::unexpected<Failure>(checksum.error());
    // Checksum and UID identify the study of a folder, whose name is left out.
    return Json{{"file", shownStudyName(opened)}, {"checksum", checksum->text},    {"bytes", checksum->bytes},
                {"files", checksum->files},       {"series", file.options.series}, {"phase", phase}};
}

}  // namespace

std::string shownStudyName(const DocumentStudy& opened) {
    if (const auto* scan = std::get_if<SimulatedScan>(&opened.document.study))
        return fmt::format("simulated scan, {}", nameOf(scan->scene));
    const auto& file = std::get<StudyFile>(opened.document.study);
    return folderOf(opened.document.study).empty() ? withoutFolders(file.path) : std::string();
}

std::string findsText(const DocumentStudy& opened) {
    const ImportFact* noData = factNamed(opened.study, "voxels without data");
    std::string text;
    for (const std::string& sentence :
         {opened.finds->beam.sentence, sideText(*opened.finds), frontText(opened), exposureText(*opened.finds),
          fmt::format("Speckle reduction: {}.", nameOf(opened.document.scene.look.reduction)),
          noData != nullptr ? fmt::format("Voxels without data: {} ({}).", noData->value, noData->source) : ""})
        if (!sentence.empty()) text += (text.empty() ? "" : "\n") + sentence;
    return text;
}

Result<Json> madeOf(const Invocation& invocation, const DocumentStudy& opened) {
    Json arguments = Json::array();
    const std::string folder = folderOf(opened.document.study);
    for (const std::string& argument : invocation.arguments)
        arguments.push_back(!folder.empty() && argument == folder ? "" : withoutFolders(argument));
    auto document = documentJson(opened);
    if (!document) return document;
    auto study = studyJson(opened);
    if (!study) return study;
    return Json{{"program", invocation.program},
                {"command", arguments},
                {"document", *std::move(document)},
                {"study", *std::move(study)},
                {"found", findsJson(opened)}};
}

std::string withoutFolders(const std::string& argument) {
    constexpr std::string_view manual = "manual:";
    std::size_t before = 0;
    if (argument.starts_with("--"))
        if (const std::size_t sign = argument.find_first_of("=/"); sign != std::string::npos && argument[sign] == '=')
            before = sign + 1;
    if (argument.compare(before, manual.size(), manual) == 0) before += manual.size();
    const std::size_t slash = argument.rfind('/');
    if (slash == std::string::npos || slash < before) return argument;
    return argument.substr(0, before) + argument.substr(slash + 1);
}

}  // namespace echolucent::cli
