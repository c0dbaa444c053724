#include "app/measuring/motion/motion_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/measuring/study_output.h"
#include "processing/adaptive/adaptive_otf_result.h"

namespace echolucent::cli {

namespace {

constexpr int stillZoom = 3;

std::string number(double value) { return fmt::format("{:.4g}", value); }

/// A value as a share of the unsmoothed one.
std::string share(double value, double unsmoothed) {
    return unsmoothed > 0.0 ? fmt::format("{:.3f}", value / unsmoothed) : std::string("-");
}

const ModeFigures& figuresOf(const MotionFigures& figures, const MotionMode& mode) {
    return *std::find_if(figures.modes.begin(), figures.modes.end(),
                         [&](const ModeFigures& one) { return one.mode == mode; });
}
const ModeFigures& unsmoothed(const MotionFigures& figures) { return figuresOf(figures, OtfSmoothing::none); }

bool probeMoves(const MotionFigures& figures) { return figures.motionCase.motion.probeMoves; }
std::string frameLabel(const MotionFigures& figures) { return probeMoves(figures) ? "view, degrees" : "frame"; }
double frameValue(const MotionFigures& figures, std::size_t index) {
    return probeMoves(figures) ? figures.frames[index].frame.degrees : static_cast<double>(index);
}

void addIntroduction(HtmlPage& page) {
    page.paragraph(
        "A probe that turns by a degree a frame, an object that moves by a phase a frame, or both (Petersch et al. "
        "2005, "
        "section 5). Flicker of the OTF is the RMS, over intensities and frames, of the second temporal difference of "
        "opacity: a steady change counts for nothing. The picture figures compare pictures of the same view and phase, "
        "so that the motion's own change is not in them: change is the RMS of picture(k, otf of k) - picture(k, otf of "
        "k-1), flicker the RMS of picture(k, otf of k) - 2 picture(k, otf of k-1) + picture(k, otf of k-2), over "
        "pixels, "
        "colours in [0,1] and frames; parallel projection, grey, without shading.");
    std::vector<std::vector<std::string>> rows;
    for (const MotionMode& mode : motionModes()) {
        if (!mode) continue;
        const SmoothingGains gains = gainsOf(*mode);
        const SmoothingLag lag = lagOf(*mode);
        rows.push_back({nameOf(mode), std::to_string(framesUsed(*mode)), fmt::format("{:.2f}", lag.ramp),
                        std::to_string(lag.stepToNineTenths), fmt::format("{:.3f}", gains.noise),
                        fmt::format("{:.3f}", gains.flicker), fmt::format("{:.3f}", gains.leastWeight),
                        fmt::format("{:.0f} %", 100.0 * lag.overshoot)});
    }
    page.heading("What the smoothings do to independent noise and to a change");
    page.table({"smoothing", "frames used", "lag on a ramp, frames", "frames until a step is shown to 90 %",
                "noise gain", "flicker gain", "least weight", "overshoot"},
               rows);
}

void addModes(HtmlPage& page, const MotionFigures& figures) {
    const ModeFigures& none = unsmoothed(figures);
    std::vector<std::vector<std::string>> rows;
    for (const ModeFigures& mode : figures.modes)
        rows.push_back({nameOf(mode.mode), number(mode.otfFlicker), share(mode.otfFlicker, none.otfFlicker),
                        number(mode.pictures.flicker), share(mode.pictures.flicker, none.pictures.flicker),
                        number(mode.pictures.change), share(mode.pictures.change, none.pictures.change),
                        mode.mode ? fmt::format("{:.2f}", lagOf(*mode.mode).ramp) : std::string("-"),
                        number(mode.lowest), number(mode.highest)});
    page.table({"mode", "OTF flicker", "of unsmoothed", "picture flicker", "of unsmoothed", "picture change",
                "of unsmoothed", "lag, frames", "lowest opacity", "highest opacity"},
               rows, "Opacities before they are clamped to [0,1].");
    const DomainFigures& domains = figures.domains;
    page.paragraph(
        fmt::format("Flicker left by least-flicker, of the unsmoothed in the same domain, where opacity is "
                    "smoothed: {:.4f}; its logarithm (floor 0.0001): {:.4f}; extinction, -ln(1 - opacity): {:.4f}.",
                    domains.opacity, domains.logarithm, domains.extinction));
}

void addDifferences(HtmlPage& page, const MotionFigures& figures) {
    std::vector<std::vector<std::string>> rows;
    for (const CurveDifference& one : figures.differences)
        rows.push_back({one.name, number(one.rms), number(one.largest), number(one.pictureRms),
                        share(one.rms, figures.adaptation)});
    if (!rows.empty())
        page.table(
            {"OTFs of", "RMS difference", "largest difference", "RMS of the pictures", "RMS, of the adaptation"}, rows,
            fmt::format(
                "Unsmoothed OTFs; pictures of the middle frame's view. The adaptation is the difference between the "
                "one OTF and the initial function: RMS {}, of the pictures {}.",
                number(figures.adaptation), number(figures.adaptationPicture)));
    page.paragraph(
        fmt::format("Pictures with one OTF for all frames against pictures with each frame's own OTF: RMS {} over all "
                    "frames, {} in the frame that differs most.",
                    number(figures.staticPictureRms), number(figures.worstStaticPictureRms)));
}

/// Adds the curves as in the paper's Fig. 10.
void addCurves(HtmlPage& page, const MotionFigures& figures) {
    Plot plot{.title = "OTF at both ends and in the middle (Fig. 10)",
              .xLabel = "normalised intensity",
              .yLabel = "opacity per unit",
              .series = {}};
    const std::size_t last = figures.frames.size() - 1;
    for (const std::size_t index : {std::size_t{0}, last / 2, last})
        plot.series.push_back(curveSeries((probeMoves(figures) ? "" : "frame ") +
                                              fmt::format("{:g}", frameValue(figures, index)) +
                                              (probeMoves(figures) ? "°" : ""),
                                          figures.frames[index].unsmoothed.opacities));
    plot.series.push_back(curveSeries("initial function", figures.initial.opacities));
    page.plot(plot);
}

struct Spread {
    std::size_t intensity = 0;  ///< place of the sample at which the course varies most
    std::vector<double> mean;   ///< over the frames
    double largestDeviation = 0.0;
};

Spread spreadOf(const std::vector<SampledCurve>& course) {
    Spread spread;
    const std::size_t samples = course.front().opacities.size();
    double largestVariance = -1.0;
    for (std::size_t i = 0; i < samples; ++i) {
        double sum = 0.0, squares = 0.0;
        for (const SampledCurve& curve : course) sum += curve.opacities[i];
        const double mean = sum / static_cast<double>(course.size());
        for (const SampledCurve& curve : course) {
            const double deviation = curve.opacities[i] - mean;
            squares += deviation * deviation;
            spread.largestDeviation = std::max(spread.largestDeviation, std::abs(deviation));
        }
        spread.mean.push_back(mean);
        if (squares > largestVariance) {
            largestVariance = squares;
            spread.intensity = i;
        }
    }
    return spread;
}

/// Intensity 1 is on top, and frames go to the right. valueOf(opacity, sample) lies in [0,1]. A row is the mean over
/// eight intensities: the page could not show finer rows.
template <typename ValueOf>
HeatMap mapOf(const MotionFigures& figures, const std::vector<SampledCurve>& course, const std::string& title,
              const ValueOf& valueOf) {
    HeatMap map{.title = title,
                .xLabel = frameLabel(figures),
                .yLabel = "normalised intensity",
                .xFirst = frameValue(figures, 0),
                .xLast = frameValue(figures, course.size() - 1),
                .yFirst = 1.0,
                .yLast = 0.0,
                .columns = course.size(),
                .values = {}};
    constexpr std::size_t samplesOfRow = 8;
    const std::size_t rows = course.front().opacities.size() / samplesOfRow;
    for (std::size_t row = 0; row < rows; ++row)
        for (const SampledCurve& curve : course) {
            double sum = 0.0;
            for (std::size_t i = 0; i < samplesOfRow; ++i) {
                const std::size_t sample = (rows - 1 - row) * samplesOfRow + i;
                sum += valueOf(curve.opacities[sample], sample);
            }
            map.values.push_back(sum / samplesOfRow);
        }
    return map;
}

/// Adds the paper's Fig. 11 as maps: the OTF, and its deviation from its mean, unsmoothed and smoothed on one scale.
void addMaps(HtmlPage& page, const MotionFigures& figures) {
    const auto &raw = unsmoothed(figures).shown, &shown = figuresOf(figures, OtfSmoothing::leastFlicker).shown;
    const Spread spread = spreadOf(raw);
    page.heatMap(mapOf(figures, raw, "OTF of each frame, unsmoothed: opacity",
                       [](double opacity, std::size_t) { return opacity; }));
    const double scale = std::max(spread.largestDeviation, std::numeric_limits<double>::min());
    const auto deviation = [&](double opacity, std::size_t sample) {
        return std::clamp(0.5 + 0.5 * (opacity - spread.mean[sample]) / scale, 0.0, 1.0);
    };
    const std::string range =
        fmt::format(" deviation from the mean OTF (0: -{0}, 1: +{0})", number(spread.largestDeviation));
    page.heatMap(mapOf(figures, raw, "Unsmoothed:" + range, deviation));
    page.heatMap(mapOf(figures, shown, "Least-flicker:" + range, deviation));
}

void addCourse(HtmlPage& page, const MotionFigures& figures) {
    constexpr std::size_t framesOfFigure = 21;  // 20 degrees, as in Fig. 11
    const Spread spread = spreadOf(unsmoothed(figures).shown);
    const std::size_t count = std::min(framesOfFigure, figures.frames.size());
    const std::size_t first = (figures.frames.size() - count) / 2;
    Plot plot{.title = fmt::format("Opacity at intensity {:.2f}, where it varies most (Fig. 11)",
                                   AdaptiveOtf::intensityOf(spread.intensity)),
              .xLabel = frameLabel(figures),
              .yLabel = "opacity per unit",
              .series = {}};
    for (const ModeFigures& mode : figures.modes) {
        PlotSeries series{.name = nameOf(mode.mode), .x = {}, .y = {}, .labels = {}};
        for (std::size_t i = first; i < first + count; ++i) {
            series.x.push_back(frameValue(figures, i));
            series.y.push_back(mode.shown[i].opacities[spread.intensity]);
        }
        plot.series.push_back(std::move(series));
    }
    page.plot(plot);
}

}  // namespace

std::string motionPage(const std::vector<MotionFigures>& cases) {
    HtmlPage page("The OTF's course over time");
    addIntroduction(page);
    for (const MotionFigures& figures : cases) {
        page.heading(figures.motionCase.title);
        page.paragraph(fmt::format("{} frames, {} phase(s), beam axis {}, front {:g} mm.", figures.frames.size(),
                                   figures.motionCase.phases.size(), nameOf(figures.motionCase.start.beamAxis),
                                   frontDepthMm(figures.motionCase.start)));
        addModes(page, figures);
        addDifferences(page, figures);
        addCurves(page, figures);
        addCourse(page, figures);
        addMaps(page, figures);
        if (!figures.stills.empty())
            page.paragraph("Both ends of the motion, with one OTF for all frames and with the frame's own (Fig. 9):");
        for (const Still& still : figures.stills) page.picture(still.picture, still.caption, stillZoom);
    }
    return page.text();
}

std::string motionFiguresTable(const std::vector<MotionFigures>& cases) {
    CsvTable table({"case", "mode", "frames", "otf_flicker", "otf_flicker_ratio", "picture_flicker",
                    "picture_flicker_ratio", "picture_change", "picture_change_ratio", "lag_frames", "lowest_opacity",
                    "highest_opacity", "static_picture_rms", "domain_opacity", "domain_logarithm",
                    "domain_extinction"});
    for (const MotionFigures& figures : cases) {
        const ModeFigures& none = unsmoothed(figures);
        for (const ModeFigures& mode : figures.modes)
            table.row({figures.motionCase.name, nameOf(mode.mode), figures.frames.size(), mode.otfFlicker,
                       mode.otfFlicker / none.otfFlicker, mode.pictures.flicker,
                       mode.pictures.flicker / none.pictures.flicker, mode.pictures.change,
                       mode.pictures.change / none.pictures.change, mode.mode ? lagOf(*mode.mode).ramp : 0.0,
                       mode.lowest, mode.highest, figures.staticPictureRms, figures.domains.opacity,
                       figures.domains.logarithm, figures.domains.extinction});
    }
    return table.text();
}

std::string motionViewsTable(const std::vector<MotionFigures>& cases) {
    CsvTable table(
        {"case", "otfs_of", "curve_rms", "curve_largest", "picture_rms", "adaptation_rms", "adaptation_picture_rms"});
    for (const MotionFigures& figures : cases)
        for (const CurveDifference& one : figures.differences)
            table.row({figures.motionCase.name, one.name, one.rms, one.largest, one.pictureRms, figures.adaptation,
                       figures.adaptationPicture});
    return table.text();
}

}  // namespace echolucent::cli
