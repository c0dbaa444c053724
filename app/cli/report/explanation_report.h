// The explanation of one tube core as JSON and as a summary for a person. docs/cli-otf.md describes each field.
#pragma once

#include <string>

#include "app/cli/report/report_json.h"
#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/explanation/tube_explanation.h"

namespace echolucent::cli {

/// `otf` is the run that was explained.
[[nodiscard]] Json explanationJson(const TubeExplanation& explanation, const AdaptiveOtf& otf);
/// A sentence, and a line for each fact.
[[nodiscard]] std::string summary(const TubeExplanation& explanation);

}  // namespace echolucent::cli
