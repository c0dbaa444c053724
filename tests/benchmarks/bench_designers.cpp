// This measures how long pictures of each designer's OTF take while a volume is orbited, lit, at each quality.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "io/study/study.h"
#include "processing/designers/choice/designer.h"
#include "processing/document/document.h"
#include "processing/document/opening_finds.h"
#include "processing/median.h"
#include "processing/phantom/phantom.h"
#include "processing/picture/look.h"
#include "processing/picture/view_limits.h"
#include "processing/ray_caster/ray_caster.h"
#include "widgets/casting/qualities.h"

namespace {

using namespace echolucent;

struct Plan {
    std::vector<std::string> files;
    int edge = 512, frames = 15;
    double framesASecond = 15.0;
    bool flat = false;
};

/// What the window makes its pictures of when a file has been opened.
struct Opened {
    std::shared_ptr<const Volume> raw, quiet;
    SpeckleReduction reduction;
    Viewpoint view;
    RayCastSettings settings;  ///< as settingsAt() takes them
};

Opened opened(std::shared_ptr<const Volume> volume, const Plan& plan) {
    Look look = lookAtStart();
    if (plan.flat) look.lighting = Lighting::flat;
    const Document plain;
    const Document document = withFinds(plain, *findOnOpening(*volume, {}));
    Opened made{.raw = std::move(volume), .quiet = {}, .reduction = look.reduction, .view = {}, .settings = {}};
    made.view = withFrontAcross({.beamAxis = document.beam.axis}, document.scene.front.depthMm);
    made.quiet = std::make_shared<const Volume>(*quietVolume(*made.raw, look.reduction));
    made.settings = rayCastSettings(look);
    made.settings.width = made.settings.height = plan.edge;
    made.settings = limitedTo(made.view, made.raw->geometry(), made.settings);
    return made;
}

/// Median of a frame of an orbit by a degree a frame, ms.
double frameTime(RayCaster& caster, const Classification& otf, const Opened& one, std::size_t quality, int frames) {
    std::vector<double> times;
    for (int frame = 0; frame <= frames; ++frame) {
        RayCastSettings settings = settingsAt(quality, one.settings);
        Viewpoint view = one.view;
        view.azimuthDegrees = 20.0 + frame;
        view.elevationDegrees = -12.0;
        settings.camera = defaultCamera(one.raw->dataBox(), view, 1.0);
        const auto begin = std::chrono::steady_clock::now();
        (void)caster.cast(otf, settings);
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
        if (frame > 0) times.push_back(took.count());
    }
    return medianOf(std::move(times));
}

std::string wordsOf(std::size_t quality) {
    const Quality& one = qualities.at(quality);
    if (one.reduction > 1.0) return fmt::format("step {:g}, every {:g} pixels", one.step, one.reduction);
    return fmt::format("step {:g}", one.step);
}

void printRow(const std::string& volume, const std::string& name, const Design& made, const Opened& one,
              const RayCaster& packed, const Plan& plan) {
    RayCaster caster = packed.sharing();
    std::string cells, finest;
    for (std::size_t quality = highQuality; quality < qualities.size(); ++quality) {
        const double milliseconds = frameTime(caster, made.classification, one, quality, plan.frames);
        cells += fmt::format(" {:.1f} |", milliseconds);
        if (finest.empty() && 1000.0 / milliseconds >= plan.framesASecond)
            finest = fmt::format("{} ({:.0f}/s)", wordsOf(quality), 1000.0 / milliseconds);
    }
    fmt::print("| {} | {} | {} |{} {} |\n", volume, name, made.classification.isTwoDimensional() ? 2 : 1, cells,
               finest.empty() ? "none" : finest);
    std::fflush(stdout);
}

void printRows(const std::string& volume, std::shared_ptr<const Volume> voxels, const Plan& plan) {
    const Opened one = opened(std::move(voxels), plan);
    const RayCaster packed(one.quiet);
    const DesignerInput input{*one.raw, *one.quiet, one.reduction, one.view, {}};
    printRow(volume, "x2", Design{PowerCurve{2, 1.0}}, one, packed, plan);
    for (const Designer designer : allDesigners)
        printRow(volume, std::string(nameOf(designer)), *design(defaultConfigOf(designer), input), one, packed, plan);
    LevoyConfig boundaries;
    boundaries.form = LevoyForm::boundaries;
    printRow(volume, "levoy, boundaries", *design(boundaries, input), one, packed, plan);
    KindlmannConfig two;
    two.dimensions = KindlmannDimensions::two;
    printRow(volume, "kindlmann, two-dimensional", *design(two, input), one, packed, plan);
}

}  // namespace

int main(int count, char** arguments) {
    CLI::App app(
        "Prints ms of a lit picture of each designer's OTF while the volume is orbited, at each quality, and the "
        "finest quality that is fluent; rows of a Markdown table");
    Plan plan;
    app.add_option("FILE", plan.files, "Volumes; a small simulated fetus where none is given");
    app.add_option("--edge", plan.edge, "Pixels along each edge")->check(CLI::Range(16, 4096))->capture_default_str();
    app.add_option("--frames", plan.frames, "Frames that are timed")->check(CLI::Range(1, 1000))->capture_default_str();
    app.add_option("--fluent", plan.framesASecond, "Frames a second that count as fluent")->capture_default_str();
    app.add_flag("--flat", plan.flat, "Without light");
    CLI11_PARSE(app, count, arguments);
    std::string head = "| volume | designer | dimensions |", line = "| --- | --- | --- |";
    for (std::size_t quality = highQuality; quality < qualities.size(); ++quality) {
        head += " " + wordsOf(quality) + " |";
        line += " --- |";
    }
    fmt::print("{} finest that is fluent |\n{} --- |\n", head, line);
    if (plan.files.empty()) {
        PhantomConfig config = defaultPhantom(PhantomScene::fetus);
        config.size = {64, 64, 64};
        printRows("simulated fetus of 64 voxels", std::make_shared<const Volume>(*makePhantom(config)), plan);
    }
    for (const std::string& file : plan.files) {
        const auto study = readStudy(file);
        if (!study) {
            fmt::print(stderr, "{}\n", study.error().sentence());
            return 3;
        }
        printRows(std::filesystem::path(file).filename().string(), study->phases.front(), plan);
    }
    return 0;
}
