#include "widgets/volume_view/scene/annotation/orientation_marker.h"

#include <vtkActor2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <cmath>

#include "widgets/volume_view/scene/annotation/annotation_style.h"

namespace echolucent {

OrientationMarker::OrientationMarker() {
    const AnnotationLayout anyView = orientationLayout(1.0, frameOf(Viewpoint{}));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        styleAnnotation(*m_letters[axis], anyView.texts[axis].colour);
        m_letters[axis]->SetInput(anyView.texts[axis].words.c_str());
        m_letters[axis]->GetTextProperty()->SetJustificationToCentered();
        m_letters[axis]->GetTextProperty()->SetVerticalJustificationToCentered();
    }
}

OrientationMarker::~OrientationMarker() = default;

void OrientationMarker::addTo(vtkRenderer* renderer) {
    renderer->AddActor2D(m_lines.actor());
    for (auto& letter : m_letters) renderer->AddActor2D(letter);
}

void OrientationMarker::setVisible(bool visible) {
    m_lines.actor()->SetVisibility(visible);
    for (auto& letter : m_letters) letter->SetVisibility(visible);
}

void OrientationMarker::layOut(double scale, const ViewFrame& frame) {
    const AnnotationLayout layout = orientationLayout(scale, frame);
    m_lines.clear();
    m_lines.addShapes(layout);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Point2& at = layout.texts[axis].at;
        m_letters[axis]->SetDisplayPosition(static_cast<int>(std::lround(at[0])), static_cast<int>(std::lround(at[1])));
    }
}

}  // namespace echolucent
