#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "app/cli/command.h"
#include "app/cli/options/document_study.h"
#include "app/cli/options/option_text.h"
#include "app/cli/options/volume_options.h"
#include "io/output/atomic_file.h"
#include "processing/document/panes.h"
#include "processing/pane_picture/pane_measures.h"

namespace echolucent::cli {

namespace {

struct CompareOptions {
    std::string document, csv = "-";
};

/// The cells of a pane's row that stand before its measures.
std::string paneCells(const Document& document, std::size_t place) {
    const Pane& pane = document.panes.at(place);
    const DesignerConfig* config = designerConfigOf(document, place);
    std::string tubes;
    for (const int tube : pane.withoutTubes) tubes += fmt::format("{}{}", tubes.empty() ? "" : " ", tube);
    return fmt::format("{},{},{},{},{}", place + 1, config != nullptr ? "designer" : "curve",
                       config != nullptr ? echolucent::nameOf(designerOf(*config)) : echolucent::nameOf(pane.curve),
                       tubes, phaseOf(document, place));
}

/// The cells of a pane's measures; empty cells if there are none.
std::string measureCells(const std::optional<PaneMeasures>& measured) {
    if (!measured) return ",,,,,";
    const ClassificationMeasures& measures = measured->measures;
    const auto percent = [&](ShownSurface shown) { return 100.0 * measures.depth.share(shown).value_or(0.0); };
    const auto contrast = measures.contrast.contrastToNoise();
    return fmt::format("{},{},{},{},{},{}", percent(ShownSurface::right), percent(ShownSurface::early),
                       percent(ShownSurface::late), percent(ShownSurface::never),
                       contrast ? fmt::format("{}", *contrast) : "", measures.light.meanShare);
}

/// Says with which surfaces the panes were measured.
std::string sentenceOf(const std::vector<std::optional<PaneMeasures>>& measured) {
    for (const auto& one : measured)
        if (one) return std::string(surfacesSentence(one->from));
    return "Nothing was measured: no surface is known in this view.";
}

Result<void> compare(const CompareOptions& options) {
    const auto read =
        readDocumentStudy(options.document, VolumeOptions{}, {options.csv}, 1,
                          "Compare OTFs of the volume in the window (F5), save the session, and name that file here.");
    if (!read) return tl::unexpected<Failure>(read.error());
    const Document& document = read->document;
    const std::size_t panes = document.panes.size();
    if (!isCompared(document))
        return fail(FailureKind::wrongUsage, options.document, "panes", "are one only: the document compares nothing",
                    "Save a session of the workstation while OTFs are compared (F5).");
    for (std::size_t pane = 0; pane < panes; ++pane)
        if (phaseOf(document, pane) >= static_cast<int>(read->study.phases.size()))
            return fail(FailureKind::wrongUsage, options.document, "phases",
                        fmt::format("shows phase {}, but the volume has {} phase(s)", phaseOf(document, pane),
                                    read->study.phases.size()));
    const auto measured = *measuresOfPanes(document, {.scans = read->study.phases});
    std::string table =
        "pane,kind,otf,without_tubes,phase,right_percent,early_percent,late_percent,never_percent,cnr_s,"
        "light_near_surfaces\n";
    for (std::size_t place = 0; place < panes; ++place) {
        table += paneCells(document, place) + "," + measureCells(measured[place]) + "\n";
    }
    if (auto written = writeFileAtomically(options.csv, table); !written) return written;
    // The table itself may go to standard output.
    std::fprintf(stderr, "%s\n", sentenceOf(measured).c_str());
    return {};
}

}  // namespace

void addCompareCommand(CLI::App& program, Action& action) {
    auto options = std::make_shared<CompareOptions>();
    CLI::App& command = *program.add_subcommand(
        "compare", "Measures the OTFs that a document of the workstation compares, as the window's table does");
    command.add_option("DOCUMENT", options->document, "A document or session that compares OTFs")->required();
    command.add_option("--csv", options->csv, "One row a pane; - is standard output")
        ->type_name("FILE")
        ->capture_default_str();
    command.footer("Example: echolucent-cli compare lesson.json --csv lesson.csv");
    command.callback([options, &action] { action = [options] { return compare(*options); }; });
}

}  // namespace echolucent::cli
