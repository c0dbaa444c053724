// Reading the tube cores of a view (Petersch 2005, section 4.1).
#pragma once

#include <cstddef>
#include <span>

#include "processing/detection/detection.h"
#include "processing/tube_core/rules/cell_rule.h"
#include "processing/tube_core/stage_runner.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Reads the tube cores, row by row on all threads, and lets the detection keep what the detection needs. `samples` are
/// row-major, with `columns` tubes in a row. If the run is cancelled, the remaining rows are not read.
void readTubeCores(const Volume& volume, std::span<const TubeSamples> samples, int columns, const CellRule& rule,
                   Detection& detection, StageRunner& run);

}  // namespace echolucent
