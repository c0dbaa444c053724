#include "processing/document/method_choice.h"

#include <array>
#include <stdexcept>

#include "processing/adaptive/method_parameters.h"
#include "processing/choice_names.h"
#include "processing/parameters/parameter_rows.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<4> initialKindNames{"parabolic", "quartic", "linear", "manual"};

constexpr std::array initialKinds{parameter_rows::Choice{InitialKind::parabolic, initialKindNames[0], "x² (parabolic)"},
                                  parameter_rows::Choice{InitialKind::quartic, initialKindNames[1], "x⁴ (quartic)"},
                                  parameter_rows::Choice{InitialKind::linear, initialKindNames[2], "Linear (eq. 1)"},
                                  parameter_rows::Choice{InitialKind::manual, initialKindNames[3], "Manual nodes"}};

bool hasInitialScale(const MethodChoice& method) {
    return method.initial == InitialKind::parabolic || method.initial == InitialKind::quartic;
}

}  // namespace

std::string_view nameOf(InitialKind kind) { return nameIn(initialKindNames, kind); }

std::optional<InitialKind> initialKindFromName(std::string_view name) {
    return choiceNamed<InitialKind>(initialKindNames, name);
}

const ParameterTable<MethodChoice>& initialFunctionParameters() {
    using namespace parameter_rows;
    static const ParameterTable<MethodChoice> table = [] {
        const AnyParameter& scale = *parameterNamed(methodParameters(), "opacity_scale");
        ParameterTable<MethodChoice> made{
            {choice<initialKinds, &MethodChoice::initial>({"initial", "Initial function",
                                                           "The function that the method starts from", "",
                                                           "docs/method.md, 7. Curve"}),
             playing(hasInitialScale, "if initial is parabolic or quartic",
                     number<&MethodChoice::initialScale>(
                         {"initial_scale", scale.label, "Opacity of the initial function at full intensity", scale.unit,
                          scale.source},
                         scale.range, {.offered = scale.offered, .steps = scale.steps}))}};
        return made;
    }();
    return table;
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
