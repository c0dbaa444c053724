// Everything that a person can set of what the program shows, as one value. What is computed from it (adaptive curves,
// pictures) is no part of it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "processing/cut_surface.h"
#include "processing/designers/designer_config.h"
#include "processing/document/box.h"
#include "processing/document/comparison.h"
#include "processing/document/curve_set.h"
#include "processing/document/measurement.h"
#include "processing/document/method_choice.h"
#include "processing/document/planes.h"
#include "processing/document/pose.h"
#include "processing/document/study_reference.h"
#include "processing/motion/motion_choice.h"
#include "processing/picture/look.h"
#include "processing/scalpel/scalpel_stroke.h"

namespace echolucent {

/// Who chose where to cut.
enum class CutSource {
    person,  ///< chosen in the program
    found,   ///< made on opening, by the search for the cut
};
/// "person", "found".
[[nodiscard]] std::string_view nameOf(CutSource source);
[[nodiscard]] std::optional<CutSource> cutSourceFromName(std::string_view name);

/// What is cut off in front.
struct Cut {
    double nearCutMm = 0.0;  ///< nothing nearer than this behind the volume's foremost point along the view; >= 0
    std::optional<CutSurface> surface{};  ///< what lies before it is cut off too; it does not turn with the view
    CutSource source = CutSource::person;
    friend bool operator==(const Cut&, const Cut&) = default;
};

/// What the scalpel cut, in the order in which it was drawn.
struct Strokes {
    std::vector<ScalpelStroke> list{};
    friend bool operator==(const Strokes&, const Strokes&) = default;
};

/// A value that views refer to by its id. Ids are unique in each list.
template <typename Value>
struct Shared {
    int id = 1;
    Value value{};
    friend bool operator==(const Shared&, const Shared&) = default;
};

/// A picture of the study: what it shows of the lists below, by id. Views that share an id are linked.
struct View {
    int id = 1;
    int pose = 1;
    int cut = 1;
    int look = 1;
    int phase = 1;
    CurveKind curve = CurveKind::adaptive;  ///< the curve that is rendered
    int box = 1;
    int planes = 1;
    int strokes = 1;
    int design = 0;  ///< of Document::designs: the designer whose OTF is rendered in the curve's place; 0 is none
    /// Row-major numbers of tube cores that are never placed for this view's adaptive OTF, beside those of the method
    /// (TubeGrid::withoutTubes).
    std::vector<int> withoutTubes{};
    /// Which OTF the frames of a motion show in this view; no value: that of the document's motion.
    std::optional<MotionOtf> motionOtf{};
    friend bool operator==(const View&, const View&) = default;
};

/// The view of the default document, which the 3D view shows.
inline constexpr int mainView = 1;

/// The default is what the program shows of a study that was opened and not touched.
struct Document {
    StudyReference study;
    Beam beam;
    std::vector<View> views{View{}};
    std::vector<Shared<Pose>> poses{{}};
    std::vector<Shared<Cut>> cuts{{}};
    std::vector<Shared<Look>> looks{{1, lookAtStart()}};
    std::vector<Shared<Box>> boxes{{}};
    std::vector<Shared<Planes>> planes{{}};
    std::vector<Shared<Strokes>> strokes{{}};
    std::vector<Measurement> measurements{};  ///< of the volume: every view shows them
    CurveSet curves;
    std::vector<Shared<DesignerConfig>> designs{};  ///< of the designers that views are rendered with
    MethodChoice method;
    MotionChoice motion;
    Comparison comparison;  ///< its panes share pose, cut, look, box, planes and strokes
    // What plays. Showing another phase or frame is no step of the undo stack (withShown()).
    std::vector<Shared<int>> phases{{}};  ///< of the 4D study, counted from 0
    double motionAngle = 0.0;             ///< degrees by which the motion has turned the poses
    friend bool operator==(const Document&, const Document&) = default;
};

// ---- Parts by id. An id that is not there is a broken contract (std::out_of_range).

[[nodiscard]] const View& viewOf(const Document& document, int view);
[[nodiscard]] View& viewOf(Document& document, int view);
[[nodiscard]] const Pose& poseOf(const Document& document, int view);
[[nodiscard]] Pose& poseOf(Document& document, int view);
[[nodiscard]] const Cut& cutOf(const Document& document, int view);
[[nodiscard]] Cut& cutOf(Document& document, int view);
[[nodiscard]] const Look& lookOf(const Document& document, int view);
[[nodiscard]] Look& lookOf(Document& document, int view);
[[nodiscard]] const Box& boxOf(const Document& document, int view);
[[nodiscard]] Box& boxOf(Document& document, int view);
[[nodiscard]] const Planes& planesOf(const Document& document, int view);
[[nodiscard]] Planes& planesOf(Document& document, int view);
[[nodiscard]] const std::vector<ScalpelStroke>& strokesOf(const Document& document, int view);
[[nodiscard]] std::vector<ScalpelStroke>& strokesOf(Document& document, int view);
[[nodiscard]] int phaseOf(const Document& document, int view);
[[nodiscard]] int& phaseOf(Document& document, int view);

// ---- What follows from the parts

/// The pose of a view, turned by the motion where it is not at angle 0.
[[nodiscard]] Pose shownPose(const Document& document, int view);
/// From where a view looks now: its shown pose, its cut and its box.
[[nodiscard]] Viewpoint viewpointOf(const Document& document, int view);
/// From where the adaptive OTF of a view is computed: the method's direction, the view's cut and its box; where the
/// view itself asks for an OTF of each frame (View::motionOtf), viewpointOf().
[[nodiscard]] Viewpoint otfViewpointOf(const Document& document, int view);
/// The curve that a view is rendered with where it has no design, adjusted; `adaptive` as in curveOf(CurveSet, ...).
[[nodiscard]] OpacityCurve curveOf(const Document& document, int view, const SampledCurve& adaptive);
/// The designer that a view is rendered with, as it is configured; null where it is rendered with a curve.
[[nodiscard]] const DesignerConfig* designOf(const Document& document, int view);
/// The document in which a view is rendered with a designer: a view of its own design keeps that one, which becomes
/// `config`; else a design is added. Designs that no view refers to are removed.
[[nodiscard]] Document withDesign(Document document, int view, const DesignerConfig& config);
/// The document in which a view is rendered with a curve and no design.
[[nodiscard]] Document withCurve(Document document, int view, CurveKind curve);
/// What adaptOpacity() is to be run with.
[[nodiscard]] AdaptiveOtfConfig configOf(const Document& document);
/// The same for a view, without the tube cores that are never placed for it. Those that its grid does not hold are left
/// out.
[[nodiscard]] AdaptiveOtfConfig configOf(const Document& document, int view);

/// The document with the phase that plays, which is that of the main view (of the first, where there is no main one),
/// and the frame of the motion that another document shows, as far as both have them. The phases of other views are
/// choices.
[[nodiscard]] Document withShown(Document document, const Document& shown);

/// A document of another study: the look, curves, method parameters and motion choices of `before`, those that
/// count phases and the tube cores that are never placed aside, seen along the assumed beam, whole, uncut, without a
/// box, strokes and measurements, from its first phase on.
[[nodiscard]] Document openedDocument(const Document& before, const StudyReference& study);

/// What breaks a rule between parts, lower case, no full stop ("views[0].pose names no pose"); an empty text where
/// nothing does.
[[nodiscard]] std::string problemOf(const Document& document);

}  // namespace echolucent
