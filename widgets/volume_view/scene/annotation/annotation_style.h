// One look for everything written over the picture.
#pragma once

#include "processing/picture/annotation_layout.h"

class vtkTextActor;

namespace echolucent {

/// Makes a text legible over black and over bright tissue.
void styleAnnotation(vtkTextActor& text, const Colour& colour);

}  // namespace echolucent
