// `study light`: error of the light volume against its run time.
#include "app/measuring/light/study_light.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>

#include "app/measuring/study.h"
#include "io/output/atomic_file.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/phantom/phantom.h"

namespace echolucent::cli {

namespace {

struct LightStudyOptions {
    VolumeOptions volume;
    ViewOptions view;
    MethodOptions method;
    std::string otf = "adaptive", size = "128x128", output;
    int phantomSize = 100, repeats = 9, rings = 4;
};

constexpr int leastEdge = 16, largestEdge = 1024;  // pixels

/// The view lies away from every grid axis, so that no direction runs along one.
const Viewpoint oblique{.azimuthDegrees = 20, .elevationDegrees = -12};

std::shared_ptr<const Volume> phantom(PhantomScene scene, int edge) {
    PhantomConfig config = defaultPhantom(scene);
    const double extentMm = static_cast<double>(config.size[0]) * config.spacing[0];
    config.size.fill(edge);
    config.spacing = Vec3::all(extentMm / edge);
    return std::make_shared<const Volume>(*makePhantom(config));
}

Result<LightCase> caseOf(const std::string& name, std::shared_ptr<const Volume> volume,
                         const LightStudyOptions& options) {
    const auto pixels = parseWholePair(options.size, leastEdge, largestEdge, "--size", "128x128");
    if (!pixels) return tl::unexpected<Failure>(pixels.error());
    const auto config = options.method.get();
    if (!config) return tl::unexpected<Failure>(config.error());
    const auto view =
        options.view.get(*volume, options.volume.path.empty() ? options.view.beam() : options.view.beamOf(*volume));
    if (!view) return tl::unexpected<Failure>(view.error());
    const auto named = namedCurve(options.otf, options.method.opacityScale);
    if (!named) return tl::unexpected<Failure>(named.error());
    LightCase one{name, std::move(volume), PowerCurve{}, {}};
    one.curve = *named ? **named : adaptOpacity(*one.volume, *view, *config)->curve;
    const VolumeGeometry& geometry = one.volume->geometry();
    one.settings.width = (*pixels)[0];
    one.settings.height = (*pixels)[1];
    one.settings.camera = defaultCamera(geometry, *view, static_cast<double>((*pixels)[0]) / (*pixels)[1]);
    one.settings.nearPlaneDepthMm = nearPlaneDepthMm(*view, geometry);
    one.settings.shading = Shading{};
    one.settings.shading->ambient = ambientWithReachingLight;
    one.settings.shading->diffuse = diffuseWithReachingLight;
    one.settings.shading->reaching = ReachingLight{};
    return one;
}

Result<std::vector<LightCase>> casesOf(const LightStudyOptions& options, const std::vector<std::string>& outputs) {
    std::vector<LightCase> cases;
    const auto add = [&](const std::string& name, std::shared_ptr<const Volume> volume) -> Result<void> {
        auto one = caseOf(name, std::move(volume), options);
        if (!one) return tl::unexpected<Failure>(one.error());
        cases.push_back(std::move(*one));
        return {};
    };
    if (!options.volume.path.empty()) {
        const auto volume = options.volume.readPhase(outputs);
        if (!volume) return tl::unexpected<Failure>(volume.error());
        if (auto added = add(options.volume.path, *volume); !added) return tl::unexpected<Failure>(added.error());
        return cases;
    }
    for (const PhantomScene scene : {PhantomScene::fetus, PhantomScene::shapes})
        if (auto added = add("simulated " + std::string(nameOf(scene)), phantom(scene, options.phantomSize)); !added)
            return tl::unexpected<Failure>(added.error());
    return cases;
}

Result<void> studyLight(const LightStudyOptions& options) {
    if (const auto checked = options.view.get(); !checked) return tl::unexpected<Failure>(checked.error());
    const auto folder = StudyFolder::at(options.output, {"light.csv", "light.html"});
    if (!folder) return tl::unexpected<Failure>(folder.error());
    if (auto checked = checkOutputs(folder->paths(), {options.otf, options.method.initial}); !checked) return checked;
    const auto cases = casesOf(options, folder->paths());
    if (!cases) return tl::unexpected<Failure>(cases.error());
    std::vector<LightStudy> studies;
    for (const LightCase& one : *cases) studies.push_back(measureLight(one, options.repeats, options.rings));
    if (auto done = folder->write("light.csv", lightCsv(studies)); !done) return done;
    if (auto done = folder->write("light.html", lightPage(studies, options.repeats, options.rings)); !done) return done;
    return writeFileAtomically("-", lightSummary(studies));
}

}  // namespace

void addStudyLightCommand(CLI::App& study, Action& action) {
    auto options = std::make_shared<LightStudyOptions>();
    CLI::App& command = *study.add_subcommand("light", "Error of the light that reaches against its run time");
    options->volume.addTo(command);
    command.get_option("VOLUME")->required(false);
    command.add_option("-o,--output", options->output, "Folder for light.html and light.csv")
        ->type_name("DIR")
        ->required();
    command
        .add_option("--otf", options->otf,
                    "linear, parabolic, quartic, manual:FILE or adaptive (for the rendered view)")
        ->type_name("NAME")
        ->capture_default_str();
    command.add_option("--size", options->size, "Pixels")->type_name("WxH")->capture_default_str();
    command.add_option("--repeats", options->repeats, "Timed runs of each light volume; the median counts")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command
        .add_option("--rings", options->rings,
                    "The reference marches along 3 RINGS^2 directions to each of both lights")
        ->check(CLI::Range(1, 16))
        ->capture_default_str();
    command
        .add_option("--phantom-size", options->phantomSize,
                    "Voxels along each edge of the simulated scans, which stand where no VOLUME is given")
        ->check(CLI::Range(16, 512))
        ->capture_default_str();
    options->view.view = oblique;
    options->view.addTo(command);
    options->method.addTo(command);
    command.footer("Example: echolucent-cli study light -o light");
    command.callback([options, &action] { action = [options] { return studyLight(*options); }; });
}

}  // namespace echolucent::cli
