#include <cmath>

#include "app/cli/command.h"

namespace echolucent::cli {

void ViewOptions::addTo(CLI::App& command) {
    command
        .add_option("--beam-axis", beamAxis,
                    "Grid axis along which sound travelled, the default view: +x -x +y -y +z -z")
        ->type_name("AXIS")
        ->capture_default_str();
    command.add_option("--view-azimuth", view.azimuthDegrees, "Turn of the view about the grid's y axis (with another beam axis: its own frame's), degrees")
        ->type_name("DEG")
        ->capture_default_str();
    command.add_option("--view-elevation", view.elevationDegrees, "Turn of the view about the grid's x axis, degrees")
        ->type_name("DEG")
        ->capture_default_str();
    command.add_option("--near", view.nearCutMm, "Near cut: nothing nearer than this behind the foremost corner, mm")
        ->type_name("MM")
        ->capture_default_str();
}

Result<View> ViewOptions::get() const {
    const bool signMissing = beamAxis.size() == 1;
    const auto axis = beamAxisFromName(signMissing ? "+" + beamAxis : beamAxis);
    if (!axis)
        return fail(FailureKind::wrongUsage, "", "--beam-axis", "is \"" + beamAxis + "\"",
                    "Use +x, -x, +y, -y, +z or -z.");
    // Beyond, a double has no degrees left to tell one angle from the next.
    if (!(std::abs(view.azimuthDegrees) <= 36000.0) || !(std::abs(view.elevationDegrees) <= 36000.0))
        return fail(FailureKind::wrongUsage, "", "--view-azimuth and --view-elevation",
                    "must be angles in degrees, -36000 to 36000");
    if (!std::isfinite(view.nearCutMm) || view.nearCutMm < 0.0)
        return fail(FailureKind::wrongUsage, "", "--near", "must be 0 mm or more");
    View chosen = view;
    chosen.beamAxis = *axis;
    return chosen;
}

}  // namespace echolucent::cli
