// `study render`: error against run time of the ray caster.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>

#include "app/measuring/render/study_render.h"
#include "app/measuring/study.h"
#include "io/output/atomic_file.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/phantom/phantom.h"

namespace echolucent::cli {

namespace {

struct RenderStudyOptions {
    VolumeOptions volume;
    ViewOptions view;
    MethodOptions method;
    std::string otf = "adaptive", size, output;
    int phantomSize = 0;  ///< 0: the usual size
    std::optional<int> repeats;
    bool shade = false, quick = false;
};

constexpr int usualRepeats = 9, quickRepeats = 3;
constexpr int leastEdge = 16, largestEdge = 2048;  // pixels

/// The view lies away from every grid axis, so that samples lie between voxel centres.
const Viewpoint oblique{.azimuthDegrees = 20, .elevationDegrees = -12};

Result<RayCastSettings> referenceSettings(const RenderStudyOptions& options) {
    const std::string text = !options.size.empty() ? options.size : options.quick ? "160x160" : "512x512";
    const auto size = parseWholePair(text, leastEdge, largestEdge, "--size", "512x512");
    if (!size) return tl::unexpected<Failure>(size.error());
    RayCastSettings settings;
    settings.width = (*size)[0];
    settings.height = (*size)[1];
    if (options.shade) settings.shading = Shading{};
    return settings;
}

std::shared_ptr<const Volume> phantom(int edge) {
    PhantomConfig config = defaultPhantom(PhantomScene::fetus);
    if (edge > 0) {
        const double extentMm = static_cast<double>(config.size[0]) * config.spacing[0];
        config.size.fill(edge);
        config.spacing = Vec3::all(extentMm / edge);
    }
    return std::make_shared<const Volume>(*makePhantom(config));
}

std::string subjectOf(const RenderStudyOptions& options, const Volume& volume, const Viewpoint& view) {
    const auto& size = volume.geometry().size;
    return fmt::format(
        "{} ({}x{}x{} voxels, {}), beam axis {}, azimuth {:g}°, elevation {:g}°, near cut {:g} mm, parallel "
        "projection, "
        "opacity curve {}{}, {}.",
        options.volume.path.empty() ? "The simulated fetus" : options.volume.path, size[0], size[1], size[2],
        volume.typeName(), nameOf(view.beamAxis), view.azimuthDegrees, view.elevationDegrees, view.nearCutMm,
        options.otf, options.method.opacityScale ? fmt::format(" of scale {:g}", *options.method.opacityScale) : "",
        options.shade ? "shaded" : "unshaded");
}

Result<void> studyRendering(const RenderStudyOptions& options) {
    if (const auto checked = options.view.get(); !checked) return tl::unexpected<Failure>(checked.error());
    const auto config = options.method.get();
    if (!config) return tl::unexpected<Failure>(config.error());
    const auto named = namedCurve(options.otf, options.method.opacityScale);
    if (!named) return tl::unexpected<Failure>(named.error());
    const auto settings = referenceSettings(options);
    if (!settings) return tl::unexpected<Failure>(settings.error());

    const auto folder = StudyFolder::at(options.output, {"render.csv", "render-pareto.svg", "render.html"});
    if (!folder) return tl::unexpected<Failure>(folder.error());
    if (auto checked = checkOutputs(folder->paths(), {options.otf, options.method.initial}); !checked) return checked;
    RenderCase one{nullptr, PowerCurve{}, *settings};
    if (options.volume.path.empty()) {
        one.volume = phantom(options.phantomSize);
    } else {
        const auto volume = options.volume.readPhase(folder->paths());
        if (!volume) return tl::unexpected<Failure>(volume.error());
        one.volume = *volume;
    }
    const auto view = options.view.get(
        *one.volume, options.volume.path.empty() ? options.view.beam() : options.view.beamOf(*one.volume));
    if (!view) return tl::unexpected<Failure>(view.error());
    const VolumeGeometry& geometry = one.volume->geometry();
    one.reference.camera =
        defaultCamera(one.volume->dataBox(), *view, static_cast<double>(settings->width) / settings->height);
    one.reference.nearPlaneDepthMm = nearPlaneDepthMm(*view, geometry);
    if (*named) {
        one.curve = **named;
    } else {
        const auto otf = adaptOpacity(*one.volume, *view, *config);
        if (!otf->message.empty()) std::fprintf(stderr, "%s\n", otf->message.c_str());
        one.curve = otf->curve;
    }

    RenderStudy study = measureRendering(one, options.repeats.value_or(options.quick ? quickRepeats : usualRepeats));
    study.subject =
        subjectOf(options, *one.volume, *view) + fmt::format(" Pictures of {}x{} pixels.", study.width, study.height);
    if (auto done = folder->write("render.csv", renderCsv(study)); !done) return done;
    if (auto done = folder->write("render-pareto.svg", svgOf(frontPlot(study))); !done) return done;
    if (auto done = folder->write("render.html", renderPage(study, one)); !done) return done;
    return writeFileAtomically("-", summaryText(study));
}

}  // namespace

void addStudyRenderCommand(CLI::App& study, Action& action) {
    auto options = std::make_shared<RenderStudyOptions>();
    CLI::App& command = *study.add_subcommand("render", "Error of the ray caster's pictures against their run time");
    options->volume.addTo(command);
    command.get_option("VOLUME")->required(false);
    command.add_option("-o,--output", options->output, "Folder for render.html, its plot and the table")
        ->type_name("DIR")
        ->required();
    command
        .add_option("--otf", options->otf,
                    "linear, parabolic, quartic, manual:FILE or adaptive (for the rendered view)")
        ->type_name("NAME")
        ->capture_default_str();
    command.add_option("--size", options->size, "Pixels [512x512; 160x160 with --quick]")->type_name("WxH");
    command.add_flag("--shade", options->shade, "Gradient shading: light from the upper left in front");
    command.add_option("--repeats", options->repeats, "Runs of each setting; the median counts [9; 3 with --quick]")
        ->check(CLI::Range(1, 1000));
    command
        .add_option("--phantom-size", options->phantomSize,
                    "Voxels along each edge of the simulated fetus, which stands where no VOLUME is given "
                    "[199x197x199]")
        ->check(CLI::Range(16, 512));
    command.add_flag("--quick", options->quick, "Small pictures and few runs: for a look, not for figures");
    options->view.view = oblique;
    options->view.addTo(command);
    options->method.addTo(command);
    command.footer("Example: echolucent-cli study render heart.nrrd --beam-axis +y --near 110 -o render");
    command.callback([options, &action] { action = [options] { return studyRendering(*options); }; });
}

}  // namespace echolucent::cli
