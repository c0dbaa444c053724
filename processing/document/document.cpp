#include "processing/document/document.h"

#include <algorithm>
#include <stdexcept>

#include "processing/choice_names.h"
#include "processing/designers/designer.h"
#include "processing/motion/otf_sweep.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<2> cutSourceNames{"person", "found"};

template <typename List>
auto& withId(List& list, int id, const char* what) {
    const auto found = std::ranges::find(list, id, [](const auto& entry) { return entry.id; });
    if (found == list.end()) throw std::out_of_range(std::string("the document has no ") + what + " of this id");
    return *found;
}

template <typename List>
bool has(const List& list, int id) {
    return std::ranges::any_of(list, [id](const auto& entry) { return entry.id == id; });
}

template <typename List>
bool unique(const List& list) {
    return std::ranges::all_of(list, [&](const auto& entry) {
        return std::ranges::count(list, entry.id, [](const auto& other) { return other.id; }) == 1;
    });
}

}  // namespace

std::string_view nameOf(CutSource source) { return nameIn(cutSourceNames, source); }

std::optional<CutSource> cutSourceFromName(std::string_view name) {
    return choiceNamed<CutSource>(cutSourceNames, name);
}

const View& viewOf(const Document& document, int view) { return withId(document.views, view, "view"); }
View& viewOf(Document& document, int view) { return withId(document.views, view, "view"); }

const Pose& poseOf(const Document& document, int view) {
    return withId(document.poses, viewOf(document, view).pose, "pose").value;
}
Pose& poseOf(Document& document, int view) { return withId(document.poses, viewOf(document, view).pose, "pose").value; }

const Cut& cutOf(const Document& document, int view) {
    return withId(document.cuts, viewOf(document, view).cut, "cut").value;
}
Cut& cutOf(Document& document, int view) { return withId(document.cuts, viewOf(document, view).cut, "cut").value; }

const Look& lookOf(const Document& document, int view) {
    return withId(document.looks, viewOf(document, view).look, "look").value;
}
Look& lookOf(Document& document, int view) { return withId(document.looks, viewOf(document, view).look, "look").value; }

const Box& boxOf(const Document& document, int view) {
    return withId(document.boxes, viewOf(document, view).box, "box").value;
}
Box& boxOf(Document& document, int view) { return withId(document.boxes, viewOf(document, view).box, "box").value; }

const Planes& planesOf(const Document& document, int view) {
    return withId(document.planes, viewOf(document, view).planes, "planes").value;
}
Planes& planesOf(Document& document, int view) {
    return withId(document.planes, viewOf(document, view).planes, "planes").value;
}

const std::vector<ScalpelStroke>& strokesOf(const Document& document, int view) {
    return withId(document.strokes, viewOf(document, view).strokes, "strokes").value.list;
}
std::vector<ScalpelStroke>& strokesOf(Document& document, int view) {
    return withId(document.strokes, viewOf(document, view).strokes, "strokes").value.list;
}

int phaseOf(const Document& document, int view) {
    return withId(document.phases, viewOf(document, view).phase, "phase").value;
}
int& phaseOf(Document& document, int view) {
    return withId(document.phases, viewOf(document, view).phase, "phase").value;
}

Pose shownPose(const Document& document, int view) {
    const Pose& pose = poseOf(document, view);
    if (document.motionAngle == 0.0) return pose;
    const Viewpoint start = viewpointOf(document.beam.axis, pose.direction, 0.0);
    return turnedTo(pose, document.beam.axis, directionOf(turned(start, document.motion.axis, document.motionAngle)));
}

namespace {

/// A direction, relative to the beam, behind a view's cut and within its box.
Viewpoint cutLike(const Document& document, int view, const ViewDirection& direction) {
    const Cut& cut = cutOf(document, view);
    const Box& box = boxOf(document, view);
    Viewpoint viewpoint = viewpointOf(document.beam.axis, direction, cut.nearCutMm);
    viewpoint.cutSurface = cut.surface;
    if (box.on) viewpoint.box = orientedBoxOf(box, document.beam.axis);
    return viewpoint;
}

}  // namespace

Viewpoint viewpointOf(const Document& document, int view) {
    const Viewpoint start = cutLike(document, view, poseOf(document, view).direction);
    return document.motionAngle == 0.0 ? start : turned(start, document.motion.axis, document.motionAngle);
}

Viewpoint otfViewpointOf(const Document& document, int view) {
    if (viewOf(document, view).motionOtf.value_or(MotionOtf::oneOtf) != MotionOtf::oneOtf)
        return viewpointOf(document, view);
    return cutLike(document, view, document.method.direction);
}

OpacityCurve curveOf(const Document& document, int view, const SampledCurve& adaptive) {
    return renderedCurve(document.curves, viewOf(document, view).curve, adaptive);
}

const DesignerConfig* designOf(const Document& document, int view) {
    const int design = viewOf(document, view).design;
    return design == 0 ? nullptr : &withId(document.designs, design, "design").value;
}

namespace {

void removeUnusedDesigns(Document& document) {
    std::erase_if(document.designs, [&](const Shared<DesignerConfig>& design) {
        return std::ranges::none_of(document.views, [&](const View& view) { return view.design == design.id; });
    });
}

}  // namespace

Document withDesign(Document document, int view, const DesignerConfig& config) {
    View& shown = viewOf(document, view);
    if (shown.design == 0) {
        int free = 1;
        while (has(document.designs, free)) ++free;
        shown.design = free;
        document.designs.push_back({free, config});
    } else {
        withId(document.designs, shown.design, "design").value = config;
    }
    removeUnusedDesigns(document);
    return document;
}

Document withCurve(Document document, int view, CurveKind curve) {
    viewOf(document, view).curve = curve;
    viewOf(document, view).design = 0;
    removeUnusedDesigns(document);
    return document;
}

AdaptiveOtfConfig configOf(const Document& document) { return configOf(document.method, document.curves); }

AdaptiveOtfConfig configOf(const Document& document, int view) {
    AdaptiveOtfConfig config = configOf(document);
    std::vector<int>& without = config.grid.withoutTubes;
    for (const int tube : viewOf(document, view).withoutTubes)
        if (tube < config.grid.columns * config.grid.rows) without.push_back(tube);
    std::ranges::sort(without);
    without.erase(std::unique(without.begin(), without.end()), without.end());
    return config;
}

Document withShown(Document document, const Document& shown) {
    const int played = viewOf(document, has(document.views, mainView) ? mainView : document.views.front().id).phase;
    for (Shared<int>& phase : document.phases)
        if (phase.id == played && has(shown.phases, phase.id))
            phase.value = withId(shown.phases, phase.id, "phase").value;
    document.motionAngle = shown.motionAngle;
    return document;
}

Document openedDocument(const Document& before, const StudyReference& study) {
    Document opened = before;
    opened.study = study;
    opened.beam = Beam{};
    for (Shared<Pose>& pose : opened.poses) pose.value = Pose{};
    for (Shared<Cut>& cut : opened.cuts) cut.value = Cut{};
    for (Shared<Box>& box : opened.boxes) box.value = Box{};
    for (Shared<Planes>& planes : opened.planes) {
        // How grey values are shown, and which voxels, is no matter of the study.
        const Planes& kept = planes.value;
        planes.value =
            Planes{.window = kept.window, .level = kept.level, .quiet = kept.quiet, .linesIn3d = kept.linesIn3d};
    }
    for (auto& strokes : opened.strokes) strokes.value.list.clear();
    opened.measurements.clear();
    for (View& view : opened.views) view.withoutTubes.clear();
    for (Shared<int>& phase : opened.phases) phase.value = 0;
    opened.motion.phaseRange.reset();
    opened.motion.otfPhase = 0;
    opened.curves.adjustment = CurveAdjustment{};  // a first picture is right without it
    opened.method.direction = ViewDirection{};
    opened.method.config.grid.withoutTubes.clear();
    opened.motionAngle = 0.0;
    return opened;
}

namespace {

std::string problemOfPanes(const Document& document) {
    const std::vector<int>& panes = document.comparison.panes;
    if (!panes.empty() && panes.front() != mainView) return "the first of panes must be view 1";
    for (const int pane : panes) {
        if (!has(document.views, pane)) return "panes names no view";
        const View& view = viewOf(document, pane);
        const View& first = viewOf(document, panes.front());
        if (view.pose != first.pose || view.cut != first.cut || view.look != first.look || view.box != first.box ||
            view.planes != first.planes || view.strokes != first.strokes)
            return "panes must name views that share pose, cut, look, box, planes and strokes";
    }
    return {};
}

}  // namespace

std::string problemOf(const Document& document) {
    if (document.views.empty()) return "views must hold at least one view";
    if (!unique(document.views)) return "views must have an id of its own each";
    if (!unique(document.poses)) return "poses must have an id of its own each";
    if (!unique(document.cuts)) return "cuts must have an id of its own each";
    if (!unique(document.looks)) return "looks must have an id of its own each";
    if (!unique(document.boxes)) return "boxes must have an id of its own each";
    if (!unique(document.planes)) return "planes must have an id of its own each";
    if (!unique(document.strokes)) return "strokes must have an id of its own each";
    if (!unique(document.phases)) return "phases must have an id of its own each";
    if (!unique(document.designs)) return "designs must have an id of its own each";
    if (has(document.designs, 0)) return "designs must have ids from 1 on";
    for (std::size_t i = 0; i < document.designs.size(); ++i)
        if (const std::string problem = problemOf(document.designs[i].value); !problem.empty())
            return "designs[" + std::to_string(i) + "]: " + problem;
    if (!unique(document.measurements)) return "measurements must have an id of its own each";
    if (const std::string problem = problemOf(document.motion); !problem.empty()) return "motion." + problem;
    for (std::size_t i = 0; i < document.measurements.size(); ++i)
        if (const std::string problem = problemOf(document.measurements[i]); !problem.empty())
            return "measurements[" + std::to_string(i) + "]." + problem;
    for (std::size_t i = 0; i < document.boxes.size(); ++i)
        if (const std::string problem = problemOf(document.boxes[i].value); !problem.empty())
            return "boxes[" + std::to_string(i) + "] " + problem;
    for (std::size_t i = 0; i < document.strokes.size(); ++i)
        for (std::size_t k = 0; k < document.strokes[i].value.list.size(); ++k)
            if (const std::string problem = problemOf(document.strokes[i].value.list[k]); !problem.empty())
                return "strokes[" + std::to_string(i) + "].strokes[" + std::to_string(k) + "] " + problem;
    for (std::size_t i = 0; i < document.cuts.size(); ++i)
        if (const auto& surface = document.cuts[i].value.surface; surface && !problemOf(*surface).empty())
            return "cuts[" + std::to_string(i) + "].surface " + problemOf(*surface);
    for (std::size_t i = 0; i < document.views.size(); ++i) {
        const View& view = document.views[i];
        const std::string place = "views[" + std::to_string(i) + "].";
        if (!has(document.poses, view.pose)) return place + "pose names no pose";
        if (!has(document.cuts, view.cut)) return place + "cut names no cut";
        if (!has(document.looks, view.look)) return place + "look names no look";
        if (!has(document.phases, view.phase)) return place + "phase names no phase";
        if (!has(document.boxes, view.box)) return place + "box names no box";
        if (!has(document.planes, view.planes)) return place + "planes names no planes";
        if (!has(document.strokes, view.strokes)) return place + "strokes names no strokes";
        if (view.design != 0 && !has(document.designs, view.design)) return place + "design names no design";
        if (std::ranges::any_of(view.withoutTubes, [](int tube) { return tube < 0; }))
            return place + "without_tubes must hold numbers from 0 on";
    }
    if (const std::string problem = problemOf(document.comparison); !problem.empty()) return "comparison." + problem;
    if (const std::string problem = problemOfPanes(document); !problem.empty()) return "comparison." + problem;
    return {};
}

}  // namespace echolucent
