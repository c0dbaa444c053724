// What a view shows of the lines along it.
#pragma once

#include <optional>
#include <vector>

#include "processing/viewpoint/cut_surface.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/geometry.h"

namespace echolucent {

/// The stretches of lines along a view that lie within the volume's box and the view's box, and behind its front, flat
/// or bowed. Rays and tube cores begin and end there.
class ShownStretches {
public:
    ShownStretches(const Viewpoint& view, const VolumeGeometry& geometry);
    /// The stretch of the line through a point (grid mm), in mm along the view's forward from the point. If the line
    /// passes through a bowed front several times, the stretch is the first part behind it. Empty if nothing is shown.
    [[nodiscard]] std::optional<CutSurface::Stretch> of(const Vec3& pointMm) const;

private:
    Vec3 m_forward, m_low, m_high;
    double m_nearDepth;
    std::vector<CuttingFace> m_faces;  ///< of the view's box and of a flat front that does not lie across the view
    std::optional<CutSurface> m_cutSurface;
};

}  // namespace echolucent
