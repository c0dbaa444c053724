// An adaptive OTF as text: JSON, CSV and a summary for a person. docs/cli-otf.md describes each field and column.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/cli/options/view_options.h"
#include "app/cli/report/report_json.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/document/curve_adjustment.h"
#include "processing/volume/volume.h"

namespace echolucent::cli {

/// What the JSON holds beside the OTF.
struct OtfContext {
    Json madeOf;
    ChosenBeam beam;
    std::string initialName;              ///< of the initial function: as in --initial, or the document's InitialKind
    double manualFactor = 1.0;            ///< of a manual initial function: its file's opacities were multiplied by it
    CurveAdjustment adjustment{};         ///< made on the curve
    double findingMilliseconds = 0.0;     ///< wall time of the search for beam and front
    double quieteningMilliseconds = 0.0;  ///< wall time of making the quiet voxels
    Json explanation{};                   ///< of one tube core (explanationJson()); null if nobody asked for it
};

/// One JSON object that ends with a newline. Its numbers are read back without loss.
[[nodiscard]] std::string jsonReport(const Volume& volume, const AdaptiveOtf& otf, const OtfContext& context);
/// Adds the parameters of an adjustment by name.
void addAdjustment(Json& parameters, const CurveAdjustment& adjustment);
/// intensity, opacity, log_opacity, initial_opacity: 256 rows and a header.
[[nodiscard]] std::string curveTable(const AdaptiveOtf& otf);
/// A header, and a row for each tube core; columns as in the JSON.
[[nodiscard]] std::string tubeTable(const AdaptiveOtf& otf);
[[nodiscard]] std::string summary(const Volume& volume, const AdaptiveOtf& otf);

}  // namespace echolucent::cli
