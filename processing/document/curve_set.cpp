#include "processing/document/curve_set.h"

#include <stdexcept>

namespace echolucent {

namespace {
constexpr std::array<std::string_view, allCurveKinds.size()> curveKindNames{"adaptive", "manual", "linear", "parabolic",
                                                                            "quartic"};
}

std::string_view nameOf(CurveKind kind) { return curveKindNames.at(indexOf(kind)); }

std::optional<CurveKind> curveKindFromName(std::string_view name) {
    for (const CurveKind kind : allCurveKinds)
        if (nameOf(kind) == name) return kind;
    return std::nullopt;
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

}  // namespace echolucent
