// The parts of `study theory`: section 4 of the paper against pictures of volumes of two intensities.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "processing/theory/contrast_course.h"
#include "processing/theory/two_intensity_volume.h"

namespace echolucent::cli {

/// One curve in one volume: theory and picture.
struct TheoryRow {
    std::string curve;
    OpacityScaling scaling = OpacityScaling::sameScale;
    TwoIntensities model;
    double speckle = 0.0, speckleSize = 0.0;
    ModelPixels theory;               ///< eqs. 2 and 3
    std::optional<ModelPixels> mean;  ///< of uncorrelated speckle (speckledPixelsOf()); empty without speckle
    MeasuredPixels picture;

    /// The largest distance of a pixel from eqs. 2 and 3, share of white.
    [[nodiscard]] double largestError() const;
    /// Mean over tissue less mean over fluid.
    [[nodiscard]] double difference() const { return picture.tissue.mean - picture.fluid.mean; }
    /// difference() over the spread of both halves, sqrt(var + var). Empty without a spread.
    [[nodiscard]] std::optional<double> toNoise() const;
};

struct TheoryMeasure {
    TheorySetting setting;
    int edge = 64;  ///< voxels across the field
    std::uint64_t seed = 1;
};
/// The thicknesses and the ratios c2 / c1 in which theory and picture are compared. The setting's own ratio is one.
inline constexpr std::int64_t measuredUnits[] = {0, 10, 30, 60};
[[nodiscard]] std::vector<double> measuredRatios(const TheorySetting& setting);

/// Without speckle: every curve, thickness, ratio and scaling.
[[nodiscard]] std::vector<TheoryRow> measurePlain(const TheoryMeasure& measure);
/// The setting's model with speckle: s 0.5 and 1, uncorrelated and smoothed over two voxels.
[[nodiscard]] std::vector<TheoryRow> measureSpeckled(const TheoryMeasure& measure);

/// The adaptive curve of a model, and what adaptOpacity() makes of its volume.
struct AdaptiveRow {
    TwoIntensities model;
    double speckle = 0.0;
    int tubes = 0, withWeight = 0;
    double low = 0.0, high = 0.0;     ///< I_L and I_H, weighted means
    CurveContrast ofModel, ofVolume;  ///< contrasts of adaptiveCurveOf() and of adaptOpacity()'s curve
};
[[nodiscard]] std::vector<AdaptiveRow> measureAdaptive(const TheoryMeasure& measure);

/// From how many units of fluid on the parabola beats the line: unitsToBeat().
struct CrossingRow {
    double tissue = 0.0, ratio = 0.0;
    std::int64_t tissueUnits = 0;
    std::optional<double> units;
};
[[nodiscard]] std::vector<CrossingRow> measureCrossings(const TheorySetting& setting);

struct TheoryFindings {
    TheoryMeasure measure;
    std::vector<TheoryRow> plain, speckled;
    std::vector<AdaptiveRow> adaptive;
    std::vector<CrossingRow> crossings;
};
[[nodiscard]] TheoryFindings measureTheory(const TheoryMeasure& measure);

[[nodiscard]] std::string theoryPage(const TheoryFindings& found);
/// The tables of the page, for a terminal.
[[nodiscard]] std::string theorySummary(const TheoryFindings& found);
/// A row for each place and curve of both courses.
[[nodiscard]] std::string theoryCoursesCsv(const TheorySetting& setting);
/// A row for each curve and volume.
[[nodiscard]] std::string theoryPicturesCsv(const TheoryFindings& found);

}  // namespace echolucent::cli
