// Manual opacity curves as JSON files (docs/cli.md).
#pragma once

#include <string>

#include "processing/opacity_curve.h"
#include "processing/result.h"

namespace echolucent {

/// {"format": "echolucent-opacity-curve", "version": 1, "nodes": [{"intensity": 0.1, "opacity": 0.0}, ...]}:
/// intensities ascending in [0,1], opacities in [0,1], at least one node; unknown keys are ignored.
[[nodiscard]] Result<ManualCurve> readCurve(const std::string& path);
[[nodiscard]] Result<void> writeCurve(const std::string& path, const ManualCurve& curve);

}  // namespace echolucent
