#include <fmt/format.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "io/document/document_object.h"
#include "io/document/document_parts.h"
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
        if (file->turnedAxis) object["turned_axis"] = nameOf(*file->turnedAxis);
        if (file->options.conversionMebibytes != ReadOptions{}.conversionMebibytes)
            object["conversion_mebibytes"] = file->options.conversionMebibytes;
        if (!file->options.blackAtZero) object["black_from_data"] = true;
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
            {"depth_mm", surface.depthMm.values()}};
}

ordered_json frontJson(const Front& front) {
    return {{"depth_mm", front.depthMm},
            {"direction", directionJson(front.direction)},
            {"source", nameOf(front.source)},
            {"surface", front.surface ? surfaceJson(*front.surface) : ordered_json()}};
}

ordered_json boxJson(const Box& box) {
    return {{"on", box.on},
            {"direction", directionJson(box.direction)},
            {"centre_mm", triple(box.centreMm)},
            {"size_mm", triple(box.sizeMm)}};
}

ordered_json planesJson(const Planes& planes) {
    ordered_json crops = ordered_json::object();
    for (const PlaneName plane : allPlaneNames) {
        const PlaneCrop& crop = planes.crops[indexOf(plane)];
        crops[std::string(nameOf(plane))] = {
            {"pan_right_mm", crop.panRightMm}, {"pan_down_mm", crop.panDownMm}, {"magnification", crop.magnification}};
    }
    ordered_json json{{"direction", directionJson(planes.direction)},
                      {"offset_mm", triple(planes.offsetMm)},
                      {"crops", crops},
                      {"window", planes.window},
                      {"level", planes.level},
                      {"quiet", planes.quiet},
                      {"lines_in_3d", planes.linesIn3d}};
    if (planes.turnsView) json["turns_view"] = true;
    return json;
}

ordered_json cameraJson(const Camera& camera) {
    return {{"focal_point_mm", triple(camera.focalPoint)}, {"frame", frameJson(camera.frame)},
            {"projection", nameOf(camera.projection)},     {"height_mm", camera.heightMm},
            {"view_angle", camera.viewAngleDegrees},       {"distance_mm", camera.distanceMm}};
}

ordered_json strokesJson(const std::vector<ScalpelStroke>& strokes) {
    ordered_json list = ordered_json::array();
    for (const ScalpelStroke& stroke : strokes) {
        ordered_json object{{"tool", nameOf(stroke.tool)},
                            {"side", nameOf(stroke.side)},
                            {"camera", cameraJson(stroke.camera)},
                            {"places", stroke.places.values()},
                            {"radius", stroke.radius}};
        object["depth_mm"] = stroke.depthMm ? ordered_json(*stroke.depthMm) : ordered_json();
        list.push_back(std::move(object));
    }
    return list;
}

ordered_json sceneJson(const Scene& scene) {
    ordered_json object{{"pose", poseJson(scene.pose)},
                        {"side", directionJson(scene.side)},
                        {"front", frontJson(scene.front)},
                        {"look", lookJson(scene.look)},
                        {"box", boxJson(scene.box)},
                        {"planes", planesJson(scene.planes)},
                        {"strokes", strokesJson(scene.strokes)},
                        {"phase", scene.phase},
                        {"motion_angle", scene.motionAngle}};
    if (scene.exposure != 1.0) object["exposure"] = scene.exposure;  // most scenes have none
    return object;
}

ordered_json panesJson(const std::vector<Pane>& panes) {
    ordered_json entries = ordered_json::array();
    for (const Pane& pane : panes) {
        ordered_json object{{"curve", nameOf(pane.curve)}};
        // Most panes have none of these.
        if (pane.designer) object["designer"] = designJson(*pane.designer);
        if (!pane.withoutTubes.empty()) object["without_tubes"] = pane.withoutTubes;
        if (pane.method) object["method"] = methodParametersJson(*pane.method);
        if (pane.linear) object["linear"] = linearCurveJson(*pane.linear);
        if (pane.phase) object["phase"] = *pane.phase;
        if (pane.motionOtf) object["motion_otf"] = nameOf(*pane.motionOtf);
        entries.push_back(std::move(object));
    }
    return entries;
}

ordered_json measurementsJson(const std::vector<Measurement>& measurements) {
    ordered_json entries = ordered_json::array();
    for (const Measurement& measurement : measurements) {
        ordered_json places = ordered_json::array();
        for (const Vec3& place : measurement.placesMm) places.push_back(triple(place));
        ordered_json& entry = entries.emplace_back(ordered_json{{"id", measurement.id},
                                                                {"kind", nameOf(measurement.kind)},
                                                                {"ground", nameOf(measurement.ground)},
                                                                {"places_mm", places},
                                                                {"phase", measurement.phase}});
        if (!measurement.name.empty()) entry["name"] = measurement.name;
        if (!measurement.comment.empty()) entry["comment"] = measurement.comment;
    }
    return entries;
}

ordered_json comparisonJson(const Comparison& comparison) {
    ordered_json object{{"layout", nameOf(comparison.layout)},
                        {"first", comparison.first},
                        {"second", comparison.second},
                        {"wipe", comparison.wipe},
                        {"amplification", comparison.amplification}};
    if (comparison.colours) object["colours"] = true;
    return object;
}

}  // namespace

ordered_json documentJson(const Document& document) {
    ordered_json object{{"format", documentFormatName}, {"version", documentVersion}};
    object["study"] = studyJson(document.study);
    object["beam"] = {{"axis", nameOf(document.beam.axis)},
                      {"source", nameOf(document.beam.source)},
                      {"lean", directionJson(document.beam.lean)}};
    object["scene"] = sceneJson(document.scene);
    object["panes"] = panesJson(document.panes);
    object["comparison"] = comparisonJson(document.comparison);
    object["measurements"] = measurementsJson(document.measurements);
    object["curves"] = curvesJson(document.curves);
    object["method"] = methodJson(document.method);
    object["motion"] = motionJson(document.motion);
    return object;
}

namespace {

ordered_json sessionJson(const SavedSession& session) {
    ordered_json object = documentJson(session.document);
    ordered_json snapshots = ordered_json::array();
    for (const Snapshot& snapshot : session.snapshots) {
        Document document = snapshot.document;
        document.study = {};  // the session holds the study
        snapshots.push_back({{"name", snapshot.name}, {"document", documentJson(document)}});
    }
    object["session"] = {{"snapshots", snapshots}};
    if (!session.file.empty()) object["session"]["file"] = session.file;
    return object;
}

/// Refuses to write more measurements or strokes than the reader takes.
Result<void> requireReadable(const std::string& path, const Document& document) {
    const auto tooMany = [&](const char* what, std::size_t most) {
        return fail(FailureKind::unwritable, path, what,
                    fmt::format("are more than {}, so that the file could not be opened again", most),
                    "Remove some of them, and save again.");
    };
    if (document.measurements.size() > mostMeasurements) return tooMany("measurements", mostMeasurements);
    if (document.scene.strokes.size() > mostStrokes) return tooMany("strokes", mostStrokes);
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
