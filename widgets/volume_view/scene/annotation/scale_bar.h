// Shows how long things are in the picture, with a bar of a round number of millimetres.
#pragma once

#include <vtkNew.h>

#include <string>

#include "widgets/volume_view/scene/annotation/smooth_lines.h"

class vtkRenderer;
class vtkTextActor;

namespace echolucent {

/// The scale bar stands in the lower right corner of the picture. If the volume's spacing is unknown, words say so in
/// place of a bar, and no length is shown.
class ScaleBar {
public:
    ScaleBar();
    ~ScaleBar();
    void addTo(vtkRenderer* renderer);
    /// Sizes in device pixels; `scale`: device pixels per pixel of a plain screen.
    void layOut(int viewportWidth, int viewportHeight, double scale, double heightMm, bool spacingKnown);
    void setVisible(bool visible);
    /// The words: "10 mm", or that the spacing is unknown.
    [[nodiscard]] const std::string& text() const { return m_said; }
    /// Length of the bar in device pixels; 0 if there is none.
    [[nodiscard]] double lengthPixels() const { return m_lengthPixels; }

private:
    SmoothLines m_lines;
    vtkNew<vtkTextActor> m_text;
    std::string m_said;
    double m_lengthPixels = 0.0;
};

}  // namespace echolucent
