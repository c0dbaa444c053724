// What a designer is called; its config holds it.
#pragma once

#include <string_view>

namespace echolucent {

struct DesignerWords {
    std::string_view name;   ///< for scripts and files: "contour-spectrum"
    std::string_view label;  ///< for a person: "Contour spectrum"
};

}  // namespace echolucent
