// Everything that a person can set about what the program shows, as one flat value. What is computed from it (adaptive
// curves, pictures) is no part of it.
#pragma once

#include <string>
#include <vector>

#include "processing/document/comparison.h"
#include "processing/document/curve_set.h"
#include "processing/document/method_choice.h"
#include "processing/document/pane.h"
#include "processing/document/study_reference.h"
#include "processing/motion/motion_choice.h"
#include "processing/scene/measurement.h"
#include "processing/scene/scene.h"
#include "processing/shared_list.h"

namespace echolucent {

/// The pane of the 3D view. It shows the scene's phase.
inline constexpr std::size_t firstPane = 0;

/// The default is what the program shows of a study that was just opened.
struct Document {
    StudyReference study;
    Beam beam;
    Scene scene;
    std::vector<Pane> panes{Pane{}};  ///< one to mostPanes; several are compared
    Comparison comparison;            ///< how several panes are compared
    SharedList<Measurement> measurements{};
    CurveSet curves;
    MethodChoice method;
    MotionChoice motion;
    friend bool operator==(const Document&, const Document&) = default;
};

// ---- What follows from the parts. Functions with a pane, also those below, throw std::out_of_range if there is no
// such pane.

/// The phase that a pane shows: its own, or that of the scene.
[[nodiscard]] int phaseOf(const Document& document, std::size_t pane);
/// The pose, turned by the motion if the motion's angle is not 0.
[[nodiscard]] Pose shownPose(const Document& document);
/// From where the panes look now: the shown pose behind the front, within the box.
[[nodiscard]] Viewpoint viewpointOf(const Document& document);
/// viewpointOf() before the motion turned it.
[[nodiscard]] Viewpoint motionStartOf(const Document& document);
/// From where the adaptive OTF of a pane is computed: from the scene's side behind the front, within the box. If the
/// pane itself asks for other than one OTF (Pane::motionOtf), the result is viewpointOf().
[[nodiscard]] Viewpoint otfViewpointOf(const Document& document, std::size_t pane);
/// The curves of the document, with the pane's own piecewise linear curve in its place if it has one.
[[nodiscard]] CurveSet curvesOf(const Document& document, std::size_t pane);
/// The adjusted curve that a pane is rendered with if it has no designer. `adaptive` is as in curveOf(CurveSet, ...).
[[nodiscard]] OpacityCurve curveOf(const Document& document, std::size_t pane, const SampledCurve& adaptive);
/// The designer, with its parameters, that a pane is rendered with; null if it is rendered with a curve.
[[nodiscard]] const DesignerConfig* designerConfigOf(const Document& document, std::size_t pane);
/// The config for adaptOpacity().
[[nodiscard]] AdaptiveOtfConfig configOf(const Document& document);
/// The same for a pane, with Pane::method if it has one. Pane::withoutTubes join the tube cores that the method never
/// places. If the pane has a method or such tube cores of its own, numbers that the grid does not hold are dropped.
[[nodiscard]] AdaptiveOtfConfig configOf(const Document& document, std::size_t pane);

// ---- Changes

[[nodiscard]] Document withDesigner(Document document, std::size_t pane, const DesignerConfig& config);
/// The document in which a pane is rendered with a curve and no designer. If that is another kind of curve than before,
/// the pane's own piecewise linear curve goes.
[[nodiscard]] Document withCurve(Document document, std::size_t pane, CurveKind curve);
/// The document whose curvesOf() a pane are these. If the pane has a piecewise linear curve of its own, that one is
/// changed, and the document keeps its own.
[[nodiscard]] Document withCurves(Document document, std::size_t pane, const CurveSet& curves);
/// The document with the phase and the frame of the motion that another document shows.
[[nodiscard]] Document withShown(Document document, const Document& shown);
/// A document of another study. It keeps the look, curves, panes, comparison, method parameters and motion choices of
/// `before`, and how planes show grey values and their lines, and whether they turn the view. It does not keep the
/// curves' adjustment, choices that count phases, and the tube cores that are never placed. A pane with a phase of its
/// own shows the first one, and no pane has a piecewise linear curve of its own. The study is seen along the assumed
/// beam, whole, from its first phase on, without front, box, strokes and measurements.
[[nodiscard]] Document openedDocument(const Document& before, const StudyReference& study);

/// What breaks a rule, with its key ("scene.box size_mm must be ..."): lower case, no full stop. Empty if nothing does.
[[nodiscard]] std::string problemOf(const Document& document);

}  // namespace echolucent
