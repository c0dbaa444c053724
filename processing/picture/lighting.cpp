#include "processing/picture/lighting.h"

#include "processing/choice_names.h"

namespace echolucent {

namespace {
constexpr ChoiceNames<3> lightingNames{"flat", "surface", "depth"};
}

std::string_view nameOf(Lighting lighting) { return nameIn(lightingNames, lighting); }

}  // namespace echolucent
