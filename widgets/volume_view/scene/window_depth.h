// Depths in grid mm and the depths that OpenGL keeps for a window.
#pragma once

class vtkCamera;

namespace echolucent {

/// Turns depths of OpenGL's window, 0 on the camera's near clipping plane and 1 on the far one, into depths along the
/// direction in which the camera looks (mm from the grid origin, as in DepthMap). It holds for the camera as it was
/// when this was made, parallel or perspective.
class WindowDepth {
public:
    explicit WindowDepth(vtkCamera& camera);

    [[nodiscard]] double mmOf(double windowDepth) const;
    // What a shader needs to do the reverse.
    [[nodiscard]] bool parallel() const { return m_parallel; }
    [[nodiscard]] double eyeMm() const { return m_eyeMm; }    ///< depth of the camera's position
    [[nodiscard]] double nearMm() const { return m_nearMm; }  ///< clipping planes, from the camera's position
    [[nodiscard]] double farMm() const { return m_farMm; }

private:
    bool m_parallel = true;
    double m_eyeMm = 0.0, m_nearMm = 0.0, m_farMm = 1.0;
};

}  // namespace echolucent
