// What the header of an OTF designer declares. For a designer X it is
// - XConfig: values with defaults that can be compared, its `words`, and readsTubeCores() if it may read tube cores;
// - parametersOf(const XConfig&): the table of these values. The argument only selects it;
// - design(const XConfig&, input, progress): what it makes of a volume. The result is empty only if progress.cancel was
//   raised. Its bits are the same for any number of threads. It throws std::invalid_argument if problemIn() finds
//   something in the config, if the volumes of the input have different grids, or if the designer reads tube cores and
//   problemOf(input.method) is not empty.
// Such a header is light, because the document holds the configs of all designers.
#pragma once

#include <string_view>

#include "processing/progress.h"

namespace echolucent {

struct Design;         // processing/designers/design.h
struct DesignerInput;  // processing/designers/design.h
template <typename Values>
struct ParameterTable;  // processing/parameters/parameter.h

/// What a designer is called.
struct DesignerWords {
    std::string_view name;   ///< for scripts and files: "contour-spectrum"
    std::string_view label;  ///< for a person: "Contour spectrum"
};

}  // namespace echolucent
