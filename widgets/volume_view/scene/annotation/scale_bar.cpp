#include "widgets/volume_view/scene/annotation/scale_bar.h"

#include <vtkActor2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include "widgets/volume_view/scene/annotation/annotation_style.h"

namespace echolucent {

ScaleBar::ScaleBar() {
    styleAnnotation(*m_text, annotationColour);
    m_text->GetTextProperty()->SetVerticalJustificationToBottom();
}

ScaleBar::~ScaleBar() = default;

void ScaleBar::addTo(vtkRenderer* renderer) {
    renderer->AddActor2D(m_lines.actor());
    renderer->AddActor2D(m_text);
}

void ScaleBar::setVisible(bool visible) {
    m_lines.actor()->SetVisibility(visible);
    m_text->SetVisibility(visible);
}

void ScaleBar::layOut(int viewportWidth, int viewportHeight, double scale, double heightMm, bool spacingKnown) {
    const AnnotationLayout layout = scaleBarLayout(viewportWidth, viewportHeight, scale, heightMm, spacingKnown);
    m_lines.clear();
    m_lines.addShapes(layout);
    const auto* bar = layout.shapes.empty() ? nullptr : std::get_if<AnnotationLine>(&layout.shapes.back());
    m_lengthPixels = bar ? bar->to[0] - bar->from[0] : 0.0;
    const AnnotationText& text = layout.texts.front();
    m_said = text.words;
    if (bar)
        m_text->GetTextProperty()->SetJustificationToCentered();
    else
        m_text->GetTextProperty()->SetJustificationToRight();
    m_text->SetDisplayPosition(static_cast<int>(text.at[0]), static_cast<int>(text.at[1]));
    m_text->SetInput(m_said.c_str());
}

}  // namespace echolucent
