// Shows how the grid's axes lie in the picture.
#pragma once

#include <vtkNew.h>

#include <array>

#include "processing/viewpoint/viewpoint.h"
#include "widgets/volume_view/scene/annotation/smooth_lines.h"

class vtkRenderer;
class vtkTextActor;

namespace echolucent {

/// Three lettered arms along the grid's axes x, y and z, from a common foot in the lower left corner. The arm nearest
/// the viewer is drawn last. An axis along the line of sight is a disc, brighter if it comes towards the viewer.
class OrientationMarker {
public:
    OrientationMarker();
    ~OrientationMarker();
    void addTo(vtkRenderer* renderer);
    /// `scale`: device pixels per pixel of a plain screen.
    void layOut(double scale, const ViewFrame& frame);
    void setVisible(bool visible);

private:
    SmoothLines m_lines;
    std::array<vtkNew<vtkTextActor>, 3> m_letters;
};

}  // namespace echolucent
