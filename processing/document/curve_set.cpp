#include "processing/document/curve_set.h"

#include <stdexcept>

#include "processing/choice_names.h"

namespace echolucent {

namespace {
constexpr ChoiceNames<allCurveKinds.size()> curveKindNames{"adaptive", "manual", "linear", "parabolic", "quartic"};
}

std::string_view nameOf(CurveKind kind) { return nameIn(curveKindNames, kind); }

std::optional<CurveKind> curveKindFromName(std::string_view name) {
    return choiceNamed<CurveKind>(curveKindNames, name);
}

OpacityCurve curveOf(const CurveSet& curves, CurveKind kind, const SampledCurve& adaptive) {
    switch (kind) {
        case CurveKind::adaptive: return adaptive;
        case CurveKind::manual: return curves.manual;
        case CurveKind::linear: return curves.linear;
        case CurveKind::parabolic: return curves.parabolic;
        case CurveKind::quartic: return curves.quartic;
    }
    throw std::invalid_argument("curveOf: no such kind of curve");
}

OpacityCurve renderedCurve(const CurveSet& curves, CurveKind kind, const SampledCurve& adaptive) {
    return adjusted(curveOf(curves, kind, adaptive), curves.adjustment);
}

}  // namespace echolucent
