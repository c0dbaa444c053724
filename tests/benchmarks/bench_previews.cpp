// This measures how far the previews of a volume as it opens are from its final picture, sharpness apart.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <opencv2/imgproc.hpp>
#include <string_view>

#include "app/measuring/measures/picture_difference.h"
#include "app/measuring/render/study_render.h"
#include "io/study/study.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/document/document.h"
#include "processing/document/opening_finds.h"
#include "processing/phantom/phantom.h"
#include "processing/picture/look.h"
#include "processing/picture/view_limits.h"
#include "processing/ray_caster/ray_caster.h"
#include "widgets/casting/qualities.h"

namespace {

using namespace echolucent;

constexpr int edge = 512;           // pixels
constexpr double blurPixels = 2.0;  // what is left are differences that no sharpness explains

/// What the window makes its pictures of when a file has been opened, seen 20 and -12 degrees off the beam, so that no
/// border of the data lies along a grid axis.
struct Opened {
    std::shared_ptr<const Volume> quiet;
    OpacityCurve curve;
    RayCastSettings settings;  ///< as settingsAt() takes them
};

Opened opened(const Volume& volume) {
    const Look look = lookAtStart();
    const Document plain;
    const Document document = withFinds(plain, *findOnOpening(volume, {}));
    Viewpoint view = withFrontAcross({.beamAxis = document.beam.axis}, document.scene.front.depthMm);
    Opened made;
    made.quiet = std::make_shared<const Volume>(*quietVolume(volume, look.reduction));
    made.curve = adaptOpacity(volume, view, {}, {}, {made.quiet.get(), look.reduction})->curve;
    view.azimuthDegrees = 20;
    view.elevationDegrees = -12;
    made.settings = rayCastSettings(look);
    made.settings.width = made.settings.height = edge;
    made.settings.camera = defaultCamera(volume.dataBox(), view, 1.0);
    made.settings = limitedTo(view, volume.geometry(), made.settings);
    return made;
}

Picture blurred(Picture picture) {
    cv::Mat pixels(picture.height, picture.width, CV_32FC4, picture.rgba.data());
    cv::GaussianBlur(pixels, pixels, {}, blurPixels);
    return picture;
}

/// The picture at a quality, enlarged as the window enlarges it.
Picture atQuality(RayCaster& caster, const Opened& opened, std::size_t quality) {
    const RayCastSettings settings = settingsAt(quality, opened.settings);
    Picture picture = *caster.cast(opened.curve, settings);
    return blurred(settings.width == edge ? std::move(picture) : cli::enlarged(picture, edge, edge));
}

void printRow(const std::string& name, const Volume& volume) {
    const Opened opened = ::opened(volume);
    RayCaster caster(opened.quiet);
    const Picture final = atQuality(caster, opened, convergedQuality);
    fmt::print("| {} |", name);
    for (std::size_t quality = highQuality; quality < qualities.size(); ++quality)
        fmt::print(" {:.2f} |", pictureError(atQuality(caster, opened, quality), final).rmse);
    fmt::print("\n");
    std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) {
    if (count == 2 && std::string_view(arguments[1]) == "--help") {
        fmt::print(
            "bench-previews [FILE...]: prints the RMSE of each quality's picture from the converged one, both blurred "
            "by {} pixels, of {} x {} pixels; a row of a Markdown table for each file.\n",
            blurPixels, edge, edge);
        return 0;
    }
    std::string head = "| volume |", line = "| --- |";
    for (std::size_t quality = highQuality; quality < qualities.size(); ++quality) {
        const Quality& one = qualities.at(quality);
        head += one.reduction > 1.0 ? fmt::format(" step {:g}, every {:g} pixels |", one.step, one.reduction)
                                    : fmt::format(" step {:g} |", one.step);
        line += " --- |";
    }
    fmt::print("{}\n{}\n", head, line);
    if (count == 1) {
        PhantomConfig config = defaultPhantom(PhantomScene::fetus);
        config.size = {64, 64, 64};
        printRow("simulated fetus of 64 voxels", *makePhantom(config));
    }
    for (int i = 1; i < count; ++i) {
        const auto study = readStudy(arguments[i]);
        if (!study) {
            fmt::print(stderr, "{}\n", study.error().sentence());
            return 3;
        }
        printRow(std::filesystem::path(arguments[i]).filename().string(), *study->phases.front());
    }
    return 0;
}
