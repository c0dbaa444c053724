// The parts of `study render`: which settings of the ray caster are compared, what is measured, and the page about it.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/measuring/measures/compositing_precision.h"
#include "app/measuring/measures/picture_difference.h"
#include "app/measuring/study_output.h"
#include "processing/ray_caster.h"
#include "processing/ray_caster/plain/plain_caster.h"

namespace echolucent::cli {

/// One setting that is compared.
struct RenderVariant {
    std::string axis;   ///< "step", "interpolation", ...; "combination": several changed at once
    std::string value;  ///< what differs from the reference setting
    RayCastSettings settings;
    double reduction = 1.0;  ///< width and height of the whole picture over those that are cast, 1 and above
    std::optional<PlainCasting> plain{};                            ///< by the plain route; none: by the kernel
    CompositingPrecision precision = CompositingPrecision::single;  ///< of stored pixels; single is the kernel's
    [[nodiscard]] std::string name() const { return axis + " " + value; }
};

/// The reference setting comes first, `reference` itself: step 1, trilinear, float, ends at 1/512, whole size. Then
/// comes one parameter at a time, then come combinations; no setting comes twice.
[[nodiscard]] std::vector<RenderVariant> renderVariants(const RayCastSettings& reference);

/// The plain route by the rules that castRays() documents.
[[nodiscard]] PlainCasting asTheKernel(double step, CompositingPrecision precision = CompositingPrecision::twofold);

/// Width and height are divided and rounded, to one pixel at least.
[[nodiscard]] RayCastSettings reduced(RayCastSettings settings, double reduction);

/// What is rendered.
struct RenderCase {
    std::shared_ptr<const Volume> volume;
    OpacityCurve curve;
    RayCastSettings reference;
};

/// What is known of one setting.
struct RenderResult {
    RenderVariant variant;
    std::string letter;  ///< A, B, ... Z, AA, ...: its name in plots
    PictureError error;  ///< from the converged reference
    /// The error of a plain setting is from the plain route in double with the same samples.
    std::optional<PictureError> precisionError;
    double milliseconds = 0.0;  ///< median
    double timeRatio = 1.0;     ///< to the reference setting; plain ones: to the plain route in double, step 1
    bool onFront = false;       ///< no other setting of the kernel is both faster and nearer to the reference
};

/// The kernel's picture against the plain route's at equal settings.
struct SameRaysCheck {
    std::string name;
    PictureError error;
};

struct RenderStudy {
    std::string subject;  ///< what was rendered, sentences
    int width = 0, height = 0, repeats = 0, plainRepeats = 0, threads = 0;
    bool shaded = false;
    double referenceSeconds = 0.0;  ///< what the converged reference took
    Picture converged;
    std::vector<RenderResult> results;
    std::vector<SameRaysCheck> sameRays;  ///< the first: the reference setting; the last: half a pixel off, on purpose
};
[[nodiscard]] RenderStudy measureRendering(const RenderCase& one, int repeats);

/// Marks the settings of the kernel that no other beats in both run time and RMSE.
void markFront(std::vector<RenderResult>& results);

/// What a quality may err by, in 8-bit levels: RMSE and largest difference from the converged reference.
struct QualityBound {
    std::string name;  ///< as the program names its quality (widgets/volume_view/qualities.h)
    double rmse, largest = std::numeric_limits<double>::infinity();
};
/// The bounds go from fine to coarse.
[[nodiscard]] std::vector<QualityBound> qualityBounds();
/// The fastest setting of the kernel within a bound; it is null where there is none.
[[nodiscard]] const RenderResult* fastestWithin(const QualityBound& bound, const std::vector<RenderResult>& results);

/// The picture of a setting in the size of the whole one.
[[nodiscard]] Picture pictureOf(const RenderVariant& variant, const RenderCase& one, RayCaster& caster);
/// Enlarges bilinearly, as a texture is stretched over the screen: pixel centres lie at halves, and edges are clamped.
[[nodiscard]] Picture enlarged(const Picture& picture, int width, int height);
/// The middle of a picture, as much of it as there is.
[[nodiscard]] Picture middleOf(const Picture& picture, int width, int height);
/// Means over squares of pixels, so that neither edge is longer than `edge`; pixels that fill no square are left out.
[[nodiscard]] Picture overviewOf(const Picture& picture, int edge);
/// The luminance of a picture (0.2126 red, 0.7152 green, 0.0722 blue) as a picture in grey.
[[nodiscard]] Picture inGrey(Picture picture);

[[nodiscard]] std::string renderCsv(const RenderStudy& study);
/// All settings, the kernel's front, the settings within the bounds, the precisions of the plain route.
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
