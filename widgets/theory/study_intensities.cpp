#include "widgets/theory/study_intensities.h"

#include <algorithm>

#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/document/curve_set.h"

namespace echolucent {

std::optional<StudyIntensities> studyIntensities(const AdaptiveOtf* otf, const CurveSet& curves) {
    if (otf == nullptr || otf->tubesWithWeight == 0 || otf->surfacesWhereDataBegin) return std::nullopt;
    const MeanInterface mean = meanInterfaceOf(*otf);
    return StudyIntensities{std::clamp(mean.high, 0.0, 1.0),
                            std::clamp(mean.low, 0.0, 1.0),
                            {curves.parabolic, curves.quartic, curves.linear, otf->curve}};
}

}  // namespace echolucent
