// The report of `study motion`: one page, and tables.
#pragma once

#include <string>
#include <vector>

#include "app/measuring/motion/motion_measure.h"

namespace echolucent::cli {

/// The page as HTML with all it needs inside.
[[nodiscard]] std::string motionPage(const std::vector<MotionFigures>& cases);
/// A row for each case and mode.
[[nodiscard]] std::string motionFiguresTable(const std::vector<MotionFigures>& cases);
/// A row for each case and pair of frames.
[[nodiscard]] std::string motionViewsTable(const std::vector<MotionFigures>& cases);

}  // namespace echolucent::cli
