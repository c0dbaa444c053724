#include "processing/sampling/interpolation.h"

#include "processing/choice_names.h"

namespace echolucent {

namespace {
constexpr ChoiceNames<2> interpolationNames{"nearest", "trilinear"};
}

std::string_view nameOf(Interpolation interpolation) { return nameIn(interpolationNames, interpolation); }

}  // namespace echolucent
