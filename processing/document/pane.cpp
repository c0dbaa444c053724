#include "processing/document/pane.h"

#include <algorithm>

#include "processing/adaptive/method_parameters.h"
#include "processing/designers/choice/designer.h"

namespace echolucent {

std::string problemOf(const Pane& pane) {
    if (pane.designer)
        if (const std::string problem = problemOf(*pane.designer); !problem.empty()) return "designer: " + problem;
    if (std::ranges::any_of(pane.withoutTubes, [](int tube) { return tube < 0; }))
        return "without_tubes must hold numbers from 0 on";
    if (pane.method)
        if (const std::string problem = problemOf(*pane.method); !problem.empty()) return "method: " + problem;
    return {};
}

}  // namespace echolucent
