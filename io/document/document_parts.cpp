#include "io/document/document_parts.h"

#include <limits>
#include <nlohmann/json.hpp>

#include "io/document/document_file.h"
#include "io/json/json_values.h"

namespace echolucent {

namespace {

constexpr std::size_t mostPlaces = 200'000;                    // of one stroke
constexpr std::size_t longestChecksum = 200;                   // bytes
constexpr std::int64_t mostSimulated = std::int64_t{1} << 27;  // voxels

ViewFrame frameIn(JsonFields fields) {
    return {fields.vector("right"), fields.vector("down"), fields.vector("forward")};
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

}  // namespace

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
    // Documents without it were saved of studies whose black is 0, if only because no other was known.
    file.options.blackAtZero = !fields.has("black_from_data") || !fields.flag("black_from_data");
    file.checksum = fields.text("checksum");
    if (file.checksum.size() > longestChecksum) fields.wrong("checksum", "must be shorter");
    if (file.path.find('\0') != std::string::npos) fields.wrong("path", "must hold no null character");
    // Documents without a checksum may have neither.
    if (fields.has("bytes")) file.bytes = fields.whole("bytes", 1, std::numeric_limits<std::int64_t>::max());
    if (fields.has("files")) file.files = fields.whole("files", 1, std::numeric_limits<std::int64_t>::max());
    if (fields.has("turned_axis")) file.turnedAxis = fields.choice("turned_axis", &gridAxisFromName);
    return file;
}

ViewDirection directionIn(JsonFields fields) {
    return {fields.number("azimuth"), fields.number("elevation", -90, 90), fields.number("roll")};
}

Pose poseIn(JsonFields& fields) {
    return {directionIn(fields.object("direction")), fields.vector("offset_mm"),
            fields.number("magnification", std::numeric_limits<double>::min())};
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
    std::vector<float> depths;
    for (const double depth : fields.numbers("depth_mm")) depths.push_back(static_cast<float>(depth));
    surface.depthMm = std::move(depths);
    return surface;
}

Box boxIn(JsonFields& fields) {
    Box box{.on = fields.flag("on")};
    box.direction = directionIn(fields.object("direction"));
    box.centreMm = fields.vector("centre_mm");
    box.sizeMm = fields.vector("size_mm");
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
    planes.turnsView = fields.has("turns_view") && fields.flag("turns_view");
    return planes;
}

std::vector<ScalpelStroke> strokesIn(JsonFields& fields) {
    std::vector<ScalpelStroke> strokes;
    for (JsonFields& each : fields.list("strokes", mostStrokes)) {
        ScalpelStroke stroke;
        stroke.tool = each.choice("tool", &scalpelToolFromName);
        stroke.side = each.choice("side", &scalpelSideFromName);
        stroke.camera = cameraIn(each.object("camera"));
        stroke.places = each.pairs("places", mostPlaces);
        stroke.radius = each.number("radius", 0);
        if (!each.isNull("depth_mm")) stroke.depthMm = each.number("depth_mm");
        strokes.push_back(std::move(stroke));
    }
    return strokes;
}

Beam beamIn(JsonFields fields) {
    return {fields.choice("axis", &beamAxisFromName), fields.choice("source", &beamSourceFromName),
            directionIn(fields.object("lean"))};
}

int phaseIn(JsonFields& fields) { return static_cast<int>(fields.whole("phase", 0, largestNumber)); }

nlohmann::ordered_json motionJson(const MotionChoice& motion) {
    nlohmann::ordered_json range;
    if (motion.phaseRange) range = {{"first", motion.phaseRange->first}, {"last", motion.phaseRange->last}};
    return {{"axis", nameOf(motion.axis)},
            {"scenario", nameOf(motion.scenario)},
            {"otf", nameOf(motion.otf)},
            {"ping_pong", motion.pingPong},
            {"phases_ping_pong", motion.phasesPingPong},
            {"phase_range", range},
            {"otf_phase", motion.otfPhase},
            {"speed", motion.speed}};
}

MotionChoice motionIn(JsonFields& fields) {
    MotionChoice motion{.axis = fields.choice("axis", &motionAxisFromName),
                        .scenario = fields.choice("scenario", &motionScenarioFromName),
                        .otf = fields.choice("otf", &motionOtfFromName),
                        .pingPong = fields.flag("ping_pong")};
    motion.phasesPingPong = fields.flag("phases_ping_pong");
    if (!fields.isNull("phase_range")) {
        JsonFields range = fields.object("phase_range");
        motion.phaseRange = {static_cast<int>(range.whole("first", 0, largestNumber)),
                             static_cast<int>(range.whole("last", 0, largestNumber))};
    }
    motion.otfPhase = static_cast<int>(fields.whole("otf_phase", 0, largestNumber));
    motion.speed = fields.number("speed", leastMotionSpeed, largestMotionSpeed);
    return motion;
}

Comparison comparisonIn(JsonFields& fields) {
    Comparison comparison;
    comparison.layout = fields.choice("layout", &comparisonLayoutFromName);
    comparison.first = static_cast<int>(fields.whole("first", 0, static_cast<std::int64_t>(mostPanes) - 1));
    comparison.second = static_cast<int>(fields.whole("second", 0, static_cast<std::int64_t>(mostPanes) - 1));
    comparison.wipe = fields.number("wipe", 0, 1);
    comparison.amplification = fields.number("amplification", leastAmplification, largestAmplification);
    if (fields.has("colours")) comparison.colours = fields.flag("colours");
    return comparison;
}

std::vector<Measurement> measurementsIn(JsonFields& root) {
    std::vector<Measurement> measurements;
    for (JsonFields& fields : root.list("measurements", mostMeasurements)) {
        Measurement& next = measurements.emplace_back(Measurement{
            static_cast<int>(fields.whole("id", 0, largestNumber)), fields.choice("kind", &measurementKindFromName),
            fields.choice("ground", &measurementGroundFromName), fields.vectors("places_mm"), phaseIn(fields)});
        if (fields.has("name")) next.name = fields.text("name");
        if (fields.has("comment")) next.comment = fields.text("comment");
    }
    return measurements;
}

}  // namespace echolucent
