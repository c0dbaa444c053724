// How long things are in the picture: a bar of a round number of millimetres.
#pragma once

#include <vtkNew.h>

#include <string>

#include "widgets/volume_view/scene/annotation/smooth_lines.h"

class vtkRenderer;
class vtkTextActor;

namespace echolucent {

/// It stands in the lower right corner of the picture. Where the volume's spacing is unknown no length is claimed: it
/// says so instead.
class ScaleBar {
public:
    ScaleBar();
    ~ScaleBar();
    void addTo(vtkRenderer* renderer);
    /// Sizes in device pixels; `scale` is the number of them per pixel of a plain screen.
    void layOut(int viewportWidth, int viewportHeight, double scale, double heightMm, bool spacingKnown);
    void setVisible(bool visible);
    /// What it says: "10 mm", or that the spacing is unknown.
    [[nodiscard]] const std::string& text() const { return m_said; }
    /// Length of the bar in device pixels; 0 where there is none.
    [[nodiscard]] double lengthPixels() const { return m_lengthPixels; }

private:
    SmoothLines m_lines;
    vtkNew<vtkTextActor> m_text;
    std::string m_said;
    double m_lengthPixels = 0.0;
};

}  // namespace echolucent
