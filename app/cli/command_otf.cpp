#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/options/designer_options.h"
#include "app/cli/options/look_options.h"
#include "app/cli/report/design_report.h"
#include "app/cli/report/otf_report.h"
#include "io/output/atomic_file.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/designers/designer.h"

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

Result<void> writeOtf(const OtfOptions& options, const Volume& volume, const AdaptiveOtf& otf, const ChosenBeam& beam) {
    if (options.json.empty() && options.csv.empty() && options.tubesCsv.empty())
        return writeFileAtomically("-", summary(volume, otf));
    if (!options.json.empty())
        if (auto done = writeFileAtomically(options.json, jsonReport(volume, otf, beam, options.method.initial,
                                                                     options.method.opacityScale.value_or(1.0)));
            !done)
            return done;
    if (!options.csv.empty())
        if (auto done = writeFileAtomically(options.csv, curveTable(otf)); !done) return done;
    if (!options.tubesCsv.empty())
        if (auto done = writeFileAtomically(options.tubesCsv, tubeTable(otf)); !done) return done;
    if (!otf.message.empty()) std::fprintf(stderr, "%s\n", otf.message.c_str());
    return {};
}

/// What a designer other than the adaptive one makes.
Result<void> writeDesign(const OtfOptions& options, const Volume& volume, const DesignRun& run,
                         const ChosenBeam& beam) {
    if (options.json.empty() && options.csv.empty()) return writeFileAtomically("-", summary(run));
    if (!options.json.empty())
        if (auto done = writeFileAtomically(options.json, jsonReport(volume, run, beam)); !done) return done;
    if (!options.csv.empty())
        if (auto done = writeFileAtomically(options.csv, curveTable(run.design)); !done) return done;
    if (!run.design.message.empty()) std::fprintf(stderr, "%s\n", run.design.message.c_str());
    return {};
}

DesignRun runOf(const DesignerConfig& designer, const DesignerInput& input) {
    const auto begin = std::chrono::steady_clock::now();
    Design made = *design(designer, input);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    return {designer, std::move(made), input.view, input.reduction, took.count()};
}

Result<void> computeOtf(const OtfOptions& options) {
    const int toStandardOutput = (options.json == "-") + (options.csv == "-") + (options.tubesCsv == "-");
    if (toStandardOutput > 1)
        return fail(FailureKind::wrongUsage, "", "",
                    "only one of --json, --csv and --tubes-csv can go to standard output");
    const std::vector<std::string> outputs{options.json, options.csv, options.tubesCsv};
    if (auto checked = checkOutputs(outputs, {options.method.initial}); !checked) return checked;
    const auto view = options.view.get();
    if (!view) return tl::unexpected<Failure>(view.error());
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
    const auto volume = options.volume.readPhase(outputs);
    if (!volume) return tl::unexpected<Failure>(volume.error());
    const ChosenBeam beam = options.view.beamOf(**volume);
    const auto cut = options.view.get(**volume, beam);
    if (!cut) return tl::unexpected<Failure>(cut.error());
    const auto quiet = quietVolume(**volume, look->reduction);
    if (!adaptive)
        return writeDesign(options, **volume, runOf(**designer, {**volume, *quiet, look->reduction, *cut, *config}),
                           beam);
    const auto otf = adaptOpacity(**volume, *cut, *config, {}, {&*quiet, look->reduction});
    return writeOtf(options, **volume, *otf, beam);
}

}  // namespace

void addOtfCommand(CLI::App& program, Action& action) {
    auto options = std::make_shared<OtfOptions>();
    CLI::App& command = *program.add_subcommand(
        "otf", "Computes an opacity transfer function of a volume: the adaptive one, or that of another designer");
    options->volume.addTo(command);
    options->view.addTo(command);
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
    command.footer("Example: echolucent-cli otf chest.mha --beam-axis +y --near 18 --json chest-otf.json");
    command.callback([options, &action] { action = [options] { return computeOtf(*options); }; });
}

}  // namespace echolucent::cli
