#include "widgets/volume_view/scene/window_depth.h"

#include <vtkCamera.h>

#include "processing/volume/geometry.h"

namespace echolucent {

WindowDepth::WindowDepth(vtkCamera& camera)
    : m_parallel(camera.GetParallelProjection() != 0),
      m_eyeMm(Vec3(camera.GetPosition()).dot(normalized(Vec3(camera.GetDirectionOfProjection())))),
      m_nearMm(camera.GetClippingRange()[0]),
      m_farMm(camera.GetClippingRange()[1]) {}

double WindowDepth::mmOf(double windowDepth) const {
    if (m_parallel) return m_eyeMm + m_nearMm + windowDepth * (m_farMm - m_nearMm);
    return m_eyeMm + m_nearMm * m_farMm / (m_farMm - windowDepth * (m_farMm - m_nearMm));
}

}  // namespace echolucent
