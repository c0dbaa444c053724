#include <fmt/format.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "io/document/session_file.h"
#include "io/json/json_design.h"
#include "io/json/json_document.h"
#include "io/json/json_values.h"
#include "io/output/atomic_file.h"

namespace echolucent {

namespace {

using nlohmann::ordered_json;

ordered_json triple(const Vec3& vector) { return ordered_json::array({vector[0], vector[1], vector[2]}); }

ordered_json studyJson(const StudyReference& study) {
    if (const auto* file = std::get_if<StudyFile>(&study)) {
        ordered_json raw;
        if (file->options.raw) raw = rawLayoutJson(*file->options.raw);
        ordered_json object{{"path", file->path},
                            {"series", file->options.series},
                            {"raw_layout", raw},
                            {"frames_as_slices", file->options.framesAsSlices},
                            {"guess_no_data", file->options.guessNoData},
                            {"checksum", file->checksum}};
        if (file->bytes > 0) object["bytes"] = file->bytes;
        if (file->files > 0) object["files"] = file->files;
        if (file->options.conversionMebibytes != ReadOptions{}.conversionMebibytes)
            object["conversion_mebibytes"] = file->options.conversionMebibytes;
        if (file->options.studyMebibytes) object["study_mebibytes"] = *file->options.studyMebibytes;
        return {{"file", object}};
    }
    if (const auto* scan = std::get_if<SimulatedScan>(&study))
        return {{"simulated_scan", {{"scene", nameOf(scan->scene)}, {"size", scan->size}, {"seed", scan->seed}}}};
    return nullptr;
}

ordered_json directionJson(const ViewDirection& direction) {
    return {{"azimuth", direction.azimuth}, {"elevation", direction.elevation}, {"roll", direction.roll}};
}

ordered_json poseJson(const Pose& pose) {
    return {{"direction", directionJson(pose.direction)},
            {"offset_mm", triple(pose.offsetMm)},
            {"magnification", pose.magnification}};
}

ordered_json frameJson(const ViewFrame& frame) {
    return {{"right", triple(frame.right)}, {"down", triple(frame.down)}, {"forward", triple(frame.forward)}};
}

ordered_json surfaceJson(const CutSurface& surface) {
    return {{"frame", frameJson(surface.frame)},    {"first_right_mm", surface.firstRightMm},
            {"first_down_mm", surface.firstDownMm}, {"spacing_mm", surface.spacingMm},
            {"columns", surface.columns},           {"rows", surface.rows},
            {"depth_mm", surface.depthMm}};
}

ordered_json cutJson(const Cut& cut) {
    return {{"near_cut_mm", cut.nearCutMm},
            {"source", nameOf(cut.source)},
            {"surface", cut.surface ? surfaceJson(*cut.surface) : ordered_json()}};
}

ordered_json boxJson(const Box& box) {
    return {{"on", box.on},
            {"direction", directionJson(box.direction)},
            {"centre_mm", triple(box.centreMm)},
            {"size_mm", triple(box.sizeMm)},
            {"front", nameOf(box.front)}};
}

ordered_json planesJson(const Planes& planes) {
    ordered_json crops = ordered_json::object();
    for (const PlaneName plane : allPlaneNames) {
        const PlaneCrop& crop = planes.crops[indexOf(plane)];
        crops[std::string(nameOf(plane))] = {
            {"pan_right_mm", crop.panRightMm}, {"pan_down_mm", crop.panDownMm}, {"magnification", crop.magnification}};
    }
    return {{"direction", directionJson(planes.direction)},
            {"offset_mm", triple(planes.offsetMm)},
            {"crops", crops},
            {"window", planes.window},
            {"level", planes.level},
            {"quiet", planes.quiet},
            {"lines_in_3d", planes.linesIn3d}};
}

ordered_json cameraJson(const Camera& camera) {
    return {{"focal_point_mm", triple(camera.focalPoint)}, {"frame", frameJson(camera.frame)},
            {"projection", nameOf(camera.projection)},     {"height_mm", camera.heightMm},
            {"view_angle", camera.viewAngleDegrees},       {"distance_mm", camera.distanceMm}};
}

ordered_json strokesJson(const Strokes& strokes) {
    ordered_json list = ordered_json::array();
    for (const ScalpelStroke& stroke : strokes.list) {
        ordered_json object{{"tool", nameOf(stroke.tool)},
                            {"side", nameOf(stroke.side)},
                            {"camera", cameraJson(stroke.camera)},
                            {"places", stroke.places},
                            {"radius", stroke.radius}};
        object["depth_mm"] = stroke.depthMm ? ordered_json(*stroke.depthMm) : ordered_json();
        list.push_back(std::move(object));
    }
    return {{"strokes", list}};
}

template <typename Value>
ordered_json listJson(const std::vector<Shared<Value>>& list, ordered_json (*valueJson)(const Value&)) {
    ordered_json entries = ordered_json::array();
    for (const Shared<Value>& entry : list) {
        ordered_json object{{"id", entry.id}};
        object.update(valueJson(entry.value));
        entries.push_back(std::move(object));
    }
    return entries;
}

ordered_json viewsJson(const std::vector<View>& views) {
    ordered_json entries = ordered_json::array();
    for (const View& view : views) {
        entries.push_back({{"id", view.id},
                           {"pose", view.pose},
                           {"cut", view.cut},
                           {"look", view.look},
                           {"phase", view.phase},
                           {"curve", nameOf(view.curve)},
                           {"box", view.box},
                           {"planes", view.planes},
                           {"strokes", view.strokes}});
        // Most views have neither.
        if (view.design != 0) entries.back()["design"] = view.design;
        if (!view.withoutTubes.empty()) entries.back()["without_tubes"] = view.withoutTubes;
        if (view.motionOtf) entries.back()["motion_otf"] = nameOf(*view.motionOtf);
    }
    return entries;
}

ordered_json motionJson(const Document& document) {
    const MotionChoice& motion = document.motion;
    ordered_json range;
    if (motion.phaseRange) range = {{"first", motion.phaseRange->first}, {"last", motion.phaseRange->last}};
    return {{"axis", nameOf(motion.axis)},
            {"scenario", nameOf(motion.scenario)},
            {"otf", nameOf(motion.otf)},
            {"ping_pong", motion.pingPong},
            {"phases_ping_pong", motion.phasesPingPong},
            {"phase_range", range},
            {"otf_phase", motion.otfPhase},
            {"speed", motion.speed},
            {"angle", document.motionAngle}};
}

ordered_json measurementsJson(const std::vector<Measurement>& measurements) {
    ordered_json entries = ordered_json::array();
    for (const Measurement& measurement : measurements) {
        ordered_json places = ordered_json::array();
        for (const Vec3& place : measurement.placesMm) places.push_back(triple(place));
        entries.push_back({{"id", measurement.id},
                           {"kind", nameOf(measurement.kind)},
                           {"ground", nameOf(measurement.ground)},
                           {"places_mm", places},
                           {"phase", measurement.phase}});
    }
    return entries;
}

ordered_json comparisonJson(const Comparison& comparison) {
    return {{"panes", comparison.panes}, {"layout", nameOf(comparison.layout)},
            {"first", comparison.first}, {"second", comparison.second},
            {"wipe", comparison.wipe},   {"amplification", comparison.amplification}};
}

ordered_json phasesJson(const std::vector<Shared<int>>& phases) {
    ordered_json entries = ordered_json::array();
    for (const Shared<int>& phase : phases) entries.push_back({{"id", phase.id}, {"phase", phase.value}});
    return entries;
}

ordered_json documentJson(const Document& document) {
    ordered_json object{{"format", documentFormatName}, {"version", 1}};
    object["study"] = studyJson(document.study);
    object["beam"] = {{"axis", nameOf(document.beam.axis)},
                      {"source", nameOf(document.beam.source)},
                      {"lean", directionJson(document.beam.lean)}};
    object["views"] = viewsJson(document.views);
    object["poses"] = listJson(document.poses, &poseJson);
    object["cuts"] = listJson(document.cuts, &cutJson);
    object["looks"] = listJson(document.looks, &lookJson);
    object["boxes"] = listJson(document.boxes, &boxJson);
    object["planes"] = listJson(document.planes, &planesJson);
    object["strokes"] = listJson(document.strokes, &strokesJson);
    object["measurements"] = measurementsJson(document.measurements);
    object["phases"] = phasesJson(document.phases);
    object["curves"] = curvesJson(document.curves);
    if (!document.designs.empty()) object["designs"] = listJson(document.designs, &designJson);
    object["method"] = methodJson(document.method);
    object["method"]["direction"] = directionJson(document.method.direction);
    object["motion"] = motionJson(document);
    if (document.comparison != Comparison{}) object["comparison"] = comparisonJson(document.comparison);
    return object;
}

ordered_json sessionJson(const SavedSession& session) {
    ordered_json object = documentJson(session.document);
    ordered_json snapshots = ordered_json::array();
    for (const Snapshot& snapshot : session.snapshots) {
        Document document = snapshot.document;
        document.study = {};  // the session says it
        snapshots.push_back({{"name", snapshot.name}, {"document", documentJson(document)}});
    }
    object["session"] = {{"snapshots", snapshots}};
    if (!session.file.empty()) object["session"]["file"] = session.file;
    return object;
}

/// What the reader would refuse for its number is not written.
Result<void> requireReadable(const std::string& path, const Document& document) {
    const auto tooMany = [&](const char* what, std::size_t most) {
        return fail(FailureKind::unwritable, path, what,
                    fmt::format("are more than {}, so that the file could not be opened again", most),
                    "Remove some of them, and save again.");
    };
    if (document.measurements.size() > mostMeasurements) return tooMany("measurements", mostMeasurements);
    for (const auto& strokes : document.strokes)
        if (strokes.value.list.size() > mostStrokes) return tooMany("strokes", mostStrokes);
    return {};
}

Result<void> writeJson(const std::string& path, const std::function<ordered_json()>& make) {
    try {
        const std::string text = make().dump(2) + "\n";
        if (text.size() > largestDocumentFile)
            return fail(FailureKind::unwritable, path, "", "would be too large to be opened again",
                        "Remove snapshots or strokes, and save again.");
        return writeFileAtomically(path, text, OutputKind::session);
    } catch (const ordered_json::exception&) {
        return fail(FailureKind::unwritable, path, "study",
                    "names a file whose name is not UTF-8, which JSON cannot hold",
                    "Rename the file of the study, and open it again.");
    }
}

}  // namespace

std::string jsonOf(const Document& document) { return documentJson(document).dump(2) + "\n"; }

std::string jsonOf(const SavedSession& session) { return sessionJson(session).dump(2) + "\n"; }

Result<void> writeDocument(const std::string& path, const Document& document) {
    if (auto readable = requireReadable(path, document); !readable) return readable;
    return writeJson(path, [&] { return documentJson(document); });
}

Result<void> writeSession(const std::string& path, const SavedSession& session) {
    if (auto readable = requireReadable(path, session.document); !readable) return readable;
    for (const Snapshot& snapshot : session.snapshots)
        if (auto readable = requireReadable(path, snapshot.document); !readable) return readable;
    return writeJson(path, [&] { return sessionJson(session); });
}

}  // namespace echolucent
