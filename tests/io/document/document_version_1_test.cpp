// Documents of version 1, as 0.1 wrote them: what its window and its command line showed of them is read.
#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/document/session_file.h"
#include "tests/io/document/unusual_document.h"
#include "tests/io/written_files/temporary_folder.h"

namespace echolucent {
namespace {

/// A session that 0.1 wrote, with every kind of value: three views, of which 1 and 8 are compared, and two snapshots.
std::string text() {
    return contentsOf(std::filesystem::path(__FILE__).parent_path() / "version_1" / "unusual.session.json");
}

/// What the session holds of unusualDocument(): 0.1 had no other axes, no planes that turn the view, and measurements
/// without names and comments.
Document unusualDocumentOf01() {
    Document document = unusualDocument();
    std::get<StudyFile>(document.study).options.blackAtZero = true;
    document.motion.axis = MotionAxis::z;
    document.scene.planes.turnsView = false;
    document.measurements.change([](std::vector<Measurement>& measurements) {
        for (Measurement& measurement : measurements) measurement.name = measurement.comment = {};
    });
    return document;
}

TEST(DocumentVersion1, TheWindowGetsView1AndWhatItIsComparedWith) {
    const auto read = documentFromJson(text());
    ASSERT_TRUE(read) << read.error().sentence();
    Document expected = unusualDocumentOf01();
    Scene& scene = expected.scene;
    scene.pose = Pose{};
    // It lay across the view shown.
    scene.front = frontAcross(shownPose(expected).direction, std::numeric_limits<double>::denorm_min());
    scene.strokes.clear();
    expected.panes = {expected.panes[0],
                      {.curve = CurveKind::manual,
                       .designer = expected.panes[1].designer,
                       .withoutTubes = {0, 7, 112},
                       .motionOtf = MotionOtf::leastFlicker}};
    EXPECT_TRUE(read->scene == scene);
    EXPECT_TRUE(read->panes == expected.panes);
    EXPECT_TRUE(*read == expected);
    EXPECT_TRUE(documentFromJson(jsonOf(*read)).value() == expected);
}

TEST(DocumentVersion1, EveryViewIsReadByItsId) {
    const auto third = documentPaneFromJson(text(), 3);
    ASSERT_TRUE(third) << third.error().sentence();
    Document expected = unusualDocumentOf01();
    expected.scene.front.direction = shownPose(expected).direction;  // it lay across the view shown
    expected.scene.box = {};
    expected.panes = {{.curve = CurveKind::quartic, .designer = expected.panes[2].designer}};
    EXPECT_TRUE(third->document.scene == expected.scene);
    EXPECT_TRUE(third->document == expected);
    EXPECT_EQ(third->pane, firstPane);
    EXPECT_TRUE(documentPaneFromJson(text(), std::nullopt).value().document == expected) << "view 3 stands first";

    const auto eighth = documentPaneFromJson(text(), 8);
    ASSERT_TRUE(eighth) << eighth.error().sentence();
    EXPECT_EQ(eighth->pane, 1U);
    EXPECT_TRUE(eighth->document == documentFromJson(text()).value());

    const auto absent = documentPaneFromJson(text(), 4);
    ASSERT_FALSE(absent);
    EXPECT_EQ(absent.error().kind, FailureKind::wrongUsage);
}

TEST(DocumentVersion1, APhaseOfItsOwnStaysAPanesOwn) {
    auto object = nlohmann::ordered_json::parse(text());
    object["phases"].push_back({{"id", 2}, {"phase", 6}});
    object["views"][1]["phase"] = 2;
    const auto read = documentFromJson(object.dump());
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(phaseOf(*read, 0), 3);
    EXPECT_EQ(phaseOf(*read, 1), 6);
    EXPECT_EQ(read->panes[1].phase, 6);
}

TEST(DocumentVersion1, PanesThatSharedADesignHaveItEach) {
    auto object = nlohmann::ordered_json::parse(text());
    object["views"][2]["design"] = object["views"][1]["design"];
    const auto read = documentFromJson(object.dump());
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(read->panes[0].designer, unusualDocument().panes[1].designer);
    EXPECT_EQ(read->panes[1].designer, unusualDocument().panes[1].designer);
}

TEST(DocumentVersion1, WhatOldDocumentsLackMayBeMissing) {
    auto object = nlohmann::ordered_json::parse(text());
    object.erase("comparison");
    for (auto& view : object["views"]) view.erase("design");
    object.erase("designs");
    for (auto& snapshot : object["session"]["snapshots"]) snapshot["document"].erase("version");
    const auto session = sessionFromJson(object.dump());
    ASSERT_TRUE(session) << session.error().sentence();
    EXPECT_EQ(session->document.panes, (std::vector<Pane>{{.curve = CurveKind::linear}}));
    EXPECT_EQ(session->document.comparison, Comparison{});
    EXPECT_EQ(session->snapshots[0].document.scene.motionAngle, 17) << "of the session's version";
    object["session"]["snapshots"][0]["document"]["version"] = 99;
    EXPECT_EQ(sessionFromJson(object.dump()).error().element, "session.snapshots[0].document.version");
}

TEST(DocumentVersion1, TheWindowGetsTheFirstViewIfThereIsNoView1) {
    auto object = nlohmann::ordered_json::parse(text());
    object.erase("comparison");
    object["views"][2]["id"] = 4;
    const auto read = documentFromJson(object.dump());
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(read->panes.front().curve, CurveKind::quartic);
}

TEST(DocumentVersion1, SnapshotsAreReadAsTheSession) {
    const auto session = sessionFromJson(text());
    ASSERT_TRUE(session) << session.error().sentence();
    ASSERT_EQ(session->snapshots.size(), 2U);
    Document snapshot = session->document;
    snapshot.scene.motionAngle = 17;
    snapshot.scene.front.direction = shownPose(snapshot).direction;
    EXPECT_TRUE(session->snapshots[0].document == snapshot);
    Document plain;
    plain.study = session->document.study;
    plain.motion.axis = MotionAxis::y;
    plain.scene.planes.quiet = true;
    std::get<RampRule>(plain.method.config.curve).aim = 0.0;
    EXPECT_TRUE(session->snapshots[1].document == plain);
    EXPECT_EQ(jsonOf(sessionFromJson(jsonOf(*session)).value()), jsonOf(*session));
}

TEST(DocumentVersion1, ListsWithoutEndAreRefused) {
    const auto object = nlohmann::ordered_json::parse(text());
    for (const char* list :
         {"views", "poses", "cuts", "looks", "boxes", "planes", "strokes", "phases", "measurements", "designs"}) {
        auto many = object;
        many[list] = std::vector(1001, object[list][0]);
        const auto read = documentFromJson(many.dump());
        ASSERT_FALSE(read) << list;
        EXPECT_EQ(read.error().element, list);
        EXPECT_NE(read.error().problem.find("at most 1000 entries"), std::string::npos) << read.error().problem;
    }
}

struct WrongPlace {
    const char* place;  ///< JSON pointer
    nlohmann::ordered_json value;
    const char* key;  ///< in the sentence
    const char* problem;
};

class WrongVersion1 : public testing::TestWithParam<WrongPlace> {};

TEST_P(WrongVersion1, IsRefusedByItsKey) {
    auto object = nlohmann::ordered_json::parse(text());
    object[nlohmann::ordered_json::json_pointer(GetParam().place)] = GetParam().value;
    const auto read = documentFromJson(object.dump(), "old.json");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().element, GetParam().key);
    EXPECT_NE(read.error().problem.find(GetParam().problem), std::string::npos) << read.error().problem;
}

INSTANTIATE_TEST_SUITE_P(
    DocumentVersion1, WrongVersion1,
    testing::Values(
        WrongPlace{"/views", 3, "views", "list"},
        WrongPlace{"/views", nlohmann::ordered_json::array(), "views", "at least one view"},
        WrongPlace{"/views/1/pose", 99, "views[1].pose", "names no pose"},
        WrongPlace{"/views/1/id", 3, "views", "must have an id of its own each"},
        WrongPlace{"/views/0/curve", "sigmoid", "views[0].curve", "must not be \"sigmoid\""},
        WrongPlace{"/views/1/strokes", 3, "views[1].strokes", "names no strokes"},
        WrongPlace{"/views/0/design", 3, "views[0].design", "names no design"},
        WrongPlace{"/views/1/without_tubes", {1, -2}, "views[1].without_tubes", "whole numbers"},
        WrongPlace{"/poses/0/magnification", 0, "poses[0].magnification", "above 0"},
        WrongPlace{"/poses/1/direction/elevation", 90.5, "poses[1].direction.elevation", "-90 to 90"},
        WrongPlace{"/cuts/0/near_cut_mm", -1, "cuts[0].near_cut_mm", "0 or more"},
        WrongPlace{"/cuts/0/surface/spacing_mm", 0, "cuts[0].surface", "spacing"},
        WrongPlace{"/looks/0/mode", 1, "looks[0].mode", "must not be 1"},
        WrongPlace{"/phases/0/phase", -1, "phases[0].phase", "0 to"},
        WrongPlace{"/motion/angle", 46, "motion.angle", "-45 to 45"},
        WrongPlace{"/boxes/1/size_mm", {1, 0, 1}, "boxes[1]", "has a size that is not above 0"},
        WrongPlace{"/planes/0/window", 0, "planes[0].window", "to 4"},
        WrongPlace{"/strokes/1/strokes/1/places", {{1, 2}, {3, 4}}, "strokes[1].strokes[1]", "fewer than three places"},
        WrongPlace{"/designs/0/designer", "sakas", "designs[0].designer", "must not be \"sakas\""},
        WrongPlace{"/designs/0/id", 2, "designs", "must have an id of its own each"},
        WrongPlace{"/designs/0/id", 0, "designs", "must have ids from 1 on"},
        WrongPlace{"/designs/1/drawn", {{1, 2}}, "designs[1]", "nodes"},
        WrongPlace{"/comparison/panes", {1}, "comparison.panes", "2 to 4"},
        WrongPlace{"/comparison/panes", {8, 1}, "comparison.panes", "begin with view 1"},
        WrongPlace{"/comparison/panes", {1, 1}, "comparison.panes", "once"},
        WrongPlace{"/comparison/panes", {1, 3}, "comparison.panes", "share"},
        WrongPlace{"/comparison/panes", {1, 5}, "comparison.panes", "names no view"}));

}  // namespace
}  // namespace echolucent
