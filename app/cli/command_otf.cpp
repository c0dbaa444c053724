#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>
#include <variant>

#include "app/cli/command.h"
#include "app/cli/options/designer_options.h"
#include "app/cli/options/document_study.h"
#include "app/cli/options/look_options.h"
#include "app/cli/options/method_options.h"
#include "app/cli/options/option_text.h"
#include "app/cli/options/view_options.h"
#include "app/cli/options/volume_options.h"
#include "app/cli/report/design_report.h"
#include "app/cli/report/explanation_report.h"
#include "app/cli/report/opening_report.h"
#include "app/cli/report/otf_report.h"
#include "app/pages/explanation_page.h"
#include "io/output/atomic_file.h"
#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/designers/choice/designer.h"
#include "processing/document/panes.h"
#include "processing/explanation/tube_explanation.h"
#include "processing/pane_picture/pane_caster.h"

namespace echolucent::cli {

namespace {

struct OtfOptions {
    VolumeOptions volume;
    DocumentOptions document;
    ViewOptions view;
    MethodOptions method;
    LookOptions look;
    DesignerOptions designer;
    std::string json, csv, tubesCsv, page;
    std::optional<int> explain;
};

/// A tube core that is explained, and the page if one is asked for.
struct Explained {
    TubeExplanation explanation;
    std::string page;
};

Result<void> writeOtf(const OtfOptions& options, const Volume& volume, const AdaptiveOtf& otf,
                      const OtfContext& context, const std::optional<Explained>& explained) {
    if (options.json.empty() && options.csv.empty() && options.tubesCsv.empty() && options.page.empty())
        return writeFileAtomically(
            "-", summary(volume, otf) + (explained ? summary(explained->explanation) : std::string()));
    if (!options.page.empty())
        if (auto done = writeFileAtomically(options.page, explained->page); !done) return done;
    if (!options.json.empty())
        if (auto done = writeFileAtomically(options.json, jsonReport(volume, otf, context)); !done) return done;
    if (!options.csv.empty())
        if (auto done = writeFileAtomically(options.csv, curveTable(otf)); !done) return done;
    if (!options.tubesCsv.empty())
        if (auto done = writeFileAtomically(options.tubesCsv, tubeTable(otf)); !done) return done;
    sayNote(otf.message);
    return {};
}

/// Writes the OTF of a designer other than the adaptive one. Without --json and --csv it writes a summary to standard
/// output.
Result<void> writeDesign(const OtfOptions& options, const Volume& volume, const DesignRun& run,
                         const OtfContext& context) {
    if (options.json.empty() && options.csv.empty()) return writeFileAtomically("-", summary(run));
    if (!options.json.empty())
        if (auto done = writeFileAtomically(options.json, jsonReport(volume, run, context)); !done) return done;
    if (!options.csv.empty())
        if (auto done = writeFileAtomically(options.csv, curveTable(run.design)); !done) return done;
    sayNote(run.design.message);
    return {};
}

double millisecondsSince(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

DesignRun runOf(const DesignerConfig& designer, const DesignerInput& input) {
    const auto begin = std::chrono::steady_clock::now();
    Design made = *design(designer, input);
    return {designer, std::move(made), input.view, input.reduction, millisecondsSince(begin)};
}

Result<void> checkOtfOutputs(const OtfOptions& options, const std::vector<std::string>& outputs) {
    if (std::ranges::count(outputs, "-") > 1)
        return fail(FailureKind::wrongUsage, "", "",
                    "only one of --json, --csv, --tubes-csv and --page can go to standard output");
    if (!options.page.empty() && !options.explain)
        return wrongUsage("--page", "plays no part without --explain", "Name a tube core with --explain.");
    if (options.explain && options.json.empty() && options.page.empty() &&
        !(options.csv.empty() && options.tubesCsv.empty()))
        return wrongUsage("--explain", "plays no part in tables", "Write it with --json or --page.");
    return checkOutputs(outputs, {options.method.initial});
}

/// Fails (wrong usage) if --tubes-csv or --explain is given and the designer is not the adaptive one. Only that one
/// makes its OTF from tube cores alone. The refusal puts `says` before the designer's name: "--designer".
Result<void> checkTubes(const OtfOptions& options, const DesignerConfig* designer, const std::string& says) {
    if (designer == nullptr || std::holds_alternative<AdaptiveConfig>(*designer)) return {};
    if (options.tubesCsv.empty() && !options.explain) return {};
    return wrongUsage(options.explain ? "--explain" : "--tubes-csv",
                      "plays no part beside " + says + " " + std::string(nameOf(designerOf(*designer))),
                      "Leave it out: only the adaptive OTF comes from tube cores alone.");
}

/// The study of VOLUME, opened, and its document as the options edit it.
Result<DocumentStudy> openedForOtf(const OtfOptions& options, const std::vector<std::string>& outputs) {
    const auto config = options.method.get();
    if (!config) return tl::unexpected<Failure>(config.error());
    const auto designer = options.designer.get();
    if (!designer) return tl::unexpected<Failure>(designer.error());
    if (auto checked = checkTubes(options, *designer ? &**designer : nullptr, "--designer"); !checked)
        return tl::unexpected<Failure>(checked.error());
    const auto look = options.look.get();
    if (!look) return tl::unexpected<Failure>(look.error());
    auto opened = openStudy(options.volume, options.view, *look, outputs, 1.0);
    if (!opened) return opened;
    sayNote(findsText(*opened));
    opened->document = withMethod(std::move(opened->document), *config);
    if (*designer) opened->document = withDesigner(std::move(opened->document), firstPane, **designer);
    return opened;
}

/// Reads --document and its study. Fails (wrong usage) if the pane is rendered with a curve other than the adaptive
/// one, and as checkTubes() does.
Result<DocumentStudy> documentForOtf(const OtfOptions& options, const std::vector<std::string>& outputs) {
    auto read = readDocumentStudy(options.document.path, options.volume, outputs, options.document.view);
    if (!read) return read;
    const DesignerConfig* designer = designerConfigOf(read->document, read->pane);
    if (designer == nullptr && !isAdaptive(read->document.panes.at(read->pane)))
        return fail(FailureKind::wrongUsage, options.document.path, "panes",
                    fmt::format("renders pane {} with the curve {}, which is not computed", read->pane + 1,
                                otfNameOf(read->document, read->pane)),
                    "Name another pane with --view.");
    if (auto checked = checkTubes(options, designer, "a document that renders with"); !checked)
        return tl::unexpected<Failure>(checked.error());
    return read;
}

/// The name of the initial function, as the report gives it. Of a document's manual curve it is "manual" alone: a
/// document does not say from which file that curve was read.
std::string initialNameOf(const OtfOptions& options, const Document& document) {
    return options.document.path.empty() ? options.method.initial : std::string(nameOf(document.method.initial));
}

/// The picture of a pane with a curve in the place of its own, and its caption. It is rendered directly: other modes
/// have no curve.
std::pair<Picture, std::string> pictureOf(const SampledCurve& curve, const DocumentStudy& made, PaneCaster& caster,
                                          std::string caption) {
    constexpr int side = 300;
    PaneOtf otf{.curve = curve};
    if (designerConfigOf(made.document, made.pane) != nullptr) otf.designed = Classification(curve);
    Document document = made.document;
    document.scene.look.mode = RenderMode::direct;
    return {caster.pictureWith(otf, document, made.pane, side, side, {}, PictureQuality::quick)->picture,
            std::move(caption)};
}

/// Explains the tube core of --explain, if it is given. Fails (wrong usage) if the grid does not hold it.
Result<std::optional<Explained>> explainedOf(const OtfOptions& options, const DocumentStudy& made, PaneCaster& caster,
                                             const PaneCaster::OtfVoxels& voxels, const AdaptiveOtf& otf,
                                             const std::string& program) {
    if (!options.explain) return std::nullopt;
    const int number = *options.explain;
    const TubeGrid& grid = otf.config.grid;
    if (number < 0 || number >= grid.columns * grid.rows)
        return wrongUsage("--explain", fmt::format("must be 0 to {} in a grid of {}x{} tube cores, not {}",
                                                   grid.columns * grid.rows - 1, grid.columns, grid.rows, number));
    const SpeckleReduction reduction = otf.reduction;
    const QuietVoxels shown =
        reduction == SpeckleReduction::off ? QuietVoxels{} : QuietVoxels{voxels.shown.get(), reduction};
    Explained explained{*explainTube(*voxels.raw, shown, otf, number), {}};
    if (options.page.empty()) return explained;
    const TubeExplanation& of = explained.explanation;
    const ExplanationPage page{.scan = shownStudyName(made),
                               .program = program,
                               .pictures = {pictureOf(of.full.curve, made, caster, "All tube cores"),
                                            pictureOf(of.without.curve, made, caster, "Without this one"),
                                            pictureOf(of.alone.curve, made, caster, "This one alone")},
                               .lighting = made.document.scene.look.lighting,
                               .phase = otfPhaseOf(made.document, made.pane, caster.phaseCount()),
                               .phases = caster.phaseCount()};
    explained.page = explanationPage(page, of, otf);
    return explained;
}

/// Computes and writes the OTF that a pane of the document is rendered with.
Result<void> computeOtf(const OtfOptions& options, const CLI::App& command, const Invocation& invocation) {
    const std::vector<std::string> outputs{options.json, options.csv, options.tubesCsv, options.page};
    if (auto checked = checkOtfOutputs(options, outputs); !checked) return checked;
    if (auto checked = options.document.check(command, {"--json", "--csv", "--tubes-csv", "--explain", "--page"});
        !checked)
        return checked;
    const auto made = options.document.path.empty() ? openedForOtf(options, outputs) : documentForOtf(options, outputs);
    if (!made) return tl::unexpected<Failure>(made.error());

    const Document& document = made->document;
    const std::size_t pane = made->pane;
    OtfContext context{.madeOf = {},
                       .beam = beamOf(*made),
                       .initialName = initialNameOf(options, document),
                       .manualFactor = options.method.opacityScale.value_or(1.0),
                       .adjustment = document.curves.adjustment,
                       .findingMilliseconds = made->findingMilliseconds};
    if (!options.json.empty()) {
        auto of = madeOf(invocation, *made);
        if (!of) return tl::unexpected<Failure>(of.error());
        context.madeOf = *std::move(of);
    }
    PaneCaster caster({.scans = made->study.phases});
    const auto begin = std::chrono::steady_clock::now();
    const auto voxels = *caster.otfVoxels(document, pane);
    context.quieteningMilliseconds = millisecondsSince(begin);
    if (isAdaptive(document.panes.at(pane))) {
        AdaptiveOtf otf = caster.readTubeCores(document, pane)->otf;
        const auto explained = explainedOf(options, *made, caster, voxels, otf, invocation.program);
        if (!explained) return tl::unexpected<Failure>(explained.error());
        if (*explained && !options.json.empty()) context.explanation = explanationJson((*explained)->explanation, otf);
        if (context.adjustment != CurveAdjustment{})
            otf.curve.opacities = sampledOpacities(adjusted(otf.curve, context.adjustment), AdaptiveOtf::sampleCount);
        return writeOtf(options, *voxels.raw, otf, context, *explained);
    }
    DesignRun run = runOf(*designerConfigOf(document, pane),
                          designerInputOf(document, pane, *voxels.raw, *voxels.shown, document.scene.look.reduction));
    run.design.classification = adjustedClassification(run.design.classification, context.adjustment);
    return writeDesign(options, *voxels.raw, run, context);
}

}  // namespace

void addOtfCommand(CLI::App& program, Action& action, const Invocation& invocation) {
    auto options = std::make_shared<OtfOptions>();
    CLI::App& command = *program.add_subcommand(
        "otf", "Computes an opacity transfer function of a volume: the adaptive one, or that of another designer");
    options->volume.addTo(command);
    options->document.addTo(command, "computes the OTF that a pane of it is rendered with");
    options->view.addTo(command, ViewOf::openedStudy);
    options->method.addTo(command);
    options->look.addTo(command, {"reduction"});
    options->designer.addTo(command);
    command.add_option("--json", options->json, "Everything as JSON (docs/cli-otf.md); - is standard output")
        ->type_name("FILE");
    command
        .add_option("--csv", options->csv,
                    "The curve: intensity,opacity,log_opacity,initial_opacity; of other designers without the last two")
        ->type_name("FILE");
    command.add_option("--tubes-csv", options->tubesCsv, "The tube cores, one a row")->type_name("FILE");
    command
        .add_option("--explain", options->explain,
                    "Explains one tube core, by index: row * columns + column, both counted from 0")
        ->type_name("N");
    command.add_option("--page", options->page, "The tube core of --explain as a page of HTML with plots and pictures")
        ->type_name("FILE");
    command.footer("Example: echolucent-cli otf chest.mha --json chest-otf.json");
    command.callback([options, &command, &action, invocation] {
        action = [options, &command, invocation] { return computeOtf(*options, command, invocation); };
    });
}

}  // namespace echolucent::cli
