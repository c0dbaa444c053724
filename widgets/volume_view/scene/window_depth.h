// Depths in grid mm and the depths that OpenGL keeps for a window.
#pragma once

class vtkCamera;

namespace echolucent {

/// Turns depths along the direction a camera looks in (mm from the grid origin, as in DepthMap) into depths of OpenGL's
/// window, 0 on the camera's near clipping plane and 1 on the far one, and back. Holds for the camera as it was when
/// this was made, parallel or perspective.
class WindowDepth {
public:
    explicit WindowDepth(vtkCamera& camera);

    [[nodiscard]] double mmOf(double windowDepth) const;
    /// The value is not clamped: it is below 0 before the near plane. In perspective `mm` counts from the eye.
    [[nodiscard]] double windowDepthOf(double mm) const;

    // The same as a shader needs it.
    [[nodiscard]] bool parallel() const { return m_parallel; }
    [[nodiscard]] double eyeMm() const { return m_eyeMm; }    ///< depth of the camera's position
    [[nodiscard]] double nearMm() const { return m_nearMm; }  ///< clipping planes, from the camera's position
    [[nodiscard]] double farMm() const { return m_farMm; }

private:
    bool m_parallel = true;
    double m_eyeMm = 0.0, m_nearMm = 0.0, m_farMm = 1.0;
};

}  // namespace echolucent
