// The result of an OTF designer as text: JSON, CSV and a summary for a person (docs/cli-otf.md).
#pragma once

#include <string>

#include "app/cli/report/otf_report.h"
#include "processing/designers/choice/designer_config.h"
#include "processing/designers/design.h"
#include "processing/volume/volume.h"

namespace echolucent::cli {

struct DesignRun {
    DesignerConfig config;
    Design design;
    Viewpoint view;
    SpeckleReduction reduction = SpeckleReduction::off;  ///< of the voxels that the designer read
    double milliseconds = 0.0;                           ///< wall time
};

/// One JSON object that ends with a newline. Its numbers are read back without loss.
[[nodiscard]] std::string jsonReport(const Volume& volume, const DesignRun& run, const OtfContext& context);
/// intensity, opacity: a header and 256 rows. For a two-dimensional OTF intensity, gradient, opacity: one row a node.
[[nodiscard]] std::string curveTable(const Design& design);
[[nodiscard]] std::string summary(const DesignRun& run);

}  // namespace echolucent::cli
