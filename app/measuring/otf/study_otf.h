// The parts of `study otf`: the compared settings, the measures, and the page.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/measuring/study_output.h"
#include "app/measuring/study_phantoms.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/adaptive/method_reading.h"
#include "processing/comparison/classification_measures.h"

namespace echolucent::cli {

/// One of the compared settings: the default with one parameter changed.
struct OtfVariant {
    std::string interfaceFunction = "variance";  ///< a name of that parameter, "variance" or "ratio"
    std::string parameter;  ///< "tube spacing", "cell size", ...; "unchanged": only the interface function differs
    std::string value;
    AdaptiveOtfConfig config;
    bool isReference = false;  ///< whether it is the densest: tube cores every 4 units, double precision
    [[nodiscard]] std::string name() const { return value.empty() ? parameter : parameter + " " + value; }
};
/// The compared interface functions.
inline const std::array<std::string, 2> interfaceFunctions{"variance", "ratio"};

/// For the variance, then for the ratio: unchanged, the reference, and one parameter at a time. Grids of tube cores
/// with a given spacing cover this volume in this view. For any volume the variants have the same number and order.
[[nodiscard]] std::vector<OtfVariant> otfVariants(const VolumeGeometry& geometry, const Viewpoint& view);

/// A volume in a view. Its truth is null if unknown.
struct OtfCase {
    std::string name;
    const Volume* volume = nullptr;
    Viewpoint view;
    const PhantomTruth* truth = nullptr;
};

/// The results of one variant over all cases.
struct VariantResult {
    OtfVariant variant;
    DetectionQuality detection;
    double largestDifference =
        0.0;  ///< largest difference of opacity from the reference of the same interface function and case
    double sumOfSquares = 0.0;  ///< sum of the squares of these differences over all cases' samples
    std::size_t samples = 0;
    std::vector<double> times, timeRatios;  ///< for each case the median in ms, and its ratio to the default setting's
    bool onFront = false;  ///< no other of the same interface function is both faster and nearer to the reference

    [[nodiscard]] double rmsDifference() const;
    [[nodiscard]] double timeRatio() const;  ///< geometric mean over the cases
    [[nodiscard]] double time() const;       ///< mean over the cases, ms
};
/// Adds the errors of every variant on a case to `results`. If `results` is empty, it gets one entry for each variant.
void measureErrors(const OtfCase& one, std::vector<VariantResult>& results);
/// Adds the run times of every variant on a case. The variants take turns, `repeats` times. `results` must come from
/// measureErrors().
void measureTimes(const OtfCase& one, int repeats, std::vector<VariantResult>& results);
/// For each interface function, marks the variants that no other beats in both run time and RMS difference. Leaves out
/// the reference: its difference is 0 by definition.
void markFront(std::vector<VariantResult>& results);

/// One reading on one case.
struct ReadingResult {
    std::string condition,
        group;  ///< "ordinary", "hard", "front wall" or "empty". Of a volume without truth the condition is its path
                ///< and the group is an empty text
    std::uint64_t seed = 0;
    Viewpoint view;
    MethodReading reading = MethodReading::standard;
    DetectionQuality detection;
    std::optional<double> contrast;  ///< CNR_S in the six contrastConditions() along the beam; else no value
    double sumOfWeights = 0.0;       ///< sum of d
    int tubesWithWeight = 0;
    NearLight light;          ///< light with the reading's own curve, along its own tube cores with a surface
    NearLight parabolaLight;  ///< light with x^2 along the same tube cores
    NearLight linearLight;    ///< light with eq. 1, L_L = 20/255, a = 0.5
    std::string message;
    SampledCurve curve;
};
[[nodiscard]] ReadingResult measureReading(const OtfCase& one, MethodReading reading);

/// CNR_S of the curves without tube cores, in the six conditions.
struct FixedContrast {
    std::string condition;
    std::uint64_t seed = 0;
    std::optional<double> parabola, linear;
};

struct OtfStudy {
    std::string subject;  ///< what was measured, a sentence
    bool truthKnown = false;
    int repeats = 0;
    std::vector<VariantResult> variants;
    std::vector<ReadingResult> readings;
    std::vector<FixedContrast> fixed;
};
[[nodiscard]] std::string variantsCsv(const OtfStudy& study);
[[nodiscard]] std::string readingsCsv(const OtfStudy& study);
[[nodiscard]] std::string summaryText(const OtfStudy& study);
/// Run time against RMS difference of opacity, of one interface function. If ofDetection is set, against the weight
/// that is not on tube cores that found the true surface.
[[nodiscard]] Plot paretoPlot(const OtfStudy& study, const std::string& function, bool ofDetection);
[[nodiscard]] std::string otfPage(const OtfStudy& study);

[[nodiscard]] TextTable variantTable(const OtfStudy& study);
/// Detection of the readings side by side, by condition and by group.
[[nodiscard]] TextTable detectionTable(const OtfStudy& study);
/// CNR_S of the readings and of the fixed curves, by condition.
[[nodiscard]] TextTable contrastTable(const OtfStudy& study);
/// For a volume without truth: tube cores, weight, surface light.
[[nodiscard]] TextTable volumeTable(const OtfStudy& study);

}  // namespace echolucent::cli
