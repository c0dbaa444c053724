#include <cmath>

#include "io/document/document_file.h"
#include "io/document/json_fields.h"
#include "io/output/atomic_file.h"
#include "processing/adaptive/method_parameters.h"

namespace echolucent {

namespace {

using nlohmann::json;

constexpr std::int64_t largestId = 1'000'000;
constexpr std::int64_t largestSize = 1'000'000;
constexpr std::size_t largestFile = std::size_t{16} << 20;
constexpr const char* remedy = "Correct the file, or save the document again from the program.";

int idIn(JsonFields& fields, const char* key = "id") { return static_cast<int>(fields.whole(key, 0, largestId)); }

std::array<std::int64_t, 3> sizeIn(JsonFields& fields) {
    const Vec3 size = fields.vector("size");
    std::array<std::int64_t, 3> whole{1, 1, 1};
    for (int axis = 0; axis < 3; ++axis) {
        const auto edge = static_cast<std::size_t>(axis);
        if (size[axis] >= 1 && size[axis] <= static_cast<double>(largestSize) && size[axis] == std::floor(size[axis]))
            whole[edge] = static_cast<std::int64_t>(size[axis]);
        else
            fields.wrong("size", "must be whole numbers from 1 on");
    }
    return whole;
}

RawLayout rawLayoutIn(JsonFields fields) {
    RawLayout layout;
    layout.size = sizeIn(fields);
    layout.type = fields.text("type");
    layout.bigEndian = fields.flag("big_endian");
    layout.headerBytes = fields.whole("header_bytes", 0, std::numeric_limits<std::int64_t>::max());
    layout.spacing = fields.vector("spacing_mm");
    for (int axis = 0; axis < 3; ++axis)
        if (!(layout.spacing[axis] > 0)) fields.wrong("spacing_mm", "must be above 0");
    layout.spacingKnown = fields.flag("spacing_known");
    return layout;
}

StudyReference studyIn(JsonFields root) {
    if (root.isNull("study")) return {};
    JsonFields study = root.object("study");
    if (study.has("simulated_scan")) {
        JsonFields scan = study.object("simulated_scan");
        return SimulatedScan{scan.choice("scene", &phantomSceneFromName), sizeIn(scan), scan.seed("seed")};
    }
    JsonFields fields = study.object("file");
    StudyFile file;
    file.path = fields.text("path");
    file.series = fields.text("series");
    if (!fields.isNull("raw_layout")) file.options.raw = rawLayoutIn(fields.object("raw_layout"));
    file.options.framesAsSlices = fields.flag("frames_as_slices");
    file.options.guessNoData = fields.flag("guess_no_data");
    file.checksum = fields.text("checksum");
    return file;
}

ViewDirection directionIn(JsonFields fields) {
    return {fields.number("azimuth"), fields.number("elevation", -90, 90), fields.number("roll")};
}

Pose poseIn(JsonFields& fields) {
    return {directionIn(fields.object("direction")), fields.vector("offset_mm"),
            fields.number("magnification", std::numeric_limits<double>::min())};
}

Cut cutIn(JsonFields& fields) { return {fields.number("near_cut_mm", 0)}; }

Look lookIn(JsonFields& fields) {
    Look look = lookAtStart();
    fields.parameters(lookParameters(), look);
    return look;
}

int phaseIn(JsonFields& fields) { return static_cast<int>(fields.whole("phase", 0, largestId)); }

template <typename Value>
std::vector<Shared<Value>> listIn(JsonFields& root, const char* key, Value (*valueIn)(JsonFields&)) {
    std::vector<Shared<Value>> list;
    for (JsonFields& fields : root.list(key)) list.push_back({idIn(fields), valueIn(fields)});
    return list;
}

std::vector<View> viewsIn(JsonFields& root) {
    std::vector<View> views;
    for (JsonFields& fields : root.list("views"))
        views.push_back({idIn(fields), idIn(fields, "pose"), idIn(fields, "cut"), idIn(fields, "look"),
                         idIn(fields, "phase"), fields.choice("curve", &curveKindFromName)});
    return views;
}

ManualCurve manualIn(JsonFields& fields) {
    ManualCurve curve;
    for (JsonFields& node : fields.list("manual")) {
        curve.nodes.push_back({node.number("intensity", 0, 1), node.number("opacity", 0, 1)});
        const std::size_t count = curve.nodes.size();
        if (count > 1 && curve.nodes[count - 1].intensity < curve.nodes[count - 2].intensity)
            node.wrong("intensity", "must not be below the one before it");
    }
    if (curve.nodes.empty()) fields.wrong("manual", "must be a list of at least one node");
    return curve;
}

CurveSet curvesIn(JsonFields fields) {
    CurveSet curves;
    curves.manual = manualIn(fields);
    JsonFields linear = fields.object("linear");
    curves.linear.lower = linear.number("lower", 0, 1);
    curves.linear.slope = linear.number("slope", 0);
    curves.linear.upper = linear.number("upper", curves.linear.lower, 1);
    curves.parabolic.scale = fields.object("parabolic").number("scale", 0);
    curves.quartic.scale = fields.object("quartic").number("scale", 0);
    return curves;
}

MethodChoice methodIn(JsonFields fields) {
    MethodChoice method;
    method.initial = fields.choice("initial", &initialKindFromName);
    method.initialScale = fields.number("initial_scale", 0);
    method.direction = directionIn(fields.object("direction"));
    JsonFields parameters = fields.object("parameters");
    parameters.parameters(methodParameters(), method.config);
    method.config.initial = AdaptiveOtfConfig{}.initial;
    if (const std::string problem = problemOf(method.config); !problem.empty()) fields.wrong("parameters", problem);
    return method;
}

MotionChoice motionIn(JsonFields& fields) {
    return {fields.choice("axis", &motionAxisFromName), fields.choice("scenario", &motionScenarioFromName),
            fields.choice("otf", &motionOtfFromName), fields.flag("ping_pong")};
}

Document documentIn(JsonFields root) {
    Document document;
    document.study = studyIn(root);
    JsonFields beam = root.object("beam");
    document.beam = {beam.choice("axis", &beamAxisFromName), beam.choice("source", &beamSourceFromName)};
    document.views = viewsIn(root);
    document.poses = listIn(root, "poses", &poseIn);
    document.cuts = listIn(root, "cuts", &cutIn);
    document.looks = listIn(root, "looks", &lookIn);
    document.phases = listIn(root, "phases", &phaseIn);
    document.curves = curvesIn(root.object("curves"));
    document.method = methodIn(root.object("method"));
    JsonFields motion = root.object("motion");
    document.motion = motionIn(motion);
    document.motionAngle = motion.number("angle", firstMotionAngle, lastMotionAngle);
    return document;
}

}  // namespace

Result<Document> documentFromJson(std::string_view text, const std::string& file) {
    const auto refuse = [&](const std::string& key, const std::string& problem) {
        return fail(FailureKind::unreadable, file, key, problem, remedy);
    };
    json object;
    try {
        object = json::parse(text);
    } catch (const json::exception&) {  // also numbers that are too large
        return refuse({}, "is not JSON");
    }
    if (!object.is_object()) return refuse({}, "must be a JSON object");
    if (object.value("format", json()) != "echolucent-document")
        return refuse("format", "must be \"echolucent-document\"");
    if (object.value("version", json()) != 1)
        return refuse("version", "must be 1, not " + object.value("version", json()).dump());
    JsonProblems problems{file, std::nullopt};
    Document document = documentIn(JsonFields(object, {}, problems));
    if (problems.first) return refuse(problems.first->element, problems.first->problem);
    if (const std::string problem = problemOf(document); !problem.empty()) return refuse({}, problem);
    return document;
}

Result<Document> readDocument(const std::string& path) {
    const auto text = readWholeFile(path, largestFile);
    if (!text) return tl::unexpected(text.error());
    return documentFromJson(*text, path);
}

}  // namespace echolucent
