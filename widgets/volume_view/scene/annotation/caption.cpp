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

void Caption::addTo(vtkRenderer* renderer) {
    m_renderer = renderer;
    renderer->AddActor2D(m_text);
}

void Caption::setText(const std::string& text) { m_said = text; }

void Caption::setVisible(bool visible) { m_text->SetVisibility(visible && !m_said.empty()); }

void Caption::layOut(int viewportWidth, int viewportHeight, double scale) {
    const double margin = annotationMargin * scale, room = viewportWidth - 2.0 * margin;
    m_text->SetDisplayPosition(static_cast<int>(margin), static_cast<int>(viewportHeight - margin));
    if (m_brokenFor == m_said && m_room == room && m_dots == scale) return;
    m_brokenFor = m_said;
    m_room = room;
    m_dots = scale;
    const auto widthOf = [this](const std::string& line) {
        m_text->SetInput(line.c_str());
        double size[2];
        m_text->GetSize(m_renderer, size);
        return size[0];
    };
    m_text->SetInput(captionWithin(m_said, room, widthOf).c_str());
}

}  // namespace echolucent
