#include "processing/volume/grid_axis.h"

#include "processing/choice_names.h"

namespace echolucent {

namespace {
constexpr ChoiceNames<3> gridAxisNames{"x", "y", "z"};
}

std::string_view nameOf(GridAxis axis) { return nameIn(gridAxisNames, axis); }

std::optional<GridAxis> gridAxisFromName(std::string_view name) { return choiceNamed<GridAxis>(gridAxisNames, name); }

}  // namespace echolucent
