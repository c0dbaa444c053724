#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/document/session_file.h"
#include "io/files/input_file.h"
#include "io/json/json_design.h"
#include "io/json/json_document.h"
#include "io/json/json_values.h"

namespace echolucent {

namespace {

constexpr std::int64_t largestId = 1'000'000;
/// So many values a list that views refer to may hold: what is asked of each pair of them stays quick.
constexpr std::size_t mostEntries = 1000;
constexpr std::size_t mostPlaces = 200'000;                    // of one stroke
constexpr std::size_t longestChecksum = 200;                   // bytes
constexpr std::int64_t mostSimulated = std::int64_t{1} << 27;  // voxels
constexpr const char* remedyOfDocument = "Correct the file, or save the document again from the program.";

int idIn(JsonFields& fields, const char* key = "id") { return static_cast<int>(fields.whole(key, 0, largestId)); }

StudyReference studyIn(JsonFields root) {
    if (root.isNull("study")) return {};
    JsonFields study = root.object("study");
    if (study.has("simulated_scan")) {
        JsonFields scan = study.object("simulated_scan");
        const SimulatedScan simulated{scan.choice("scene", &phantomSceneFromName), scan.size("size", 1 << 20),
                                      scan.seed("seed")};
        if (simulated.size[0] * simulated.size[1] > mostSimulated / simulated.size[2])
            scan.wrong("size", "must be of at most 512 x 512 x 512 voxels");
        return simulated;
    }
    JsonFields fields = study.object("file");
    StudyFile file;
    file.path = fields.text("path");
    file.options.series = fields.text("series");
    if (!fields.isNull("raw_layout")) {
        JsonFields layout = fields.object("raw_layout");
        file.options.raw = rawLayoutIn(layout);
    }
    file.options.framesAsSlices = fields.flag("frames_as_slices");
    file.options.guessNoData = fields.flag("guess_no_data");
    if (fields.has("conversion_mebibytes"))
        file.options.conversionMebibytes = fields.whole("conversion_mebibytes", 1, mostConversionMebibytes);
    if (fields.has("study_mebibytes"))
        file.options.studyMebibytes = fields.whole("study_mebibytes", 1, mostStudyMebibytes);
    file.checksum = fields.text("checksum");
    if (file.checksum.size() > longestChecksum) fields.wrong("checksum", "must be shorter");
    if (file.path.find('\0') != std::string::npos) fields.wrong("path", "must hold no null character");
    // Documents that were written before studies had checksums have neither.
    if (fields.has("bytes")) file.bytes = fields.whole("bytes", 1, std::numeric_limits<std::int64_t>::max());
    if (fields.has("files")) file.files = fields.whole("files", 1, std::numeric_limits<std::int64_t>::max());
    return file;
}

ViewDirection directionIn(JsonFields fields) {
    return {fields.number("azimuth"), fields.number("elevation", -90, 90), fields.number("roll")};
}

Pose poseIn(JsonFields& fields) {
    return {directionIn(fields.object("direction")), fields.vector("offset_mm"),
            fields.number("magnification", std::numeric_limits<double>::min())};
}

ViewFrame frameIn(JsonFields fields) {
    return {fields.vector("right"), fields.vector("down"), fields.vector("forward")};
}

CutSurface surfaceIn(JsonFields fields) {
    constexpr std::int64_t mostNodes = 1024;
    CutSurface surface;
    surface.frame = frameIn(fields.object("frame"));
    surface.firstRightMm = fields.number("first_right_mm");
    surface.firstDownMm = fields.number("first_down_mm");
    surface.spacingMm = fields.number("spacing_mm");
    surface.columns = static_cast<int>(fields.whole("columns", 2, mostNodes));
    surface.rows = static_cast<int>(fields.whole("rows", 2, mostNodes));
    for (const double depth : fields.numbers("depth_mm")) surface.depthMm.push_back(static_cast<float>(depth));
    return surface;
}

Cut cutIn(JsonFields& fields) {
    Cut cut{.nearCutMm = fields.number("near_cut_mm", 0)};
    cut.source = fields.choice("source", &cutSourceFromName);
    if (!fields.isNull("surface")) cut.surface = surfaceIn(fields.object("surface"));
    return cut;
}

Box boxIn(JsonFields& fields) {
    Box box{.on = fields.flag("on")};
    box.direction = directionIn(fields.object("direction"));
    box.centreMm = fields.vector("centre_mm");
    box.sizeMm = fields.vector("size_mm");
    box.front = fields.choice("front", &boxSideFromName);
    return box;
}

Planes planesIn(JsonFields& fields) {
    Planes planes;
    planes.direction = directionIn(fields.object("direction"));
    planes.offsetMm = fields.vector("offset_mm");
    JsonFields crops = fields.object("crops");
    for (const PlaneName plane : allPlaneNames) {
        JsonFields crop = crops.object(std::string(nameOf(plane)).c_str());
        planes.crops[indexOf(plane)] = {crop.number("pan_right_mm"), crop.number("pan_down_mm"),
                                        crop.number("magnification", std::numeric_limits<double>::min())};
    }
    planes.window = fields.number("window", leastPlaneWindow, largestPlaneWindow);
    planes.level = fields.number("level", leastPlaneLevel, largestPlaneLevel);
    planes.quiet = fields.flag("quiet");
    planes.linesIn3d = fields.flag("lines_in_3d");
    return planes;
}

Camera cameraIn(JsonFields fields) {
    Camera camera;
    camera.focalPoint = fields.vector("focal_point_mm");
    camera.frame = frameIn(fields.object("frame"));
    camera.projection = fields.choice("projection", &projectionFromName);
    camera.heightMm = fields.number("height_mm");
    camera.viewAngleDegrees = fields.number("view_angle");
    camera.distanceMm = fields.number("distance_mm");
    return camera;
}

Strokes strokesIn(JsonFields& fields) {
    Strokes strokes;
    for (JsonFields& each : fields.list("strokes", mostStrokes)) {
        ScalpelStroke stroke;
        stroke.tool = each.choice("tool", &scalpelToolFromName);
        stroke.side = each.choice("side", &scalpelSideFromName);
        stroke.camera = cameraIn(each.object("camera"));
        stroke.places = each.pairs("places", mostPlaces);
        stroke.radius = each.number("radius", 0);
        if (!each.isNull("depth_mm")) stroke.depthMm = each.number("depth_mm");
        strokes.list.push_back(std::move(stroke));
    }
    return strokes;
}

int phaseIn(JsonFields& fields) { return static_cast<int>(fields.whole("phase", 0, largestId)); }

template <typename Value>
std::vector<Shared<Value>> listIn(JsonFields& root, const char* key, Value (*valueIn)(JsonFields&)) {
    std::vector<Shared<Value>> list;
    for (JsonFields& fields : root.list(key, mostEntries)) list.push_back({idIn(fields), valueIn(fields)});
    return list;
}

std::vector<View> viewsIn(JsonFields& root) {
    std::vector<View> views;
    for (JsonFields& fields : root.list("views", mostEntries)) {
        views.push_back({idIn(fields), idIn(fields, "pose"), idIn(fields, "cut"), idIn(fields, "look"),
                         idIn(fields, "phase"), fields.choice("curve", &curveKindFromName), idIn(fields, "box"),
                         idIn(fields, "planes"), idIn(fields, "strokes")});
        // Documents that were written before there were designers have neither.
        if (fields.has("design")) views.back().design = idIn(fields, "design");
        if (fields.has("without_tubes"))
            for (const std::int64_t tube : fields.wholes("without_tubes", 0, largestId))
                views.back().withoutTubes.push_back(static_cast<int>(tube));
        if (fields.has("motion_otf")) views.back().motionOtf = fields.choice("motion_otf", &motionOtfFromName);
    }
    return views;
}

MotionChoice motionIn(JsonFields& fields) {
    MotionChoice motion{.axis = fields.choice("axis", &motionAxisFromName),
                        .scenario = fields.choice("scenario", &motionScenarioFromName),
                        .otf = fields.choice("otf", &motionOtfFromName),
                        .pingPong = fields.flag("ping_pong")};
    motion.phasesPingPong = fields.flag("phases_ping_pong");
    if (!fields.isNull("phase_range")) {
        JsonFields range = fields.object("phase_range");
        motion.phaseRange = {static_cast<int>(range.whole("first", 0, largestId)),
                             static_cast<int>(range.whole("last", 0, largestId))};
    }
    motion.otfPhase = static_cast<int>(fields.whole("otf_phase", 0, largestId));
    motion.speed = fields.number("speed", leastMotionSpeed, largestMotionSpeed);
    return motion;
}

Comparison comparisonIn(JsonFields fields) {
    Comparison comparison;
    for (const std::int64_t view : fields.wholes("panes", 0, largestId))
        comparison.panes.push_back(static_cast<int>(view));
    comparison.layout = fields.choice("layout", &comparisonLayoutFromName);
    comparison.first = static_cast<int>(fields.whole("first", 0, static_cast<std::int64_t>(mostPanes) - 1));
    comparison.second = static_cast<int>(fields.whole("second", 0, static_cast<std::int64_t>(mostPanes) - 1));
    comparison.wipe = fields.number("wipe", 0, 1);
    comparison.amplification = fields.number("amplification", leastAmplification, largestAmplification);
    return comparison;
}

std::vector<Measurement> measurementsIn(JsonFields& root) {
    std::vector<Measurement> measurements;
    for (JsonFields& fields : root.list("measurements", mostMeasurements))
        measurements.push_back({idIn(fields), fields.choice("kind", &measurementKindFromName),
                                fields.choice("ground", &measurementGroundFromName), fields.vectors("places_mm"),
                                phaseIn(fields)});
    return measurements;
}

Document documentIn(JsonFields root) {
    Document document;
    document.study = studyIn(root);
    JsonFields beam = root.object("beam");
    document.beam = {beam.choice("axis", &beamAxisFromName), beam.choice("source", &beamSourceFromName),
                     directionIn(beam.object("lean"))};
    document.views = viewsIn(root);
    document.poses = listIn(root, "poses", &poseIn);
    document.cuts = listIn(root, "cuts", &cutIn);
    document.looks = listIn(root, "looks", &lookIn);
    document.boxes = listIn(root, "boxes", &boxIn);
    document.planes = listIn(root, "planes", &planesIn);
    document.strokes = listIn(root, "strokes", &strokesIn);
    document.measurements = measurementsIn(root);
    document.phases = listIn(root, "phases", &phaseIn);
    document.curves = curvesIn(root.object("curves"));
    if (root.has("designs")) document.designs = listIn(root, "designs", &designIn);
    JsonFields method = root.object("method");
    document.method = methodIn(method);
    document.method.direction = directionIn(method.object("direction"));
    JsonFields motion = root.object("motion");
    document.motion = motionIn(motion);
    document.motionAngle = motion.number("angle", firstMotionAngle, lastMotionAngle);
    // Documents that were written before panes were compared have none.
    if (root.has("comparison")) document.comparison = comparisonIn(root.object("comparison"));
    return document;
}

Result<nlohmann::json> rootOf(std::string_view text, const std::string& file) {
    return jsonObject(text, file, std::string(documentFormatName), remedyOfDocument);
}

Result<Document> documentOf(const nlohmann::json& object, const std::string& place, const std::string& file) {
    JsonProblems problems{file, std::nullopt};
    Document document = documentIn(JsonFields(object, place, problems));
    if (problems.first) return problems.refused(remedyOfDocument);
    if (const std::string problem = problemOf(document); !problem.empty())
        return fail(FailureKind::unreadable, file, place, problem, remedyOfDocument);
    return document;
}

}  // namespace

Result<Document> documentFromJson(std::string_view text, const std::string& file) {
    const auto object = rootOf(text, file);
    if (!object) return tl::unexpected(object.error());
    return documentOf(*object, {}, file);
}

Result<Document> readDocument(const std::string& path) {
    const auto text = readWholeFile(path, largestDocumentFile);
    if (!text) return tl::unexpected(text.error());
    return documentFromJson(*text, path);
}

Result<SavedSession> sessionFromJson(std::string_view text, const std::string& file) {
    const auto object = rootOf(text, file);
    if (!object) return tl::unexpected(object.error());
    auto document = documentOf(*object, {}, file);
    if (!document) return tl::unexpected(document.error());
    SavedSession session{.document = std::move(*document)};
    if (!object->contains("session")) return session;
    JsonProblems problems{file, std::nullopt};
    JsonFields fields = JsonFields(*object, {}, problems).object("session");
    if (fields.has("file")) session.file = fields.text("file");
    std::vector<JsonFields> snapshots = fields.list("snapshots", mostSnapshots);
    for (std::size_t i = 0; i < snapshots.size() && !problems.first; ++i) {
        Snapshot snapshot;
        snapshot.name = snapshots[i].text("name");
        if (const std::string problem = problemOfSnapshotName(snapshot.name); !problem.empty())
            snapshots[i].wrong("name", problem);
        (void)snapshots[i].object("document");  // says where it is missing
        if (problems.first) break;
        auto read = documentOf((*object)["session"]["snapshots"][i]["document"],
                               "session.snapshots[" + std::to_string(i) + "].document", file);
        if (!read) return tl::unexpected(read.error());
        snapshot.document = std::move(*read);
        snapshot.document.study = session.document.study;
        session.snapshots.push_back(std::move(snapshot));
    }
    if (problems.first) return problems.refused(remedyOfDocument);
    return session;
}

Result<SavedSession> readSession(const std::string& path) {
    const auto text = readWholeFile(path, largestDocumentFile);
    if (!text) return tl::unexpected(text.error());
    return sessionFromJson(*text, path);
}

}  // namespace echolucent
