// What every designer asks of its arguments, and the words in which designers say numbers.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

#include "processing/designers/design.h"
#include "processing/parameters/parameter.h"

namespace echolucent {

/// Throws std::invalid_argument, with "`configName`: " before the exception's text, if problemIn() finds something or
/// the volumes of the input have different grids.
template <typename Config>
void requireDesignable(std::string_view configName, const ParameterTable<Config>& table, const Config& config,
                       const DesignerInput& input) {
    std::string problem = problemIn(table, config);
    const VolumeGeometry &raw = input.raw.geometry(), &shown = input.shown.geometry();
    if (problem.empty() && (raw.size != shown.size || raw.spacing != shown.spacing))
        problem = "the shown voxels have another grid";
    if (!problem.empty()) throw std::invalid_argument(std::string(configName) + ": " + problem);
}

/// A number as designers write it in sentences: at most three decimals.
[[nodiscard]] inline std::string inWords(double number) { return textOf(std::round(number * 1e3) / 1e3); }

/// A number rounded to a multiple of `step`, which is above 0.
[[nodiscard]] inline std::string roundedInWords(double number, double step) {
    return textOf(std::round(number / step) * step);
}

/// A share as designers write it in sentences: "37.5 %".
[[nodiscard]] inline std::string percentInWords(double share) { return textOf(std::round(share * 1e3) / 1e1) + " %"; }

}  // namespace echolucent
