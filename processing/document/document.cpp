#include "processing/document/document.h"

#include <algorithm>
#include <utility>

#include "processing/motion/otf_sweep.h"

namespace echolucent {

int phaseOf(const Document& document, std::size_t pane) {
    return document.panes.at(pane).phase.value_or(document.scene.phase);
}

Pose shownPose(const Document& document) {
    const Scene& scene = document.scene;
    if (scene.motionAngle == 0.0) return scene.pose;
    const Viewpoint start = viewpointOf(document.beam.axis, scene.pose.direction);
    return turnedTo(scene.pose, document.beam.axis,
                    directionOf(turned(start, document.motion.axis, scene.motionAngle)));
}

namespace {

/// The view along a direction (relative to the beam), behind the front and within the box.
Viewpoint limitedView(const Document& document, const ViewDirection& direction) {
    const Scene& scene = document.scene;
    Viewpoint viewpoint = behindFront(viewpointOf(document.beam.axis, direction), scene.front);
    if (scene.box.on) viewpoint.box = orientedBoxOf(scene.box, document.beam.axis);
    return viewpoint;
}

}  // namespace

Viewpoint motionStartOf(const Document& document) { return limitedView(document, document.scene.pose.direction); }

Viewpoint viewpointOf(const Document& document) {
    const double angle = document.scene.motionAngle;
    const Viewpoint start = motionStartOf(document);
    return angle == 0.0 ? start : turned(start, document.motion.axis, angle);
}

Viewpoint otfViewpointOf(const Document& document, std::size_t pane) {
    if (document.panes.at(pane).motionOtf.value_or(MotionOtf::oneOtf) != MotionOtf::oneOtf)
        return viewpointOf(document);
    return limitedView(document, document.scene.side);
}

CurveSet curvesOf(const Document& document, std::size_t pane) {
    CurveSet curves = document.curves;
    if (const auto& own = document.panes.at(pane).linear) curves.linear = *own;
    return curves;
}

OpacityCurve curveOf(const Document& document, std::size_t pane, const SampledCurve& adaptive) {
    return renderedCurve(curvesOf(document, pane), document.panes.at(pane).curve, adaptive);
}

const DesignerConfig* designerConfigOf(const Document& document, std::size_t pane) {
    const auto& designer = document.panes.at(pane).designer;
    return designer ? &*designer : nullptr;
}

AdaptiveOtfConfig configOf(const Document& document) { return configOf(document.method, document.curves); }

AdaptiveOtfConfig configOf(const Document& document, std::size_t pane) {
    const Pane& shown = document.panes.at(pane);
    AdaptiveOtfConfig config = configOf(document);
    if (shown.method) {
        AdaptiveOtfConfig own = *shown.method;
        own.initial = config.initial;
        own.grid.withoutTubes = config.grid.withoutTubes;
        config = std::move(own);
    }
    std::vector<int>& without = config.grid.withoutTubes;
    without.insert(without.end(), shown.withoutTubes.begin(), shown.withoutTubes.end());
    if (shown.method || !shown.withoutTubes.empty())
        std::erase_if(without, [&config](int tube) { return tube >= config.grid.columns * config.grid.rows; });
    std::ranges::sort(without);
    without.erase(std::unique(without.begin(), without.end()), without.end());
    return config;
}

Document withDesigner(Document document, std::size_t pane, const DesignerConfig& config) {
    document.panes.at(pane).designer = config;
    return document;
}

Document withCurve(Document document, std::size_t pane, CurveKind curve) {
    Pane& shown = document.panes.at(pane);
    if (curve != CurveKind::linear) shown.linear.reset();
    shown.curve = curve;
    shown.designer.reset();
    return document;
}

Document withCurves(Document document, std::size_t pane, const CurveSet& curves) {
    std::optional<LinearCurve>& own = document.panes.at(pane).linear;
    const LinearCurve linear = own ? document.curves.linear : curves.linear;
    if (own) own = curves.linear;
    document.curves = curves;
    document.curves.linear = linear;
    return document;
}

Document withShown(Document document, const Document& shown) {
    document.scene.phase = shown.scene.phase;
    document.scene.motionAngle = shown.scene.motionAngle;
    return document;
}

Document openedDocument(const Document& before, const StudyReference& study) {
    Document opened = before;
    opened.study = study;
    opened.beam = Beam{};
    const Planes& planes = before.scene.planes;
    // How grey values are shown does not depend on the study, nor does whether voxels are quiet.
    Scene scene;
    scene.look = before.scene.look;
    scene.planes.window = planes.window;
    scene.planes.level = planes.level;
    scene.planes.quiet = planes.quiet;
    scene.planes.linesIn3d = planes.linesIn3d;
    scene.planes.turnsView = planes.turnsView;
    opened.scene = std::move(scene);
    for (Pane& pane : opened.panes) {
        pane.withoutTubes.clear();
        pane.linear.reset();
        if (pane.phase) pane.phase = 0;
    }
    opened.measurements.clear();
    opened.motion.axis = screenAxisOf(before.motion.axis);
    opened.motion.phaseRange.reset();
    opened.motion.otfPhase = 0;
    opened.curves.adjustment = CurveAdjustment{};  // a first picture is good without it
    opened.method.config.grid.withoutTubes.clear();
    return opened;
}

std::string problemOf(const Document& document) {
    if (const std::string problem = problemOf(document.scene); !problem.empty()) return "scene." + problem;
    if (document.panes.empty() || document.panes.size() > mostPanes) return "panes must hold 1 to 4 panes";
    for (std::size_t i = 0; i < document.panes.size(); ++i)
        if (const std::string problem = problemOf(document.panes[i]); !problem.empty())
            return "panes[" + std::to_string(i) + "]." + problem;
    if (document.panes.front().phase) return "panes[0].phase must be missing: it is that of the scene";
    if (document.panes.front().method) return "panes[0].method must be missing: it is that of the document";
    if (const std::string problem = problemOf(document.comparison, document.panes.size()); !problem.empty())
        return "comparison." + problem;
    for (const Measurement& measurement : document.measurements)
        if (std::ranges::count(document.measurements, measurement.id, &Measurement::id) != 1)
            return "measurements must have an id of its own each";
    for (std::size_t i = 0; i < document.measurements.size(); ++i)
        if (const std::string problem = problemOf(document.measurements[i]); !problem.empty())
            return "measurements[" + std::to_string(i) + "]." + problem;
    if (const std::string problem = problemOf(document.motion); !problem.empty()) return "motion." + problem;
    return {};
}

}  // namespace echolucent
