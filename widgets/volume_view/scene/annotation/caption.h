// Words in the picture that say what was done to it.
#pragma once

#include <vtkNew.h>

#include <string>

class vtkRenderer;
class vtkTextActor;

namespace echolucent {

/// The caption stands in the upper left corner of the picture and is saved with the picture. The text may have several
/// lines; those that are too wide for the picture are broken (captionWithin()).
class Caption {
public:
    Caption();
    ~Caption();
    void addTo(vtkRenderer* renderer);
    /// An empty text shows nothing.
    void setText(const std::string& text);
    [[nodiscard]] const std::string& text() const { return m_said; }
    /// Sizes in device pixels; `scale`: device pixels per pixel of a plain screen.
    void layOut(int viewportWidth, int viewportHeight, double scale);
    void setVisible(bool visible);

private:
    vtkNew<vtkTextActor> m_text;
    vtkRenderer* m_renderer = nullptr;
    std::string m_said;
    std::string m_brokenFor;            ///< the text that was broken last
    double m_room = 0.0, m_dots = 0.0;  ///< for which width, and at which resolution
};

}  // namespace echolucent
