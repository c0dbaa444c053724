// The parts of a document that both versions of its JSON share. Missing and wrong values are told to the problems of
// the fields (json_fields.h).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "io/json/json_fields.h"
#include "processing/document/document.h"

namespace echolucent {

/// The largest number of a phase or a tube core, and the largest id.
inline constexpr std::int64_t largestNumber = 1'000'000;

/// Of the key "study" in a document's root.
[[nodiscard]] StudyReference studyIn(JsonFields root);
[[nodiscard]] Beam beamIn(JsonFields fields);
[[nodiscard]] ViewDirection directionIn(JsonFields fields);
[[nodiscard]] Pose poseIn(JsonFields& fields);
[[nodiscard]] CutSurface surfaceIn(JsonFields fields);
[[nodiscard]] Box boxIn(JsonFields& fields);
[[nodiscard]] Planes planesIn(JsonFields& fields);
/// Of the key "strokes".
[[nodiscard]] std::vector<ScalpelStroke> strokesIn(JsonFields& fields);
/// Of the key "phase".
[[nodiscard]] int phaseIn(JsonFields& fields);
[[nodiscard]] nlohmann::ordered_json motionJson(const MotionChoice& motion);
[[nodiscard]] MotionChoice motionIn(JsonFields& fields);
[[nodiscard]] Comparison comparisonIn(JsonFields& fields);
/// Of the key "measurements" in a document's root.
[[nodiscard]] std::vector<Measurement> measurementsIn(JsonFields& root);

}  // namespace echolucent
