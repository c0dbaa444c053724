// A line of text in the picture that says what was done to it.
#pragma once

#include <vtkNew.h>

#include <string>

class vtkRenderer;
class vtkTextActor;

namespace echolucent {

/// The caption stands in the upper left corner of the picture and is saved with the picture. The text may have several
/// lines.
class Caption {
public:
    Caption();
    ~Caption();
    void addTo(vtkRenderer* renderer);
    /// An empty text shows nothing.
    void setText(const std::string& text);
    [[nodiscard]] const std::string& text() const { return m_said; }
    /// Sizes in device pixels; `scale`: device pixels per pixel of a plain screen.
    void layOut(int viewportHeight, double scale);
    void setVisible(bool visible);

private:
    vtkNew<vtkTextActor> m_text;
    std::string m_said;
};

}  // namespace echolucent
