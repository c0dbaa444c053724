// `study designers`: all OTF designers on simulated scans whose truth is known, or on a volume.
#include "app/measuring/designers/study_designers.h"

#include <CLI/CLI.hpp>

#include <utility>

#include "app/cli/look_options.h"
#include "app/measuring/otf/study_phantoms.h"
#include "app/measuring/study.h"
#include "io/output/atomic_file.h"
#include "processing/picture/view_limits.h"

namespace echolucent::cli {

namespace {

struct DesignersStudyOptions {
    VolumeOptions volume;
    ViewOptions view;
    MethodOptions method;
    LookOptions look;
    PhantomChoice phantoms;
    std::string output;
    int repeats = 3, pictureSize = 240;
};

DesignerCase caseOf(std::string name, std::shared_ptr<const Volume> raw, const Viewpoint& view,
                    const AdaptiveOtfConfig& method, const Look& look, int edge) {
    DesignerCase one{.name = std::move(name), .raw = std::move(raw), .reduction = look.reduction, .view = view};
    one.method = method;
    one.shown = std::make_shared<const Volume>(*quietVolume(*one.raw, look.reduction));
    one.settings = rayCastSettings(look);
    one.settings.width = one.settings.height = edge;
    one.settings.camera = defaultCamera(one.raw->dataBox(), view, 1.0);
    one.settings = limitedTo(view, one.raw->geometry(), one.settings);
    return one;
}

Result<std::vector<DesignerCase>> casesOf(const DesignersStudyOptions& options, const PhantomConfig& base,
                                          const std::vector<std::string>& outputs) {
    const auto look = options.look.get();
    if (!look) return tl::unexpected<Failure>(look.error());
    const auto method = options.method.get();
    if (!method) return tl::unexpected<Failure>(method.error());
    if (!options.volume.path.empty()) {
        const auto volume = options.volume.readPhase(outputs);
        if (!volume) return tl::unexpected<Failure>(volume.error());
        const auto view = options.view.get(**volume);
        if (!view) return tl::unexpected<Failure>(view.error());
        return std::vector{caseOf("the volume", *volume, *view, *method, *look, options.pictureSize)};
    }
    const auto view = options.view.getOfSimulatedScan();
    if (!view) return tl::unexpected<Failure>(view.error());
    std::vector<DesignerCase> cases;
    for (const PhantomScene scene : {PhantomScene::fetus, PhantomScene::shapes}) {
        PhantomConfig config = defaultPhantom(scene);
        config.size = base.size;
        config.seed = base.seed;
        cases.push_back(caseOf("simulated " + std::string(nameOf(scene)),
                               std::make_shared<const Volume>(*makePhantom(config)), *view, *method, *look,
                               options.pictureSize));
    }
    return cases;
}

Result<void> studyDesigners(const DesignersStudyOptions& options) {
    const auto bases = options.phantoms.bases();
    if (!bases) return tl::unexpected<Failure>(bases.error());
    const auto folder = StudyFolder::at(options.output, {"designers.csv", "designers.html"});
    if (!folder) return tl::unexpected<Failure>(folder.error());
    if (auto checked = checkOutputs(folder->paths(), {options.method.initial}); !checked) return checked;
    const auto cases = casesOf(options, bases->front(), folder->paths());
    if (!cases) return tl::unexpected<Failure>(cases.error());
    DesignersStudy study{
        .seeds = options.phantoms.seeds, .reduction = cases->front().reduction, .repeats = options.repeats};
    if (options.volume.path.empty())
        for (const PhantomConfig& base : *bases)
            for (ContrastRow& row :
                 measureContrasts(base, {cases->front().view, cases->front().method, study.reduction, options.repeats}))
                study.contrasts.push_back(std::move(row));
    for (const DesignerCase& one : *cases) study.shown.push_back({one.name, showDesigners(one, options.repeats)});
    if (auto done = folder->write("designers.csv", designersCsv(study)); !done) return done;
    if (auto done = folder->write("designers.html", designersPage(study)); !done) return done;
    return writeFileAtomically("-", designersSummary(study));
}

}  // namespace

void addStudyDesignersCommand(CLI::App& study, Action& action) {
    auto options = std::make_shared<DesignersStudyOptions>();
    CLI::App& command = *study.add_subcommand("designers", "All OTF designers side by side: pictures, contrast, time");
    options->volume.addTo(command);
    command.get_option("VOLUME")->required(false);
    command.add_option("-o,--output", options->output, "Folder for designers.html and designers.csv")
        ->type_name("DIR")
        ->required();
    options->phantoms.addTo(command);
    command.add_option("--repeats", options->repeats, "Timed runs of each designer and picture; the median counts")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command.add_option("--picture-size", options->pictureSize, "Pixels along each edge of the pictures")
        ->check(CLI::Range(16, 1024))
        ->capture_default_str();
    options->view.addTo(command);
    options->method.addTo(command);
    options->look.addTo(command, {"reduction", "lighting"});
    command.footer("Example: echolucent-cli study designers -o designers");
    command.callback([options, &action] { action = [options] { return studyDesigners(*options); }; });
}

}  // namespace echolucent::cli
