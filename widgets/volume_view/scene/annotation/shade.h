// A shade over the whole picture.
#pragma once

#include <vtkNew.h>

class vtkActor2D;
class vtkPoints;
class vtkRenderer;

namespace echolucent {

/// Takes oldPictureShade of the light away, from picture and annotations alike. It is hidden at first.
class Shade {
public:
    Shade();
    ~Shade();
    void addTo(vtkRenderer* renderer);
    /// The size of the viewport in device pixels.
    void layOut(int width, int height);
    void setVisible(bool visible);

private:
    vtkNew<vtkPoints> m_corners;
    vtkNew<vtkActor2D> m_actor;
};

}  // namespace echolucent
