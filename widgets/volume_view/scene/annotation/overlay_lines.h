// Draws an overlay in VTK's scene.
#pragma once

#include <vtkSmartPointer.h>

#include <vector>

#include "processing/picture/camera.h"
#include "widgets/volume_view/scene/annotation/overlay.h"
#include "widgets/volume_view/scene/annotation/smooth_lines.h"

class vtkRenderer;
class vtkTextActor;

namespace echolucent {

class OverlayLines {
public:
    OverlayLines();
    ~OverlayLines();
    /// The renderer must outlive this object.
    void addTo(vtkRenderer* renderer);
    void setOverlay(const Overlay& overlay) { m_overlay = overlay; }
    [[nodiscard]] const Overlay& overlay() const { return m_overlay; }
    /// Sizes in device pixels; `scale`: device pixels per pixel of a plain screen.
    void layOut(int viewportWidth, int viewportHeight, double scale, const Camera& camera);
    void setVisible(bool visible);

private:
    void layOutTexts(int viewportWidth, int viewportHeight, double scale, const Camera& camera);

    Overlay m_overlay;
    SmoothLines m_lines;
    vtkRenderer* m_renderer = nullptr;
    std::vector<vtkSmartPointer<vtkTextActor>> m_texts;  ///< as many as were ever shown at once
    bool m_visible = true;
};

}  // namespace echolucent
