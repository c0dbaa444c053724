#include "widgets/volume_view/scene/annotation/caption.h"

#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include "widgets/volume_view/scene/annotation/annotation_style.h"

namespace echolucent {

Caption::Caption() {
    styleAnnotation(*m_text, annotationColour);
    m_text->GetTextProperty()->SetJustificationToLeft();
    m_text->GetTextProperty()->SetVerticalJustificationToTop();
}

Caption::~Caption() = default;

void Caption::addTo(vtkRenderer* renderer) { renderer->AddActor2D(m_text); }

void Caption::setText(const std::string& text) {
    m_said = text;
    m_text->SetInput(text.c_str());
}

void Caption::setVisible(bool visible) { m_text->SetVisibility(visible && !m_said.empty()); }

void Caption::layOut(int viewportHeight, double scale) {
    const double margin = annotationMargin * scale;
    m_text->SetDisplayPosition(static_cast<int>(margin), static_cast<int>(viewportHeight - margin));
}

}  // namespace echolucent
