#include "app/cli/document_render.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "io/document/session_file.h"
#include "io/output/overwriting.h"
#include "io/restricted/restricted_reader.h"
#include "io/study/import_report.h"
#include "io/study/simulated_study.h"
#include "io/study/study_checksum.h"

namespace echolucent::cli {

namespace {

constexpr std::array besideDocument{"VOLUME",           "--document",
                                    "--view",           "--size",
                                    "--background",     "--output",
                                    "--raw-size",       "--raw-type",
                                    "--raw-byte-order", "--raw-header-bytes",
                                    "--raw-spacing",    "--frames-as-slices",
                                    "--all-voxels",     "--help"};

/// Where the study of a document is, or where the document says, if that is nowhere.
std::string placeOf(const StudyFile& file, const std::string& document) {
    const std::string stated = studyPathFrom(document, file.path);
    const std::string place = placeOfStudy(file, document).value_or(stated);
    if (place != stated)
        std::fprintf(stderr, "%s is not there; its bytes were found in %s.\n", file.path.c_str(), place.c_str());
    return place;
}

Result<Study> readReferenced(const StudyFile& file, const std::string& document, const std::string& output) {
    const std::string path = placeOf(file, document);
    keepFromOverwriting({path});
    if (auto possible = checkOutputs({output}); !possible) return tl::unexpected<Failure>(possible.error());
    auto study = restricted::readStudy(path, file.options);
    if (!study) return study;
    keepFromOverwriting(study->files);
    if (auto possible = checkOutputs({output}); !possible) return tl::unexpected<Failure>(possible.error());
    if (file.checksum.empty()) return study;
    const auto checksum = checksumOf(study->files);
    if (!checksum) return tl::unexpected<Failure>(checksum.error());
    if (const std::string change = changeOf(file, *checksum); !change.empty())
        std::fprintf(stderr, "%s %s: the picture may not be the one that was saved.\n", path.c_str(), change.c_str());
    return study;
}

Result<Study> studyOf(const Document& document, const std::string& path, const VolumeOptions& volume,
                      const std::string& output) {
    if (!volume.path.empty()) return volume.readAll({output});
    if (const auto* file = std::get_if<StudyFile>(&document.study)) return readReferenced(*file, path, output);
    if (const auto* scan = std::get_if<SimulatedScan>(&document.study)) return simulatedStudy(*scan);
    return fail(FailureKind::wrongUsage, path, "study", "is null: the document names no study",
                "Give the volume on the command line.");
}

}  // namespace

void DocumentOptions::addTo(CLI::App& command) {
    command
        .add_option("--document", path,
                    "A document of the workstation: renders what its view shows at rest; the study is the document's "
                    "where no VOLUME is given")
        ->type_name("FILE.json");
    command
        .add_option("--view", view,
                    "Number of the document's pane, or id of a view of version 1; the first where not given")
        ->type_name("NUMBER")
        ->needs("--document");
}

Result<void> DocumentOptions::checkAlone(const CLI::App& command) const {
    for (const CLI::Option* option : command.get_options()) {
        if (option->count() == 0) continue;
        const bool allowed = std::ranges::any_of(
            besideDocument, [&](const char* name) { return option->check_name(name) || option->get_name() == name; });
        if (!allowed)
            return wrongUsage(option->get_name(), "plays no part beside --document",
                              "Leave it out, or change the document.");
    }
    return {};
}

Result<DocumentStudy> readDocumentStudy(const std::string& path, const VolumeOptions& volume, const std::string& output,
                                        std::optional<int> number) {
    keepFromOverwriting({path});
    if (auto possible = checkOutputs({output}); !possible) return tl::unexpected<Failure>(possible.error());
    auto read = readDocumentPane(path, number);
    if (!read) return tl::unexpected<Failure>(read.error());
    Document& document = read->document;
    auto study = studyOf(document, path, volume, output);
    if (!study) return tl::unexpected<Failure>(study.error());
    document.scene =
        withFrontAcrossPose(std::move(document.scene), document.beam.axis, study->phases.front()->geometry());
    return DocumentStudy{std::move(document), std::move(*study), read->pane};
}

Result<ViewPicture> renderDocument(const DocumentOptions& options, const VolumeOptions& volume,
                                   const std::array<int, 2>& size, const std::string& output) {
    const auto read = readDocumentStudy(options.path, volume, output, options.view);
    if (!read) return tl::unexpected<Failure>(read.error());
    const Study& study = read->study;
    sayNote(burnedInTextNote(study));
    const int phase = phaseOf(read->document, read->pane);
    if (phase < 0 || phase >= static_cast<int>(study.phases.size()))
        return fail(FailureKind::wrongUsage, options.path, "phases",
                    fmt::format("shows phase {}, but the volume has {} phase(s)", phase, study.phases.size()));
    return *viewPicture(read->document, read->pane, study.phases, size[0], size[1]);
}

}  // namespace echolucent::cli
