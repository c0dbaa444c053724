// echolucent-bench-lit: what a picture costs unlit, lit on surfaces and lit by what reaches, in high quality, as the
// program opens a volume.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/measuring/measures/picture_difference.h"
#include "io/study/study.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/document/document.h"
#include "processing/document/opening_finds.h"
#include "processing/median.h"
#include "processing/phantom/phantom.h"
#include "processing/picture/look.h"
#include "processing/picture/view_limits.h"
#include "processing/ray_caster/light_source.h"
#include "processing/ray_caster/plain/plain_caster.h"
#include "processing/ray_caster/ray_caster.h"
#include "tests/benchmarks/measured_cost.h"
#include "widgets/casting/qualities.h"

namespace {

using namespace echolucent;

enum class Light { none, surface, depth };
constexpr const char* nameOf(Light light) {
    return light == Light::none ? "unlit" : light == Light::surface ? "surface" : "depth";
}

/// What the window makes its pictures of when a file has been opened.
struct Opened {
    std::shared_ptr<const Volume> raw, quiet;
    OpacityCurve curve;
    Viewpoint view;
    Look look;
};

Opened opened(std::shared_ptr<const Volume> volume) {
    const Look look = lookAtStart();
    const Document plain;
    const Document document = withFinds(plain, *findOnOpening(*volume, {}));
    const Viewpoint view = withFrontAcross({.beamAxis = document.beam.axis}, document.scene.front.depthMm);
    auto quiet = std::make_shared<const Volume>(*quietVolume(*volume, look.reduction));
    auto curve = adaptOpacity(*volume, view, {}, {}, {quiet.get(), look.reduction})->curve;
    return {std::move(volume), std::move(quiet), std::move(curve), view, look};
}

/// High quality, seen 20 and -12 degrees off the beam and turned a little, so that no picture can use the one before.
RayCastSettings settingsOf(const Opened& opened, Light light, int edge, double turnDegrees, double tolerance = -1.0) {
    RayCastSettings settings = rayCastSettings(opened.look);
    settings.width = settings.height = edge;
    Viewpoint view = opened.view;
    view.azimuthDegrees = 20 + turnDegrees;
    view.elevationDegrees = -12;
    settings.camera = defaultCamera(opened.raw->dataBox(), view, 1.0);
    if (light == Light::none) settings.shading.reset();
    if (light == Light::surface) settings.shading = Shading{};
    settings = settingsAt(highQuality, limitedTo(view, opened.raw->geometry(), settings));
    if (tolerance >= 0.0) settings.pixelTolerance = tolerance;
    return settings;
}

struct Options {
    std::vector<int> edges{512, 1024};
    std::vector<Light> lights{Light::none, Light::surface, Light::depth};
    int runs = 9, errorEdge = 0;
    double tolerance = -1.0;
};

void printRows(const std::string& name, const Opened& opened, const Options& options) {
    RayCaster caster(opened.quiet);
    for (const int edge : options.edges)
        for (const Light light : options.lights) {
            std::vector<double> milliseconds, lit, cpu;
            // The first picture makes what a curve's pictures have in common.
            for (int run = -1; run < options.runs; ++run) {
                const RayCastSettings settings = settingsOf(opened, light, edge, 0.01 * run, options.tolerance);
                const bench::Cost cost = bench::costOf([&] { (void)*caster.cast(opened.curve, settings); });
                if (run < 0) continue;
                lit.push_back(caster.lightMilliseconds());
                milliseconds.push_back(cost.wallMs - lit.back());
                cpu.push_back(cost.cpuMs);
            }
            RayCastSettings every = settingsOf(opened, light, edge, 0.0, options.tolerance);
            const Picture some = *caster.cast(opened.curve, every);
            const double share = caster.castShare();
            every.pixelTolerance = 0.0;
            const PictureError between = pictureError(some, *castRays(*opened.quiet, opened.curve, every));
            fmt::print("| {} | {} | {} | {:.1f} | {:.1f} | {:.1f} | {:.0f} | {:.2f} | {:.1f} |", name, edge,
                       nameOf(light), medianOf(milliseconds), medianOf(lit), medianOf(cpu), 100.0 * share, between.rmse,
                       between.largest);
            if (options.errorEdge > 0) {
                const RayCastSettings settings = settingsOf(opened, light, options.errorEdge, 0.0, options.tolerance);
                const PlainCasting plain{.leastLitOpacity = ray_casting::LightSource::worthGradient * settings.step};
                const PictureError error = pictureError(*caster.cast(opened.curve, settings),
                                                        *castRaysPlainly(*opened.quiet, opened.curve, settings, plain));
                fmt::print(" {:.3f} | {:.1f} |", error.rmse, error.largest);
            }
            fmt::print("\n");
            std::fflush(stdout);
        }
}

}  // namespace

int main(int count, char** arguments) {
    Options options;
    std::vector<std::string> files;
    int phantom = 199;
    CLI::App app("Prints what a picture in high quality costs: unlit, lit on surfaces, and lit by what reaches.");
    app.add_option("files", files, "volumes; without any, a simulated fetus");
    app.add_option("--edge", phantom, "voxels along each edge of the simulated fetus; 0 for none");
    app.add_option("--sizes", options.edges, "pixels along each edge of a picture")->delimiter(',');
    app.add_option("--runs", options.runs, "pictures of each kind");
    const std::map<std::string, Light> lights{
        {"unlit", Light::none}, {"surface", Light::surface}, {"depth", Light::depth}};
    app.add_option("--lights", options.lights, "kinds of light")
        ->delimiter(',')
        ->transform(CLI::CheckedTransformer(lights));
    app.add_option("--tolerance", options.tolerance,
                   "levels by which interpolated pixels may err; else those of high quality");
    app.add_option("--error-size", options.errorEdge,
                   "pixels along each edge of a picture that is compared with the plain route");
    CLI11_PARSE(app, count, arguments);
    fmt::print(
        "| volume | pixels | light | ms but for the light volume | ms of the light volume | CPU ms | rays, % | RMSE "
        "from every pixel cast | largest |{}\n",
        options.errorEdge > 0 ? " RMSE from the plain route | largest |" : "");
    fmt::print("| --- | --- | --- | --- | --- | --- | --- | --- | --- |{}\n",
               options.errorEdge > 0 ? " --- | --- |" : "");
    if (phantom > 0) {
        PhantomConfig config = defaultPhantom(PhantomScene::fetus);
        config.size = {phantom, phantom, phantom};
        printRows("simulated fetus", opened(std::make_shared<const Volume>(*makePhantom(config))), options);
    }
    for (const std::string& file : files) {
        const auto study = readStudy(file);
        if (!study) {
            fmt::print(stderr, "{}\n", study.error().sentence());
            return 3;
        }
        printRows(std::filesystem::path(file).stem().string(), opened(study->phases.front()), options);
    }
    return 0;
}
