// What a study gives to the model of section 4.
#pragma once

#include <optional>

#include "processing/theory/theory_curves.h"

namespace echolucent {

struct AdaptiveOtf;
struct CurveSet;

/// The intensities before and at the surfaces that the adaptive method found in a study, and the document's curves.
struct StudyIntensities {
    double tissue = 0.0, fluid = 0.0;  ///< c1 and c2: I_H and I_L of meanInterfaceOf()
    GivenCurves given;                 ///< without the document's CurveAdjustment
};
/// Empty if `otf` is null, or if no tube core has a weight behind fluid.
[[nodiscard]] std::optional<StudyIntensities> studyIntensities(const AdaptiveOtf* otf, const CurveSet& curves);

}  // namespace echolucent
