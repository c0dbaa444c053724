// The names of the method's choices, as the command line and the reports write them.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "processing/adaptive_otf.h"

namespace echolucent {

template <typename Choice>
struct NamedChoice {
    Choice value;
    std::string_view name;
};
template <typename Choice>
using ChoiceNames = std::array<NamedChoice<Choice>, 2>;

inline constexpr ChoiceNames<InterfaceFunction> interfaceFunctionNames{
    {{InterfaceFunction::variance, "variance"}, {InterfaceFunction::ratio, "ratio"}}};
inline constexpr ChoiceNames<CurveForm> curveFormNames{{{CurveForm::product, "product"}, {CurveForm::ramp, "ramp"}}};
inline constexpr ChoiceNames<TubeBorder> tubeBorderNames{
    {{TubeBorder::mirrorThenZero, "mirror"}, {TubeBorder::circular, "circular"}}};
inline constexpr std::array<NamedChoice<SmoothingRoute>, 3> smoothingRouteNames{
    {{SmoothingRoute::direct, "direct"},
     {SmoothingRoute::fourier, "fourier"},
     {SmoothingRoute::recursive, "recursive"}}};
inline constexpr ChoiceNames<TubeSampling> tubeSamplingNames{
    {{TubeSampling::trilinear, "trilinear"}, {TubeSampling::nearest, "nearest"}}};
inline constexpr ChoiceNames<Precision> precisionNames{
    {{Precision::single32, "single"}, {Precision::double64, "double"}}};
inline constexpr ChoiceNames<bool> kernelEndNames{{{true, "zero"}, {false, "cut"}}};  ///< kernelEndsAtZero
inline constexpr ChoiceNames<bool> coarsestMaximumNames{
    {{true, "needed"}, {false, "any"}}};  ///< coarsestMustHaveMaximum
inline constexpr ChoiceNames<bool> priorCellNames{{{true, "overlapping"}, {false, "apart"}}};  ///< priorCellsMayOverlap

/// Empty: the table has no such value.
template <typename Names, typename Choice>
[[nodiscard]] constexpr std::string_view nameIn(const Names& names, Choice value) {
    for (const auto& named : names)
        if (named.value == value) return named.name;
    return {};
}

template <typename Names>
[[nodiscard]] constexpr auto valueIn(const Names& names, std::string_view name)
    -> std::optional<decltype(names.front().value)> {
    for (const auto& named : names)
        if (named.name == name) return named.value;
    return std::nullopt;
}

}  // namespace echolucent
