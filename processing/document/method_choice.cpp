#include "processing/document/method_choice.h"

#include <array>
#include <stdexcept>

namespace echolucent {

namespace {
constexpr std::array<std::string_view, 4> initialKindNames{"parabolic", "quartic", "linear", "manual"};
}

std::string_view nameOf(InitialKind kind) { return initialKindNames.at(static_cast<std::size_t>(kind)); }

std::optional<InitialKind> initialKindFromName(std::string_view name) {
    for (std::size_t i = 0; i < initialKindNames.size(); ++i)
        if (initialKindNames[i] == name) return static_cast<InitialKind>(i);
    return std::nullopt;
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
