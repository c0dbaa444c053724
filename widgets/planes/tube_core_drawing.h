// Tube cores over a plane (Petersch 2005, Fig. 3).
#pragma once

#include <QPointF>
#include <memory>
#include <optional>

#include "processing/explanation/tube_core_marks.h"
#include "widgets/planes/plane_mapping.h"

class QPainter;

namespace echolucent {

/// The tube cores that planes show; none without marks.
struct PlaneTubeCores {
    std::shared_ptr<const TubeCoreMarks> marks{};
    std::optional<int> chosen{};
    friend bool operator==(const PlaneTubeCores&, const PlaneTubeCores&) = default;
};

/// Paints the outlines of the tube cores that a plane shows (shownInPlane()), each with a short white line at the
/// surface that it found. The chosen one is white, thicker, and has its number.
void paintTubeCores(QPainter& painter, const PlaneTubeCores& tubeCores, const PlaneMapping& mapping);

/// The number of the tube core that a plane shows at a pixel, or less than `reach` pixels from it. Of several the one
/// with the nearest axis.
[[nodiscard]] std::optional<int> tubeCoreAt(const PlaneTubeCores& tubeCores, const PlaneMapping& mapping,
                                            const QPointF& pixel, double reach = 4.0);

}  // namespace echolucent
