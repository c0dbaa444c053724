// Draws an overlay in VTK's scene.
#pragma once

#include "processing/picture/camera.h"
#include "widgets/volume_view/scene/annotation/overlay.h"
#include "widgets/volume_view/scene/annotation/smooth_lines.h"

class vtkRenderer;

namespace echolucent {

class OverlayLines {
public:
    void addTo(vtkRenderer* renderer);
    void setOverlay(const Overlay& overlay) { m_overlay = overlay; }
    [[nodiscard]] const Overlay& overlay() const { return m_overlay; }
    /// Sizes in device pixels; `scale` is the number of them per pixel of a plain screen.
    void layOut(int viewportWidth, int viewportHeight, double scale, const Camera& camera);
    void setVisible(bool visible);

private:
    Overlay m_overlay;
    SmoothLines m_lines;
};

}  // namespace echolucent
