#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdio>

#include "app/cli/options/option_text.h"
#include "app/cli/options/view_options.h"
#include "processing/beam/beam_guess.h"
#include "processing/beam/probe_view.h"
#include "processing/near_cut/near_cut.h"

namespace echolucent::cli {

void ViewOptions::addTo(CLI::App& command, ViewOf of) {
    const bool ofFile = of != ViewOf::simulatedScan;
    const std::string axis = "Grid axis along which sound travelled, the default view: +x -x +y -y +z -z ";
    command
        .add_option("--beam-axis", beamAxis,
                    axis + (ofFile ? "[guessed from the scan; +z where that is not sure]" : "[+z]"))
        ->type_name("AXIS");
    m_azimuth =
        command
            .add_option("--view-azimuth", view.azimuthDegrees,
                        "Turn of the view about the grid's y axis (with another beam axis: its own frame's), degrees")
            ->type_name("DEG")
            ->capture_default_str();
    m_elevation =
        command
            .add_option("--view-elevation", view.elevationDegrees, "Turn of the view about the grid's x axis, degrees")
            ->type_name("DEG")
            ->capture_default_str();
    if (of == ViewOf::openedStudy)
        command
            .add_option("--side", side,
                        "Side from which the scan is looked into: probe, behind, onto, onto-back, along-left, "
                        "along-right (across-1 to -4 or side-1 to -6, if planes or beam are not sure), or its number "
                        "[the one that shows most]")
            ->type_name("SIDE");
    const std::string cut = "Near cut: nothing nearer than this behind the foremost corner, mm";
    m_near = command
                 .add_option("--near", near,
                             cut + (ofFile ? "; auto: inside the fluid behind a wall" : "") +
                                 (of == ViewOf::openedStudy ? " [the cut found on opening, if it is sure]" : " [0]"))
                 ->type_name(ofFile ? "MM|auto" : "MM");
}

namespace {

/// Without a sign an axis is positive.
std::optional<BeamAxis> axisNamed(const std::string& name) {
    return beamAxisFromName(name.size() == 1 ? "+" + name : name);
}

bool isGiven(const CLI::Option* option) { return option != nullptr && option->count() > 0; }

}  // namespace

bool ViewOptions::isTurned() const { return isGiven(m_azimuth) || isGiven(m_elevation); }

Result<Viewpoint> ViewOptions::get() const {
    if (!beamAxis.empty() && !axisNamed(beamAxis))
        return wrongUsage("--beam-axis", "is \"" + beamAxis + "\"", "Use +x, -x, +y, -y, +z or -z.");
    if (!isAngle(view.azimuthDegrees) || !isAngle(view.elevationDegrees))
        return wrongUsage("--view-azimuth and --view-elevation", mustBeAngles);
    if (!side.empty() && isTurned())
        return wrongUsage("--side", "stands beside a turn of the view: both say from where the scan is looked into",
                          "Give one of them.");
    Viewpoint chosen = view;
    chosen.beamAxis = beam().axis;
    if (!isGiven(m_near) || nearCutSuggested()) return chosen;
    const auto cut = parseNumbers(near, 1, "--near", "18");
    if (!cut || !std::isfinite(cut->front()) || cut->front() < 0.0)
        return wrongUsage("--near", "must be 0 mm or more, or auto");
    return withFrontAcross(chosen, cut->front());
}

Result<Viewpoint> ViewOptions::getOfSimulatedScan() const {
    if (nearCutSuggested())
        return wrongUsage("--near", "must be 0 mm or more",
                          "A near cut is suggested for a volume that is there already.");
    return get();
}

SaidOnOpening ViewOptions::said() const {
    SaidOnOpening said{.beam = axisNamed(beamAxis), .side = side, .front = isGiven(m_near) && !nearCutSuggested()};
    if (isTurned()) said.direction = ViewDirection{view.azimuthDegrees, view.elevationDegrees};
    return said;
}

ChosenBeam ViewOptions::beam() const {
    if (const auto axis = axisNamed(beamAxis)) return {*axis, "option", std::nullopt, ""};
    return {};
}

ChosenBeam ViewOptions::beamOf(const Volume& volume) const {
    if (axisNamed(beamAxis)) return beam();
    const auto guess = guessBeamAxis(volume);
    if (!guess->sure) return {BeamAxis::plusZ, "assumed", guess->confidence, guess->sentence};
    return {guess->axis, std::string(nameOf(guess->evidence)), guess->confidence, guess->sentence};
}

Result<Viewpoint> leavesSomething(const Volume& volume, const Viewpoint& view) {
    const Vec3 forward = frameOf(view).forward;
    const double nearest = volume.geometry().depthsAlong(forward).nearest;
    const DataBox& box = volume.dataBox();
    double depth = box.centreMm().dot(forward) - nearest;
    for (int axis = 0; axis < 3; ++axis) depth += 0.5 * box.sizeMm()[axis] * std::abs(forward[axis]);
    if (frontDepthMm(view) < depth) return view;
    return wrongUsage("--near",
                      fmt::format("is {:.6g} mm, but along this view the volume ends {:.4g} mm behind its foremost "
                                  "corner: nothing is left",
                                  frontDepthMm(view), depth),
                      fmt::format("Give less than {:.4g}.", depth));
}

Result<Viewpoint> ViewOptions::get(const Volume& volume) const { return get(volume, beamOf(volume)); }

Result<Viewpoint> ViewOptions::get(const Volume& volume, const ChosenBeam& beam) const {
    auto chosen = get();
    if (!chosen) return chosen;
    const double depthMm = frontDepthMm(*chosen);
    chosen->beamAxis = beam.axis;
    if (const auto& probe = volume.geometry().probe; probe && beamAxis.empty() && !isTurned())
        chosen = viewFromProbe(*probe);
    chosen = withFrontAcross(*chosen, depthMm);
    if (beam.source != "assumed" && !beam.sentence.empty()) std::fprintf(stderr, "%s\n", beam.sentence.c_str());
    if (!nearCutSuggested()) return leavesSomething(volume, *chosen);
    const auto found = findFlatNearCut(volume, *chosen);
    std::fprintf(stderr, "%s\n", found->message.c_str());
    return withFrontAcross(*chosen, found->nearCutMm);
}

}  // namespace echolucent::cli
