#include "processing/document/method_choice.h"

#include <stdexcept>

#include "processing/choice_names.h"

namespace echolucent {

namespace {
constexpr ChoiceNames<4> initialKindNames{"parabolic", "quartic", "linear", "manual"};
}

std::string_view nameOf(InitialKind kind) { return nameIn(initialKindNames, kind); }

std::optional<InitialKind> initialKindFromName(std::string_view name) {
    return choiceNamed<InitialKind>(initialKindNames, name);
}

OpacityCurve initialCurve(const MethodChoice& method, const CurveSet& curves) {
    switch (method.initial) {
        case InitialKind::parabolic: return PowerCurve{2, method.initialScale};
        case InitialKind::quartic: return PowerCurve{4, method.initialScale};
        case InitialKind::linear: return curves.linear;
        case InitialKind::manual: return curves.manual;
    }
    throw std::invalid_argument("initialCurve: no such kind of initial function");
}

AdaptiveOtfConfig configOf(const MethodChoice& method, const CurveSet& curves) {
    AdaptiveOtfConfig config = method.config;
    config.initial = initialCurve(method, curves);
    return config;
}

}  // namespace echolucent
