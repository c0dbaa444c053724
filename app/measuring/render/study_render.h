// The parts of `study render`: the compared settings of the ray caster, the measures, and the page.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/measuring/measures/compositing_precision.h"
#include "app/measuring/measures/picture_difference.h"
#include "app/measuring/study_output.h"
#include "processing/ray_caster/plain/plain_caster.h"
#include "processing/ray_caster/ray_caster.h"

namespace echolucent::cli {

/// One of the compared settings.
struct RenderVariant {
    std::string axis;   ///< "step", "interpolation", ...; "combination": several changed at once
    std::string value;  ///< the difference from the reference setting
    RayCastSettings settings;
    double reduction = 1.0;               ///< size of the whole picture over size of the cast one, per edge, at least 1
    std::optional<PlainCasting> plain{};  ///< how the plain route casts it; no value: the kernel casts it
    /// How the plain route stores pixels. Of the kernel it is single: the kernel gathers a run of samples in float, but
    /// stores pixels between runs in double.
    CompositingPrecision precision = CompositingPrecision::single;
    [[nodiscard]] std::string name() const { return axis + " " + value; }
};

/// First the reference setting, `reference` itself: step 1, trilinear, float, ends at 1/512, whole size. Then one
/// parameter changes at a time, then come combinations. No setting comes twice.
[[nodiscard]] std::vector<RenderVariant> renderVariants(const RayCastSettings& reference);

/// The plain route with the rules that castRays() documents.
[[nodiscard]] PlainCasting asTheKernel(double step, CompositingPrecision precision = CompositingPrecision::twofold);

/// Divides width and height, and rounds them to at least one pixel.
[[nodiscard]] RayCastSettings reduced(RayCastSettings settings, double reduction);

struct RenderCase {
    std::shared_ptr<const Volume> volume;
    OpacityCurve curve;
    RayCastSettings reference;
};

/// The results of one setting.
struct RenderResult {
    RenderVariant variant;
    std::string letter;  ///< A, B, ... Z, AA, ...: its name in plots
    PictureError error;  ///< from the converged reference
    /// For a plain setting: the error from the plain route in double with the same samples.
    std::optional<PictureError> precisionError;
    double milliseconds = 0.0;  ///< median
    double timeRatio = 1.0;     ///< to the reference setting; for plain ones to the plain route in double, step 1
    bool onFront = false;       ///< no other setting of the kernel is both faster and nearer to the reference
};

/// The kernel's picture against the plain route's with equal settings.
struct SameRaysCheck {
    std::string name;
    PictureError error;
};

struct RenderStudy {
    std::string subject;  ///< sentences that say what was rendered
    int width = 0, height = 0, repeats = 0, plainRepeats = 0, threads = 0;
    bool shaded = false;
    double referenceSeconds = 0.0;  ///< wall time of the converged reference
    Picture converged;
    std::vector<RenderResult> results;
    std::vector<SameRaysCheck> sameRays;  ///< first the reference setting, last one that is half a pixel off on purpose
};
[[nodiscard]] RenderStudy measureRendering(const RenderCase& one, int repeats);

/// Marks the kernel's settings that no other beats in both run time and RMSE.
void markFront(std::vector<RenderResult>& results);

/// The error allowed for a quality, in 8-bit levels: RMSE and largest difference from the converged reference.
struct QualityBound {
    std::string name;  ///< name of a quality in the program (widgets/casting/qualities.h)
    double rmse, largest = std::numeric_limits<double>::infinity();
};
/// From fine to coarse.
[[nodiscard]] std::vector<QualityBound> qualityBounds();
/// The kernel's fastest setting within a bound; null if there is none.
[[nodiscard]] const RenderResult* fastestWithin(const QualityBound& bound, const std::vector<RenderResult>& results);

/// The picture of a setting, enlarged to the whole size.
[[nodiscard]] Picture pictureOf(const RenderVariant& variant, const RenderCase& one, RayCaster& caster);
/// Enlarges bilinearly, like a texture stretched over the screen: pixel centres lie at halves, edges are clamped.
[[nodiscard]] Picture enlarged(const Picture& picture, int width, int height);
/// The middle of a picture, of width x height pixels. If an edge of the picture is shorter, it keeps that edge.
[[nodiscard]] Picture middleOf(const Picture& picture, int width, int height);
/// Means over squares of pixels, so that no edge is longer than `edge`. Pixels that fill no square are left out.
[[nodiscard]] Picture overviewOf(const Picture& picture, int edge);
/// The luminance of a picture (0.2126 red, 0.7152 green, 0.0722 blue) as a grey picture.
[[nodiscard]] Picture inGrey(Picture picture);

[[nodiscard]] std::string renderCsv(const RenderStudy& study);
/// Four tables: all settings, the kernel's front, the fastest settings within qualityBounds(), the precisions of the
/// plain route.
[[nodiscard]] TextTable settingsTable(const RenderStudy& study);
[[nodiscard]] TextTable frontTable(const RenderStudy& study);
[[nodiscard]] TextTable boundsTable(const RenderStudy& study);
[[nodiscard]] TextTable precisionTable(const RenderStudy& study);
[[nodiscard]] std::string sameRaysText(const RenderStudy& study);
[[nodiscard]] std::string summaryText(const RenderStudy& study);
/// Run time against RMSE of the kernel's settings, and the front.
[[nodiscard]] Plot frontPlot(const RenderStudy& study);
[[nodiscard]] std::string renderPage(const RenderStudy& study, const RenderCase& one);

}  // namespace echolucent::cli
