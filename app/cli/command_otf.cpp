#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/options/designer_options.h"
#include "app/cli/options/look_options.h"
#include "app/cli/options/method_options.h"
#include "app/cli/options/option_text.h"
#include "app/cli/options/view_options.h"
#include "app/cli/options/volume_options.h"
#include "app/cli/report/design_report.h"
#include "app/cli/report/opening_report.h"
#include "app/cli/report/otf_report.h"
#include "io/output/atomic_file.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/designers/choice/designer.h"
#include "processing/pane_picture/pane_caster.h"

namespace echolucent::cli {

namespace {

struct OtfOptions {
    VolumeOptions volume;
    ViewOptions view;
    MethodOptions method;
    LookOptions look;
    DesignerOptions designer;
    std::string json, csv, tubesCsv;
};

Result<void> writeOtf(const OtfOptions& options, const Volume& volume, const AdaptiveOtf& otf,
                      const OtfContext& context) {
    if (options.json.empty() && options.csv.empty() && options.tubesCsv.empty())
        return writeFileAtomically("-", summary(volume, otf));
    if (!options.json.empty())
        if (auto done = writeFileAtomically(options.json, jsonReport(volume, otf, context, options.method.initial,
                                                                     options.method.opacityScale.value_or(1.0)));
            !done)
            return done;
    if (!options.csv.empty())
        if (auto done = writeFileAtomically(options.csv, curveTable(otf)); !done) return done;
    if (!options.tubesCsv.empty())
        if (auto done = writeFileAtomically(options.tubesCsv, tubeTable(otf)); !done) return done;
    sayNote(otf.message);
    return {};
}

/// What a designer other than the adaptive one makes.
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
                    "only one of --json, --csv and --tubes-csv can go to standard output");
    return checkOutputs(outputs, {options.method.initial});
}

/// The OTF that the first pane of the document is rendered with.
Result<void> computeOtf(const OtfOptions& options, const Invocation& invocation) {
    const std::vector<std::string> outputs{options.json, options.csv, options.tubesCsv};
    if (auto checked = checkOtfOutputs(options, outputs); !checked) return checked;
    const auto config = options.method.get();
    if (!config) return tl::unexpected<Failure>(config.error());
    const auto designer = options.designer.get();
    if (!designer) return tl::unexpected<Failure>(designer.error());
    const bool adaptive = !*designer || designerOf(**designer) == Designer::adaptive;
    if (!adaptive && !options.tubesCsv.empty())
        return wrongUsage("--tubes-csv", "plays no part beside --designer " + options.designer.name,
                          "Leave it out: only the adaptive OTF comes from tube cores alone.");
    const auto look = options.look.get();
    if (!look) return tl::unexpected<Failure>(look.error());
    const auto opened = openStudy(options.volume, options.view, *look, outputs, 1.0);
    if (!opened) return tl::unexpected<Failure>(opened.error());
    sayNote(findsText(*opened));

    const Document document = withMethod(opened->document, *config);
    const Volume& volume = *opened->study.phases[static_cast<std::size_t>(document.scene.phase)];
    OtfContext context{.madeOf = {}, .beam = beamOf(*opened), .findingMilliseconds = opened->findingMilliseconds};
    if (!options.json.empty()) {
        auto made = madeOf(invocation, *opened);
        if (!made) return tl::unexpected<Failure>(made.error());
        context.madeOf = *std::move(made);
    }
    const auto begin = std::chrono::steady_clock::now();
    const Volume quiet = *quietVolume(volume, look->reduction);
    context.quieteningMilliseconds = millisecondsSince(begin);
    const DesignerInput input = designerInputOf(document, firstPane, volume, quiet, look->reduction);
    if (!adaptive) return writeDesign(options, volume, runOf(**designer, input), context);
    const auto otf = adaptOpacity(volume, input.view, input.method, {}, {&quiet, look->reduction});
    return writeOtf(options, volume, *otf, context);
}

}  // namespace

void addOtfCommand(CLI::App& program, Action& action, const Invocation& invocation) {
    auto options = std::make_shared<OtfOptions>();
    CLI::App& command = *program.add_subcommand(
        "otf", "Computes an opacity transfer function of a volume: the adaptive one, or that of another designer");
    options->volume.addTo(command);
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
    command.footer("Example: echolucent-cli otf chest.mha --json chest-otf.json");
    command.callback([options, &action, invocation] {
        action = [options, invocation] { return computeOtf(*options, invocation); };
    });
}

}  // namespace echolucent::cli
