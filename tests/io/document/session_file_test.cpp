// Session files: byte for byte what was saved, whatever is damaged ends in a sentence, and studies are found from them.
#include "io/document/session_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/inputs.h"
#include "tests/io/document/mutations.h"
#include "tests/io/document/unusual_document.h"
#include "tests/io/written_files/temporary_folder.h"

namespace echolucent {
namespace {

namespace fs = std::filesystem;

/// A session that holds every kind of value.
SavedSession unusualSession() {
    SavedSession session{.document = unusualDocument(), .file = "/home/me/\"my\" session.json"};
    Document plain;
    plain.study = session.document.study;
    session.snapshots = {{"Größe \"1/3\"", session.document}, {"plain", plain}};
    session.snapshots.front().document.scene.motionAngle = 17;
    return session;
}

TEST(SessionFile, WrittenAndReadByteForByte) {
    const TemporaryFolder folder;
    const std::string first = folder.file("a.session.json"), second = folder.file("b.session.json");
    SavedSession simulated;
    simulated.document.study = SimulatedScan{PhantomScene::shapes, {72, 68, 70}, 3};
    for (const SavedSession& session : {SavedSession{}, unusualSession(), simulated}) {
        ASSERT_TRUE(writeSession(first, session));
        const auto read = readSession(first);
        ASSERT_TRUE(read) << read.error().sentence();
        EXPECT_TRUE(*read == session);
        ASSERT_TRUE(writeSession(second, *read));
        EXPECT_EQ(contentsOf(first), contentsOf(second));
        EXPECT_EQ(contentsOf(first), jsonOf(session));
    }
}

TEST(SessionFile, IsADocumentToWhoeverReadsDocuments) {
    const TemporaryFolder folder;
    const std::string path = folder.file("a.session.json");
    ASSERT_TRUE(writeSession(path, unusualSession()));
    EXPECT_TRUE(readDocument(path).value() == unusualSession().document);
    ASSERT_TRUE(writeDocument(path, unusualDocument()));
    EXPECT_TRUE(readSession(path).value() == (SavedSession{.document = unusualDocument()}));
    EXPECT_TRUE(looksLikeDocument(path));
    std::ofstream(path) << R"({"format": "echolucent-presets", "version": 1})";
    EXPECT_FALSE(looksLikeDocument(path));
    EXPECT_FALSE(looksLikeDocument(folder.file("absent")));
    EXPECT_FALSE(looksLikeDocument("/dev/zero"));
}

TEST(SessionFile, SnapshotsAreRefusedByTheirPlace) {
    const auto changed = [](const char* place, const nlohmann::ordered_json& value) {
        auto object = nlohmann::ordered_json::parse(jsonOf(unusualSession()));
        object[nlohmann::ordered_json::json_pointer(place)] = value;
        return sessionFromJson(object.dump(), "s.json");
    };
    EXPECT_EQ(changed("/session/snapshots/1/name", "").error().element, "session.snapshots[1].name");
    EXPECT_EQ(changed("/session/snapshots/1/name", std::string(61, 'x')).error().element, "session.snapshots[1].name");
    EXPECT_EQ(changed("/session/snapshots/0/name", "a\nb").error().element, "session.snapshots[0].name");
    EXPECT_EQ(changed("/session/snapshots/0/document", 3).error().element, "session.snapshots[0].document");
    EXPECT_EQ(changed("/session/snapshots/0/document/scene/pose/magnification", 0).error().element,
              "session.snapshots[0].document.scene.pose.magnification");
    EXPECT_EQ(changed("/session/snapshots", 3).error().element, "session.snapshots");
    EXPECT_EQ(changed("/session", 3).error().element, "session");
    SavedSession many = unusualSession();
    many.snapshots.assign(mostSnapshots + 1, {"one", {}});
    EXPECT_EQ(sessionFromJson(jsonOf(many)).error().element, "session.snapshots");
}

TEST(SessionFile, AThousandMutatedOnesOpenOrEndInASentence) {
    Mutations mutations(jsonOf(unusualSession()), 14);
    int opened = 0, refused = 0;
    std::chrono::duration<double> longest{0};
    constexpr int files = takesSomeInputs ? 200 : 1000;
    for (int i = 0; i < files; ++i) {
        const std::string text = mutations.next();
        const auto begin = std::chrono::steady_clock::now();
        const auto read = sessionFromJson(text, "s.session.json");
        longest = std::max(longest, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin));
        if (read) {
            ++opened;
            ASSERT_EQ(problemOf(read->document), "") << i;
            const auto again = sessionFromJson(jsonOf(*read));
            ASSERT_TRUE(again) << i << ": " << again.error().sentence();
            ASSERT_TRUE(*again == *read) << i;
            continue;
        }
        ++refused;
        const std::string sentence = read.error().sentence();
        ASSERT_TRUE(sentence.starts_with("s.session.json: ")) << i << ": " << sentence;
        ASSERT_LT(sentence.size(), 400u) << i << ": " << sentence;
        ASSERT_TRUE(std::ranges::none_of(sentence, [](char each) { return each == '\n'; })) << i;
    }
    std::printf("%d mutated session files: %d open, %d end in a sentence, the longest took %.0f ms\n", files, opened,
                refused, longest.count() * 1e3);
    EXPECT_GT(opened, files / 20);
    EXPECT_GT(refused, files * 3 / 10);
    EXPECT_LT(longest.count(), 5.0);
}

TEST(SessionFile, HostileOnesEndSoon) {
    const std::string deep = std::string(2'000'000, '[');
    EXPECT_NE(sessionFromJson(deep).error().problem.find("too deep"), std::string::npos);
    const std::string text = jsonOf(unusualSession());
    const auto with = [&](const char* place, const nlohmann::ordered_json& value) {
        auto object = nlohmann::ordered_json::parse(text);
        object[nlohmann::ordered_json::json_pointer(place)] = value;
        return sessionFromJson(object.dump(), "s.json");
    };
    const auto entry = [&](const char* place) {
        return nlohmann::ordered_json::parse(text).at(nlohmann::ordered_json::json_pointer(place));
    };
    const auto listed = with("/measurements", std::vector(1001, entry("/measurements/0")));
    ASSERT_FALSE(listed);
    EXPECT_EQ(listed.error().element, "measurements");
    EXPECT_NE(listed.error().problem.find("at most 1000 entries"), std::string::npos) << listed.error().problem;
    EXPECT_FALSE(with("/panes", std::vector(5, entry("/panes/0"))));
    EXPECT_FALSE(with("/scene/strokes/1/places", std::vector(200'001, std::vector{0.1, 0.2})));
    SavedSession simulated;
    simulated.document.study = SimulatedScan{PhantomScene::shapes, {4096, 4096, 4096}, 3};
    EXPECT_EQ(sessionFromJson(jsonOf(simulated)).error().element, "study.simulated_scan.size");
}

TEST(SessionFile, NamesAStudyNearItFromItsOwnFolder) {
    const TemporaryFolder folder;
    const auto named = [&](const std::string& file, const std::string& study) {
        Document document;
        document.study = StudyFile{.path = study, .options = {}, .checksum = {}};
        const SavedSession from = asNamedFrom(file, SavedSession{.document = document, .snapshots = {{"a", document}}});
        EXPECT_EQ(from.snapshots.front().document.study, from.document.study);
        return std::get<StudyFile>(from.document.study).path;
    };
    fs::create_directories(folder.file("a/b/c"));
    const std::string study = folder.file("a/b/heart.mha");
    std::ofstream(study) << "voxels";
    const auto leadsBack = [&](const std::string& file, const std::string& path) {
        return fs::equivalent(studyPathFrom(folder.file(file), path), study);
    };
    EXPECT_EQ(named(folder.file("a/b/s.json"), study), "heart.mha");
    EXPECT_EQ(named(folder.file("a/s.json"), study), "b/heart.mha");
    EXPECT_EQ(named(folder.file("a/b/c/s.json"), study), "../heart.mha");
    EXPECT_TRUE(leadsBack("a/b/s.json", "heart.mha"));
    EXPECT_TRUE(leadsBack("a/s.json", "b/heart.mha"));
    EXPECT_TRUE(leadsBack("a/b/c/s.json", "../heart.mha"));
    EXPECT_EQ(named("/proc/s.json", study), fs::canonical(study).string());
    EXPECT_EQ(studyPathFrom("/proc/s.json", study), study);
}

TEST(SessionFile, LiesBesideTheStudyAndNeverInIt) {
    const TemporaryFolder folder;
    fs::create_directories(folder.file("slices/deeper"));
    const std::string slice = folder.file("slices/1.dcm"), volume = folder.file("heart.nii.gz");
    std::ofstream(slice) << "slice";
    std::ofstream(volume) << "voxels";
    EXPECT_EQ(stemOfStudy(volume), "heart");
    EXPECT_EQ(stemOfStudy(folder.file("slices")), "slices");
    EXPECT_EQ(stemOfStudy(folder.file("slices/")), "slices");
    EXPECT_EQ(stemOfStudy("/data/a.b.mha"), "a.b");
    EXPECT_EQ(stemOfStudy("/data/a.b.session.json"), "a.b");
    const auto allowed = [&](const std::string& study, const std::string& file) {
        return refuseSessionInside(study, {slice, volume}, file).has_value();
    };
    EXPECT_TRUE(allowed(folder.file("slices"), folder.file("slices.session.json")));
    EXPECT_FALSE(allowed(folder.file("slices"), folder.file("slices/s.session.json")));
    EXPECT_FALSE(allowed(folder.file("slices"), folder.file("slices/deeper/s.session.json")));
    EXPECT_FALSE(allowed(volume, volume));
    EXPECT_TRUE(allowed(volume, folder.file("slices/s.session.json")));  // the study is another
    fs::create_symlink(folder.file("slices"), folder.file("link"));
    EXPECT_FALSE(allowed(folder.file("slices"), folder.file("link/s.session.json")));
}

TEST(SessionFile, IsNotWrittenWhereItCouldNotBeReadAgain) {
    const TemporaryFolder folder;
    const std::string path = folder.file("many.session.json");
    SavedSession many;
    std::vector<Measurement> measurements;
    for (std::size_t i = 0; i <= mostMeasurements; ++i)
        measurements.push_back({.id = static_cast<int>(i) + 1, .placesMm = {{0, 0, 0}, {1, 0, 0}}});
    many.document.measurements = measurements;
    const auto refused = writeSession(path, many);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence().find("measurements are more than 1000"), std::string::npos)
        << refused.error().sentence();
    measurements.pop_back();
    many.document.measurements = measurements;
    many.document.scene.strokes =
        std::vector<ScalpelStroke>(1001, ScalpelStroke{.places = {{0, 0}, {0.1, 0}, {0, 0.1}}});
    ASSERT_TRUE(writeSession(path, many));
    const auto read = readSession(path);
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(*read, many);
    many.document.scene.strokes = std::vector<ScalpelStroke>(mostStrokes + 1);
    EXPECT_FALSE(writeSession(path, many));
}

}  // namespace
}  // namespace echolucent
