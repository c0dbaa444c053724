// What a pane's OTF is set to, in words and on plots.
#pragma once

#include <QString>
#include <cstddef>
#include <optional>

#include "processing/document/document.h"

namespace echolucent {

/// "Reading: as published. Cell size 5, …": the parameters of the adaptive method, those of a designer, or those of the
/// initial function, that play a part. Empty for a curve that a person sets.
[[nodiscard]] QString parametersOfPane(const Document& document, std::size_t pane);

/// The colour of a pane's curve, everywhere: an index of seriesColours. A curve has its own. A piecewise linear curve
/// of the pane's own has the one behind those of the five curves, so that it can stand beside that of eq. 1. Empty for
/// a designer's OTF other than the adaptive one.
[[nodiscard]] std::optional<std::size_t> colourOfPane(const Pane& pane);

}  // namespace echolucent
