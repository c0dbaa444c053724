#include "widgets/otf_editor/otf_editor_state.h"

#include <stdexcept>

namespace echolucent {

OpacityCurve curveOf(const OtfEditorState& state, CurveKind kind) {
    switch (kind) {
        case CurveKind::adaptive: return state.adaptive;
        case CurveKind::manual: return state.manual;
        case CurveKind::linear: return state.linear;
        case CurveKind::parabolic: return state.parabolic;
        case CurveKind::quartic: return state.quartic;
    }
    throw std::invalid_argument("curveOf: no such kind of curve");
}

bool sameEditableCurves(const OtfEditorState& left, const OtfEditorState& right) {
    return left.manual == right.manual && left.linear == right.linear && left.parabolic == right.parabolic &&
           left.quartic == right.quartic;
}

}  // namespace echolucent
