#include "widgets/volume_view/scene/annotation/annotation_style.h"

#include <vtkTextActor.h>
#include <vtkTextProperty.h>

namespace echolucent {

void styleAnnotation(vtkTextActor& text, const Colour& colour) {
    vtkTextProperty* style = text.GetTextProperty();
    style->SetFontFamilyToArial();
    style->SetFontSize(annotationFontSize);
    style->BoldOn();  // VTK's own plain face is too thin over speckle
    style->SetColor(colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0);
    style->ShadowOn();
    style->SetShadowOffset(1, -1);
    text.PickableOff();
}

}  // namespace echolucent
