// The pictures of the tool bar and of the motion bar, drawn in the colours of the theme.
#pragma once

#include <QIcon>

namespace echolucent {

enum class ToolPicture { open, sides, layout, box, front, scalpel, measure, curve, save, reset, play, pause };

/// A line drawing that is sharp at every size. It has the colours of the theme at the time it is painted, and those of
/// disabled text on a disabled button.
[[nodiscard]] QIcon toolIcon(ToolPicture picture);

}  // namespace echolucent
