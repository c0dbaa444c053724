// Manual opacity curves as JSON files (docs/cli.md).
#pragma once

#include <string>
#include <string_view>

#include "processing/opacity_curve.h"
#include "processing/result.h"

namespace echolucent {

/// The "format" of a curve file.
inline constexpr std::string_view curveFormatName = "echolucent-opacity-curve";

/// Reads the curve in the file at `path`. The file holds one JSON object: {"format": "echolucent-opacity-curve",
/// "version": 1, "nodes": [{"intensity": 0.1, "opacity": 0.0}, {"intensity": 1.0, "opacity": 0.8}]}. There is at least
/// one node. Intensities (normalised) never fall and lie in [0,1]; opacities (per unit length) lie in [0,1]. Unknown
/// keys are ignored. Fails (unreadable, naming the key) if the file says anything else.
[[nodiscard]] Result<ManualCurve> readCurve(const std::string& path);
/// Writes `curve` in that format, whole or not at all. Fails (unwritable) if the file cannot be written.
[[nodiscard]] Result<void> writeCurve(const std::string& path, const ManualCurve& curve);

}  // namespace echolucent
