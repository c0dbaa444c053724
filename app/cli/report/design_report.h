// What an OTF designer made of a volume as text: JSON, CSV and a summary for a person (docs/cli-otf.md).
#pragma once

#include <string>

#include "app/cli/command.h"
#include "app/cli/report/otf_report.h"
#include "processing/designers/design.h"
#include "processing/designers/designer_config.h"
#include "processing/volume/volume.h"

namespace echolucent::cli {

/// A run of a designer.
struct DesignRun {
    DesignerConfig config;
    Design design;
    Viewpoint view;
    SpeckleReduction reduction = SpeckleReduction::off;  ///< of the voxels that it looked at
    double milliseconds = 0.0;                           ///< wall time
};

/// One JSON object, numbers round-trip, ends with a newline.
[[nodiscard]] std::string jsonReport(const Volume& volume, const DesignRun& run, const OtfContext& context);
/// intensity, opacity: 256 rows and a header; of a two-dimensional OTF intensity, gradient, opacity: one row a node.
[[nodiscard]] std::string curveTable(const Design& design);
[[nodiscard]] std::string summary(const DesignRun& run);

}  // namespace echolucent::cli
