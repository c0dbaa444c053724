#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/document/document_object.h"
#include "io/document/document_parts.h"
#include "io/document/document_version_1.h"
#include "io/document/session_file.h"
#include "io/files/input_file.h"
#include "io/json/json_design.h"
#include "io/json/json_document.h"

namespace echolucent {

namespace {

constexpr const char* remedyOfDocument = "Correct the file, or save the document again from the program.";

Front frontIn(JsonFields fields) {
    Front front{.depthMm = fields.number("depth_mm", 0), .direction = directionIn(fields.object("direction"))};
    if (front.depthMm == 0.0) front.direction = ViewDirection{};
    front.source = fields.choice("source", &frontSourceFromName);
    if (!fields.isNull("surface")) front.surface = surfaceIn(fields.object("surface"));
    return front;
}

Scene sceneIn(JsonFields fields) {
    Scene scene;
    JsonFields pose = fields.object("pose");
    scene.pose = poseIn(pose);
    scene.side = directionIn(fields.object("side"));
    scene.front = frontIn(fields.object("front"));
    JsonFields look = fields.object("look");
    scene.look = lookIn(look);
    if (fields.has("exposure")) scene.exposure = fields.number("exposure", 0.0, 1.0);
    JsonFields box = fields.object("box");
    scene.box = boxIn(box);
    JsonFields planes = fields.object("planes");
    scene.planes = planesIn(planes);
    scene.strokes = strokesIn(fields);
    scene.phase = phaseIn(fields);
    scene.motionAngle = fields.number("motion_angle", firstMotionAngle, lastMotionAngle);
    return scene;
}

std::vector<Pane> panesIn(JsonFields& root) {
    std::vector<Pane> panes;
    for (JsonFields& fields : root.list("panes", mostPanes)) {
        Pane pane{.curve = fields.choice("curve", &curveKindFromName)};
        if (fields.has("designer")) {
            JsonFields designer = fields.object("designer");
            pane.designer = designIn(designer);
        }
        if (fields.has("without_tubes"))
            for (const std::int64_t tube : fields.wholes("without_tubes", 0, largestNumber))
                pane.withoutTubes.push_back(static_cast<int>(tube));
        if (fields.has("method")) {
            JsonFields method = fields.object("method");
            pane.method = methodParametersIn(method);
        }
        if (fields.has("linear")) pane.linear = linearCurveIn(fields.object("linear"));
        if (fields.has("phase")) pane.phase = phaseIn(fields);
        if (fields.has("motion_otf")) pane.motionOtf = fields.choice("motion_otf", &motionOtfFromName);
        panes.push_back(std::move(pane));
    }
    return panes;
}

Document documentIn(JsonFields root) {
    Document document;
    document.study = studyIn(root);
    document.beam = beamIn(root.object("beam"));
    document.scene = sceneIn(root.object("scene"));
    document.panes = panesIn(root);
    JsonFields comparison = root.object("comparison");
    document.comparison = comparisonIn(comparison);
    document.measurements = measurementsIn(root);
    document.curves = curvesIn(root.object("curves"));
    JsonFields method = root.object("method");
    document.method = methodIn(method);
    JsonFields motion = root.object("motion");
    document.motion = motionIn(motion);
    return document;
}

Result<nlohmann::json> rootOf(std::string_view text, const std::string& file) {
    return jsonObject(text, file, std::string(documentFormatName), remedyOfDocument, documentVersion);
}

/// The pane with `number`, or without it the first pane, of a document of either version. `place` is where `object`
/// stands in the file; `windows` is as in ViewOfVersion1.
Result<DocumentPane> paneOf(const nlohmann::json& object, const std::string& place, const std::string& file,
                            std::optional<int> number, bool windows = false, int sessionVersion = documentVersion) {
    JsonProblems problems{file, std::nullopt};
    const JsonFields root(object, place, problems);
    // A snapshot without a version has the version of its session.
    const nlohmann::json version = object.value("version", nlohmann::json(sessionVersion));
    if (version != 1 && version != documentVersion)
        return fail(FailureKind::unreadable, file, place.empty() ? "version" : place + ".version",
                    "must be from 1 to 2, not " + JsonFields::shortened(version.dump()), remedyOfDocument);
    const bool old = version == 1;
    auto read = old ? paneInVersion1(root, {number, windows}) : DocumentPane{documentIn(root), firstPane};
    if (problems.first) return problems.refused(remedyOfDocument);
    const auto noPane = [&](const char* key, const std::string& problem, const char* remedy) {
        return fail(FailureKind::wrongUsage, file, key, problem, remedy);
    };
    if (!read) return noPane("views", fmt::format("hold no view of the id {}", *number), "Give the id of one of them.");
    if (const std::string problem = problemOf(read->document); !problem.empty())
        return fail(FailureKind::unreadable, file, place, problem, remedyOfDocument);
    if (old || !number) return std::move(*read);
    const std::size_t count = read->document.panes.size();
    if (*number < 1 || static_cast<std::size_t>(*number) > count)
        return noPane("panes", fmt::format("are {}, and none is number {}", count, *number),
                      "Give a number from 1 on.");
    read->pane = static_cast<std::size_t>(*number - 1);
    return std::move(*read);
}

}  // namespace

Result<Document> documentOf(const nlohmann::json& object, const std::string& place, const std::string& file,
                            int versionOfFile) {
    auto read = paneOf(object, place, file, std::nullopt, true, versionOfFile);
    if (!read) return tl::unexpected<Failure>(read.error());
    return std::move(read->document);
}

Result<Document> documentFromJson(std::string_view text, const std::string& file) {
    const auto object = rootOf(text, file);
    if (!object) return tl::unexpected(object.error());
    return documentOf(*object, {}, file);
}

Result<DocumentPane> documentPaneFromJson(std::string_view text, std::optional<int> number, const std::string& file) {
    const auto object = rootOf(text, file);
    if (!object) return tl::unexpected(object.error());
    return paneOf(*object, {}, file, number);
}

Result<DocumentPane> readDocumentPane(const std::string& path, std::optional<int> number) {
    const auto text = readWholeFile(path, largestDocumentFile);
    if (!text) return tl::unexpected(text.error());
    return documentPaneFromJson(*text, number, path);
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
        (void)snapshots[i].object("document");  // refuses a missing one
        if (problems.first) break;
        auto read =
            documentOf((*object)["session"]["snapshots"][i]["document"],
                       "session.snapshots[" + std::to_string(i) + "].document", file, (*object)["version"].get<int>());
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
