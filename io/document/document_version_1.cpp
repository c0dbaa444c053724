#include "io/document/document_version_1.h"

#include <algorithm>
#include <string>
#include <vector>

#include "io/document/document_parts.h"
#include "io/json/json_design.h"
#include "io/json/json_document.h"

namespace echolucent {

namespace {

/// The most entries of a list that views refer to. With so few, comparing each pair of entries stays quick.
constexpr std::size_t mostEntries = 1000;

/// A value that views refer to by its id.
template <typename Value>
struct Listed {
    int id = 1;
    Value value{};
};

/// A picture of the study. It refers to the lists by id; views that share an id are linked.
struct View {
    int id = 1;
    int pose = 1, cut = 1, look = 1, phase = 1;
    CurveKind curve = CurveKind::adaptive;
    int box = 1, planes = 1, strokes = 1;
    int design = 0;  ///< 0 is none
    std::vector<int> withoutTubes{};
    std::optional<MotionOtf> motionOtf{};
};

struct Lists {
    std::vector<View> views;
    std::vector<Listed<Pose>> poses;
    std::vector<Listed<Front>> cuts;
    std::vector<Listed<Look>> looks;
    std::vector<Listed<Box>> boxes;
    std::vector<Listed<Planes>> planes;
    std::vector<Listed<std::vector<ScalpelStroke>>> strokes;
    std::vector<Listed<int>> phases;
    std::vector<Listed<DesignerConfig>> designs;
    std::vector<int> compared;  ///< ids of views
};

int idIn(JsonFields& fields, const char* key = "id") { return static_cast<int>(fields.whole(key, 0, largestNumber)); }

Front cutIn(JsonFields& fields) {
    Front cut{.depthMm = fields.number("near_cut_mm", 0)};
    cut.source = fields.choice("source", &frontSourceFromName);
    if (!fields.isNull("surface")) cut.surface = surfaceIn(fields.object("surface"));
    return cut;
}

template <typename Value>
std::vector<Listed<Value>> listIn(JsonFields& root, const char* key, Value (*valueIn)(JsonFields&)) {
    std::vector<Listed<Value>> list;
    for (JsonFields& fields : root.list(key, mostEntries)) list.push_back({idIn(fields), valueIn(fields)});
    return list;
}

std::vector<View> viewsIn(JsonFields& root) {
    std::vector<View> views;
    for (JsonFields& fields : root.list("views", mostEntries)) {
        views.push_back({idIn(fields), idIn(fields, "pose"), idIn(fields, "cut"), idIn(fields, "look"),
                         idIn(fields, "phase"), fields.choice("curve", &curveKindFromName), idIn(fields, "box"),
                         idIn(fields, "planes"), idIn(fields, "strokes")});
        // Some documents lack these keys.
        if (fields.has("design")) views.back().design = idIn(fields, "design");
        if (fields.has("without_tubes"))
            for (const std::int64_t tube : fields.wholes("without_tubes", 0, largestNumber))
                views.back().withoutTubes.push_back(static_cast<int>(tube));
        if (fields.has("motion_otf")) views.back().motionOtf = fields.choice("motion_otf", &motionOtfFromName);
    }
    return views;
}

Lists listsIn(JsonFields& root) {
    Lists lists{.views = viewsIn(root),
                .poses = listIn(root, "poses", &poseIn),
                .cuts = listIn(root, "cuts", &cutIn),
                .looks = listIn(root, "looks", &lookIn),
                .boxes = listIn(root, "boxes", &boxIn),
                .planes = listIn(root, "planes", &planesIn),
                .strokes = listIn(root, "strokes", &strokesIn),
                .phases = listIn(root, "phases", &phaseIn),
                .designs = {},
                .compared = {}};
    if (root.has("designs")) lists.designs = listIn(root, "designs", &designIn);
    return lists;
}

template <typename List>
auto find(const List& list, int id) {
    return std::ranges::find(list, id, [](const auto& entry) { return entry.id; });
}

template <typename List>
bool has(const List& list, int id) {
    return find(list, id) != list.end();
}

template <typename List>
bool unique(const List& list) {
    return std::ranges::all_of(list, [&](const auto& entry) {
        return std::ranges::count(list, entry.id, [](const auto& other) { return other.id; }) == 1;
    });
}

/// Notes the first id that stands twice or that names nothing.
void checkIds(JsonFields& root, const Lists& lists) {
    const auto check = [&root](const char* key, const auto& list) {
        if (!unique(list)) root.wrong(key, "must have an id of its own each");
    };
    if (lists.views.empty()) root.wrong("views", "must hold at least one view");
    check("views", lists.views);
    check("poses", lists.poses);
    check("cuts", lists.cuts);
    check("looks", lists.looks);
    check("boxes", lists.boxes);
    check("planes", lists.planes);
    check("strokes", lists.strokes);
    check("phases", lists.phases);
    check("designs", lists.designs);
    if (has(lists.designs, 0)) root.wrong("designs", "must have ids from 1 on");
    for (std::size_t i = 0; i < lists.views.size(); ++i) {
        const View& view = lists.views[i];
        const auto names = [&](const char* what, const auto& list, int id) {
            const std::string key = "views[" + std::to_string(i) + "]." + what;
            if (!has(list, id)) root.wrong(key.c_str(), std::string("names no ") + what);
        };
        names("pose", lists.poses, view.pose);
        names("cut", lists.cuts, view.cut);
        names("look", lists.looks, view.look);
        names("phase", lists.phases, view.phase);
        names("box", lists.boxes, view.box);
        names("planes", lists.planes, view.planes);
        names("strokes", lists.strokes, view.strokes);
        if (view.design != 0) names("design", lists.designs, view.design);
    }
}

/// Notes wrong designs, boxes, strokes and surfaces of cuts, also those that no view refers to.
void checkValues(JsonFields& root, const Lists& lists) {
    const auto check = [&root](const char* key, std::size_t place, const std::string& problem) {
        if (!problem.empty()) root.wrong((std::string(key) + "[" + std::to_string(place) + "]").c_str(), problem);
    };
    for (std::size_t i = 0; i < lists.designs.size(); ++i)
        check("designs", i, problemOf(Pane{.designer = lists.designs[i].value}));
    for (std::size_t i = 0; i < lists.boxes.size(); ++i) check("boxes", i, problemOf(lists.boxes[i].value));
    for (std::size_t i = 0; i < lists.strokes.size(); ++i)
        for (std::size_t k = 0; k < lists.strokes[i].value.size(); ++k)
            check(("strokes[" + std::to_string(i) + "].strokes").c_str(), k, problemOf(lists.strokes[i].value[k]));
    for (std::size_t i = 0; i < lists.cuts.size(); ++i)
        if (const auto& surface = lists.cuts[i].value.surface)
            if (const std::string problem = problemOf(*surface); !problem.empty())
                root.wrong(("cuts[" + std::to_string(i) + "].surface").c_str(), problem);
}

bool shareScene(const View& one, const View& other) {
    return one.pose == other.pose && one.cut == other.cut && one.look == other.look && one.box == other.box &&
           one.planes == other.planes && one.strokes == other.strokes;
}

Comparison comparedIn(JsonFields fields, Lists& lists) {
    constexpr int firstOfPanes = 1;  // the view that the window showed
    for (const std::int64_t view : fields.wholes("panes", 0, largestNumber))
        lists.compared.push_back(static_cast<int>(view));
    std::vector<int>& panes = lists.compared;
    const auto wrong = [&](const std::string& problem) {
        fields.wrong("panes", problem);
        panes.clear();
    };
    if (!panes.empty() && (panes.size() < fewestPanes || panes.size() > mostPanes))
        wrong("must hold 2 to 4 views, or none");
    else if (std::ranges::any_of(panes, [&](int view) { return std::ranges::count(panes, view) > 1; }))
        wrong("must hold each view once");
    else if (!panes.empty() && panes.front() != firstOfPanes)
        wrong("must begin with view 1");
    else if (std::ranges::any_of(panes, [&](int view) { return !has(lists.views, view); }))
        wrong("names no view");
    else if (std::ranges::any_of(panes, [&](int view) {
                 return !shareScene(*find(lists.views, view), *find(lists.views, panes.front()));
             }))
        wrong("must name views that share pose, cut, look, box, planes and strokes");
    return comparisonIn(fields);
}

Pane paneOf(const Lists& lists, const View& view, const View& first) {
    Pane pane{.curve = view.curve, .withoutTubes = view.withoutTubes, .motionOtf = view.motionOtf};
    if (view.design != 0) pane.designer = find(lists.designs, view.design)->value;
    if (view.phase != first.phase) pane.phase = find(lists.phases, view.phase)->value;
    return pane;
}

void takeView(DocumentPane& read, const Lists& lists, const View& view) {
    const bool compared = std::ranges::find(lists.compared, view.id) != lists.compared.end();
    const std::vector<int> shown = compared ? lists.compared : std::vector<int>{view.id};
    const View& first = *find(lists.views, shown.front());
    Scene& scene = read.document.scene;
    scene.pose = find(lists.poses, first.pose)->value;
    scene.front = find(lists.cuts, first.cut)->value;
    // It lay across the view, whatever the motion had turned that to.
    if (scene.front.depthMm > 0.0) scene.front.direction = shownPose(read.document).direction;
    scene.look = find(lists.looks, first.look)->value;
    scene.box = find(lists.boxes, first.box)->value;
    scene.planes = find(lists.planes, first.planes)->value;
    scene.strokes = find(lists.strokes, first.strokes)->value;
    scene.phase = find(lists.phases, first.phase)->value;
    read.document.panes.clear();
    for (const int id : shown) read.document.panes.push_back(paneOf(lists, *find(lists.views, id), first));
    read.pane = static_cast<std::size_t>(std::ranges::find(shown, view.id) - shown.begin());
    Comparison& comparison = read.document.comparison;
    const auto places = static_cast<int>(std::max(shown.size(), fewestPanes));
    if (comparison.first >= places || comparison.second >= places) {
        comparison.first = Comparison{}.first;
        comparison.second = Comparison{}.second;
    }
}

}  // namespace

std::optional<DocumentPane> paneInVersion1(JsonFields root, const ViewOfVersion1& which) {
    DocumentPane read;
    Document& document = read.document;
    document.study = studyIn(root);
    document.beam = beamIn(root.object("beam"));
    Lists lists = listsIn(root);
    document.measurements = measurementsIn(root);
    document.curves = curvesIn(root.object("curves"));
    JsonFields method = root.object("method");
    document.method = methodIn(method);
    document.scene.side = directionIn(method.object("direction"));
    JsonFields motion = root.object("motion");
    document.motion = motionIn(motion);
    document.scene.motionAngle = motion.number("angle", firstMotionAngle, lastMotionAngle);
    if (root.failed()) return read;
    checkIds(root, lists);
    if (root.failed()) return read;
    checkValues(root, lists);
    // Some documents lack this key.
    if (root.has("comparison")) document.comparison = comparedIn(root.object("comparison"), lists);
    if (root.failed()) return read;
    const View* view = &lists.views.front();
    if (which.id || which.windows) {
        const auto found = find(lists.views, which.id.value_or(1));
        if (found == lists.views.end() && which.id) return std::nullopt;
        if (found != lists.views.end()) view = &*found;
    }
    takeView(read, lists, *view);
    return read;
}

}  // namespace echolucent
