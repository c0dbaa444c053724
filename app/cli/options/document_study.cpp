#include "app/cli/options/document_study.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <utility>
#include <variant>

#include "app/cli/options/option_text.h"
#include "io/document/session_file.h"
#include "io/output/overwriting.h"
#include "io/restricted/restricted_reader.h"
#include "io/study/simulated_study.h"
#include "io/study/study_assembly.h"
#include "io/study/study_checksum.h"
#include "processing/ascii_letters.h"
#include "processing/document/turned_document.h"
#include "processing/near_cut/bright_face.h"
#include "processing/near_cut/near_cut.h"

namespace echolucent::cli {

namespace {

constexpr std::array<std::string_view, 4> alwaysBeside{"VOLUME", "--document", "--view", "--help"};

/// Whether an option says how VOLUME is read. --phase does not: the document says which phase is shown.
bool saysHowToRead(const CLI::Option& option) {
    CLI::App reading;
    VolumeOptions volume;
    volume.addTo(reading);
    return option.get_name() != "--phase" && reading.get_option_no_throw(option.get_name()) != nullptr;
}

/// Where the study lies; if it is nowhere, the place that the document names. Says on stderr if it lies elsewhere.
std::string placeOf(const StudyFile& file, const std::string& document) {
    const std::string stated = studyPathFrom(document, file.path);
    const std::string place = placeOfStudy(file, document).value_or(stated);
    if (place != stated)
        std::fprintf(stderr, "%s is not there; its bytes were found in %s.\n", file.path.c_str(), place.c_str());
    return place;
}

Result<Study> readReferenced(const StudyFile& file, const std::string& path, const std::vector<std::string>& outputs) {
    keepFromOverwriting({path});
    if (auto possible = checkOutputs(outputs); !possible) return tl::unexpected<Failure>(possible.error());
    auto study = restricted::readStudy(path, file.options);
    if (!study) return study;
    keepFromOverwriting(study->files);
    if (auto possible = checkOutputs(outputs); !possible) return tl::unexpected<Failure>(possible.error());
    if (file.checksum.empty()) return study;
    const auto checksum = checksumOf(study->files);
    if (!checksum) return tl::unexpected<Failure>(checksum.error());
    if (const std::string change = changeOf(file, *checksum); !change.empty())
        std::fprintf(stderr, "%s %s: the result may not be the saved one.\n", path.c_str(), change.c_str());
    return study;
}

/// Reads the study of the document at `path`, and sets in `document` where the study was found.
Result<Study> studyOf(Document& document, const std::string& path, const VolumeOptions& volume,
                      const std::vector<std::string>& outputs) {
    if (!volume.path.empty()) {
        VolumeOptions reading = volume;
        // If it is the document's own volume, wherever it lies, curves keep their meaning and positions their places.
        const auto* file = std::get_if<StudyFile>(&document.study);
        const bool own = file != nullptr && nameFromPath(file->path) == nameFromPath(volume.path);
        if (own) reading.read.blackAtZero = reading.read.blackAtZero || file->options.blackAtZero;
        auto named = reading.readNamed(outputs);
        if (!named) return tl::unexpected<Failure>(named.error());
        if (own) named->reference.turnedAxis = file->turnedAxis;
        document.study = std::move(named->reference);
        return std::move(named->study);
    }
    if (auto* file = std::get_if<StudyFile>(&document.study)) {
        file->path = placeOf(*file, path);
        return readReferenced(*file, file->path, outputs);
    }
    if (const auto* scan = std::get_if<SimulatedScan>(&document.study)) return simulatedStudy(*scan);
    return fail(FailureKind::wrongUsage, path, "study", "is null: the document names no study",
                "Give the volume on the command line.");
}

/// Fails if the scan has no side of the name that was said. Says which names it has.
Result<void> requireSide(const std::string& said, const OpeningFinds& finds) {
    if (said.empty() || finds.place) return {};
    std::string words;
    for (const JudgedSide& judged : finds.sides->sides)
        words += fmt::format("{}{}", words.empty() ? "" : ", ", judged.side.word);
    return wrongUsage("--side", "is \"" + said + "\"", "This scan has the sides " + words + ", or 1 to 6.");
}

/// Fails if there is clearly no document at the path (readDocumentStudy()).
Result<void> requireDocument(const std::string& path, const std::string& remedy) {
    std::error_code error;
    const bool calledSo = lowerCase(std::filesystem::path(path).extension().string()) == ".json";
    const bool folder = std::filesystem::is_directory(path, error);
    const bool file = std::filesystem::is_regular_file(path, error);
    if ((!folder && !file) || (file && calledSo) || looksLikeDocument(path)) return {};
    return fail(FailureKind::wrongUsage, path, "", "is no document of the workstation", remedy);
}

}  // namespace

void DocumentOptions::addTo(CLI::App& command, const std::string& makes) {
    command.get_option("VOLUME")->required(false);
    command
        .add_option("--document", path,
                    "A document of the workstation: " + makes + ". Without VOLUME the document names the study")
        ->type_name("FILE.json");
    command
        .add_option("--view", view,
                    "Number of the document's pane, or id of a view of version 1; the first where not given")
        ->type_name("NUMBER")
        ->needs("--document");
}

Result<void> DocumentOptions::check(const CLI::App& command, const std::vector<std::string_view>& beside) const {
    if (path.empty()) {
        if (command.get_option("VOLUME")->count() > 0) return {};
        return wrongUsage("VOLUME", "is required", "Name a volume, or a document with --document.");
    }
    const auto isOneOf = [](const auto& names, const std::string& name) {
        return std::ranges::find(names, name) != names.end();
    };
    for (const CLI::Option* option : command.get_options()) {
        if (option->count() == 0) continue;
        if (isOneOf(alwaysBeside, option->get_name()) || isOneOf(beside, option->get_name())) continue;
        if (!saysHowToRead(*option))
            return wrongUsage(option->get_name(), "plays no part beside --document",
                              "Leave it out, or change the document.");
        if (command.get_option("VOLUME")->count() == 0)
            return wrongUsage(option->get_name(), "plays no part beside --document without VOLUME",
                              "Leave it out, or name the volume.");
    }
    return {};
}

Result<DocumentStudy> readDocumentStudy(const std::string& path, const VolumeOptions& volume,
                                        const std::vector<std::string>& outputs, std::optional<int> number,
                                        const std::string& remedy) {
    if (auto possible = requireDocument(path, remedy); !possible) return tl::unexpected<Failure>(possible.error());
    keepFromOverwriting({path});
    if (auto possible = checkOutputs(outputs); !possible) return tl::unexpected<Failure>(possible.error());
    auto read = readDocumentPane(path, number);
    if (!read) return tl::unexpected<Failure>(read.error());
    Document& document = read->document;
    auto study = studyOf(document, path, volume, outputs);
    if (!study) return tl::unexpected<Failure>(study.error());
    const VolumeGeometry& geometry = study->phases.front()->geometry();
    document = inGridOfStudy(std::move(document), study->turnedAxis, geometry);
    const int phase = phaseOf(document, read->pane);
    if (phase < 0 || phase >= static_cast<int>(study->phases.size()))
        return fail(FailureKind::wrongUsage, path, "phases",
                    fmt::format("shows phase {}, but the volume has {} phase(s)", phase, study->phases.size()));
    return DocumentStudy{std::move(document), std::move(*study), read->pane, path};
}

Result<DocumentStudy> openStudy(const VolumeOptions& volume, const ViewOptions& view, const Look& look,
                                const std::vector<std::string>& outputs, double aspect) {
    const auto asked = view.get();
    if (!asked) return tl::unexpected<Failure>(asked.error());
    auto read = volume.readNamed(outputs);
    if (!read) return tl::unexpected<Failure>(read.error());
    const Volume& first = *read->study.phases.front();

    const auto begin = std::chrono::steady_clock::now();
    OpeningFinds finds = *findOnOpening(first, {}, view.said());
    if (const auto there = requireSide(view.side, finds); !there) return tl::unexpected<Failure>(there.error());
    // A suggested front is flat.
    if (view.nearCutSuggested()) {
        const BeamAxis axis = finds.beam.sure ? finds.beam.axis : Beam{}.axis;
        finds.cut = findFlatNearCut(first, viewpointOf(axis, finds.side), {});
    }
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;

    Document fresh;
    fresh.scene.look = look;
    const OpenedStudy opened{.reference = read->reference,
                             .box = first.dataBox(),
                             .phases = static_cast<int>(read->study.phases.size()),
                             .finds = finds};
    Document document = openedDocuments(fresh, opened, aspect).found;
    Scene& scene = document.scene;
    if (view.nearCutSuggested()) {
        scene.front = frontAcross(scene.side, finds.cut->nearCutMm, FrontSource::found);
        scene.exposure = finds.exposure = exposureFor(*faceIntensity(first, viewpointOf(document)));
    } else if (view.said().front) {
        scene.front = frontAcross(scene.side, frontDepthMm(*asked));
    }
    if (const auto kept = leavesSomething(first, viewpointOf(document)); !kept)
        return tl::unexpected<Failure>(kept.error());
    scene.phase = document.motion.otfPhase = volume.phase;
    return DocumentStudy{std::move(document), std::move(read->study), firstPane, {}, std::move(finds), took.count()};
}

ChosenBeam beamOf(const DocumentStudy& opened) {
    const Beam& beam = opened.document.beam;
    if (!opened.finds) return {beam.axis, std::string(nameOf(beam.source)), std::nullopt, ""};
    if (beam.source == BeamSource::person) return {beam.axis, "option", std::nullopt, ""};
    const BeamGuess& guess = opened.finds->beam;
    return {beam.axis, guess.sure ? std::string(nameOf(guess.evidence)) : "assumed", guess.confidence, guess.sentence};
}

std::string otfNameOf(const Document& document, std::size_t pane) {
    const DesignerConfig* designer = designerConfigOf(document, pane);
    return std::string(designer != nullptr ? nameOf(designerOf(*designer)) : nameOf(document.panes.at(pane).curve));
}

namespace {

/// Puts the curve in its place among the document's curves, and returns which place that is. A power curve without the
/// exponent of the parabolic curve goes to the quartic one. The curve must be no SampledCurve.
CurveKind putCurve(CurveSet& curves, const OpacityCurve& curve) {
    if (const auto* power = std::get_if<PowerCurve>(&curve)) {
        const bool parabolic = power->exponent == curves.parabolic.exponent;
        (parabolic ? curves.parabolic : curves.quartic) = *power;
        return parabolic ? CurveKind::parabolic : CurveKind::quartic;
    }
    if (const auto* linear = std::get_if<LinearCurve>(&curve)) {
        curves.linear = *linear;
        return CurveKind::linear;
    }
    curves.manual = std::get<ManualCurve>(curve);
    return CurveKind::manual;
}

}  // namespace

Document withMethod(Document document, const AdaptiveOtfConfig& config) {
    MethodChoice& method = document.method;
    method.config = config;
    method.config.initial = AdaptiveOtfConfig{}.initial;
    if (const auto* power = std::get_if<PowerCurve>(&config.initial)) {
        method.initial = power->exponent == 2 ? InitialKind::parabolic : InitialKind::quartic;
        method.initialScale = power->scale;
    } else {
        const CurveKind kind = putCurve(document.curves, config.initial);
        method.initial = kind == CurveKind::linear ? InitialKind::linear : InitialKind::manual;
    }
    return document;
}

Document withCurve(Document document, const OpacityCurve& curve) {
    CurveSet curves = curvesOf(document, firstPane);
    const CurveKind kind = putCurve(curves, curve);
    return echolucent::withCurve(withCurves(std::move(document), firstPane, curves), firstPane, kind);
}

}  // namespace echolucent::cli
