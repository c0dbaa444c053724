// The one look of everything written over the picture.
#pragma once

#include "widgets/volume_view/scene/annotation/smooth_lines.h"

class vtkTextActor;

namespace echolucent {

constexpr double annotationMargin = 18.0;  ///< from the picture's edges, pixels of a plain screen
constexpr int annotationFontSize = 14;     ///< pixels of a plain screen (72 dpi)
constexpr Colour annotationColour{0xd8, 0xdd, 0xe2};

/// Makes a text legible over black and over bright tissue.
void styleAnnotation(vtkTextActor& text, const Colour& colour);

}  // namespace echolucent
