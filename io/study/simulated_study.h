// The program's own simulated scan as a study.
#pragma once

#include "io/study/study.h"
#include "processing/document/study_reference.h"
#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent {

/// The simulated scan as a study of one phase. Fails (cancelled) if the person ended it.
[[nodiscard]] Result<Study> simulatedStudy(const SimulatedScan& scan, const Progress& progress = {});

}  // namespace echolucent
