// A sweep as text: JSON, CSV and a summary for a person. docs/cli-sweep.md describes each field and column.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>

#include "app/cli/report/report_json.h"
#include "processing/motion/flicker.h"
#include "processing/motion/motion_choice.h"
#include "processing/motion/otf_sweep.h"

namespace echolucent::cli {

struct SweepReport {
    Json madeOf = {};
    Viewpoint start = {};
    MotionChoice motion = {};
    std::optional<OtfSmoothing> smoothing = {};  ///< no value if one OTF is shown in all frames
    std::span<const SweptOtf> frames = {};
    std::optional<PictureFlicker> unsmoothedPictures = {}, shownPictures = {};  ///< with --picture-flicker only
};

/// One JSON object that ends with a newline. Its numbers are read back without loss.
[[nodiscard]] std::string sweepJson(const SweepReport& report);
/// A header, and a row for each frame.
[[nodiscard]] std::string sweepTable(std::span<const SweptOtf> frames);
[[nodiscard]] std::string sweepSummary(const SweepReport& report);

/// The OTFs of the frames as they were computed, and as they are shown.
[[nodiscard]] std::vector<SampledCurve> unsmoothedOf(std::span<const SweptOtf> frames);
[[nodiscard]] std::vector<SampledCurve> shownOf(std::span<const SweptOtf> frames);

}  // namespace echolucent::cli
