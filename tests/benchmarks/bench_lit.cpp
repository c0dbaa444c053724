// echolucent-bench-lit: what a picture in high quality costs as the program opens a volume, and what pixels between
// rays spare of it, side by side.
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
RayCastSettings settingsOf(const Opened& opened, Light light, int edge, double turnDegrees, bool everyPixel) {
    RayCastSettings settings = rayCastSettings(opened.look);
    settings.width = settings.height = edge;
    Viewpoint view = opened.view;
    view.azimuthDegrees = 20 + turnDegrees;
    view.elevationDegrees = -12;
    settings.camera = defaultCamera(opened.raw->dataBox(), view, 1.0);
    if (light == Light::none) settings.shading.reset();
    if (light == Light::surface) settings.shading = Shading{};
    settings = settingsAt(highQuality, limitedTo(view, opened.raw->geometry(), settings));
    if (everyPixel) settings.pixelTolerance = 0.0;
    return settings;
}

struct Options {
    std::vector<int> edges{512, 1024};
    std::vector<Light> lights{Light::none, Light::surface, Light::depth};
    int runs = 9, errorEdge = 0;
};

void printError(const Picture& picture, const Picture& reference) {
    const PictureError error = pictureError(picture, reference);
    fmt::print(" {:.2f}, {:.1f} |", error.rmse, error.largest);
}

/// Every pixel and pixels between rays in turn, picture by picture.
void printRow(const std::string& name, const Opened& opened, const Options& options, Light light, int edge) {
    RayCaster every(opened.quiet);
    RayCaster between = every.sharing();
    std::vector<double> everyMs, betweenMs, lightMs;
    const auto cast = [&](RayCaster& caster, bool everyPixel, double turn, std::vector<double>& milliseconds) {
        const RayCastSettings settings = settingsOf(opened, light, edge, turn, everyPixel);
        const bench::Cost cost = bench::costOf([&] { (void)*caster.cast(opened.curve, settings); });
        lightMs.push_back(caster.lightMilliseconds());
        milliseconds.push_back(cost.wallMs - lightMs.back());
    };
    const auto castBoth = [&](double turn) {
        cast(every, true, turn, everyMs);
        cast(between, false, turn, betweenMs);
    };
    // The first pictures make what a curve's pictures have in common.
    castBoth(-0.01);
    for (auto* const taken : {&everyMs, &betweenMs, &lightMs}) taken->clear();
    for (int run = 0; run < options.runs; ++run) castBoth(0.01 * run);
    const Picture picture = *every.cast(opened.curve, settingsOf(opened, light, edge, 0.0, true));
    const Picture interpolated = *between.cast(opened.curve, settingsOf(opened, light, edge, 0.0, false));
    const double first = medianOf(everyMs), last = medianOf(betweenMs);
    fmt::print("| {} | {} | {} | {:.1f} | {:.1f} | {:.2f} | {:.0f} | {:.1f} |", name, edge, nameOf(light), first, last,
               last / first, 100.0 * between.castShare(), medianOf(lightMs));
    printError(interpolated, picture);
    if (options.errorEdge > 0) {
        const RayCastSettings settings = settingsOf(opened, light, options.errorEdge, 0.0, false);
        const PlainCasting casting{.leastLitOpacity = ray_casting::LightSource::worthGradient * settings.step};
        printError(*between.cast(opened.curve, settings),
                   *castRaysPlainly(*opened.quiet, opened.curve, settings, casting));
    }
    fmt::print("\n");
    std::fflush(stdout);
}

void printRows(const std::string& name, const Opened& opened, const Options& options) {
    for (const int edge : options.edges)
        for (const Light light : options.lights) printRow(name, opened, options, light, edge);
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
    app.add_option("--error-size", options.errorEdge,
                   "pixels along each edge of a picture that is compared with the plain route");
    CLI11_PARSE(app, count, arguments);
    const bool plain = options.errorEdge > 0;
    fmt::print(
        "| volume | pixels | light | ms, every pixel | ms, pixels between rays | ratio | rays, % | ms of the light "
        "volume "
        "| err of pixels between rays (RMSE, largest) |{}\n",
        plain ? " err from the plain route |" : "");
    std::string line = "|";
    for (int column = 0; column < (plain ? 10 : 9); ++column) line += "---|";
    fmt::print("{}\n", line);
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
