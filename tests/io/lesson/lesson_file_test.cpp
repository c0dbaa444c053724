// Lessons as folders: nothing is lost, and what strangers put in them is refused in one sentence.
#include "io/lesson/lesson_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "io/document/session_file.h"
#include "tests/inputs.h"
#include "tests/io/written_files/temporary_folder.h"

namespace echolucent {
namespace {

using nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr const char* lessonText = R"(# Two curves

What a curve does.

## See {#see}
Look at ![the wall](wall.png).

## Choose {#choose}
Take **x²**.

### A hint {#hint}
Its button stands below the curve.

### {#question}
Why is the wall gone?

- It is dark.
- Its echo is *weak*,
  and is squared.

### {#explanation}
Half of the echo is a quarter of the opacity.
)";

LessonFiles smallLesson() {
    const ordered_json object = ordered_json::parse(R"({
        "format": "echolucent-lesson", "version": 1, "minutes": 3,
        "study": {"scene": "fetus", "size": [48, 48, 40], "seed": 7},
        "begins": {"panes": [{"curve": "linear"}], "scene": {"look": {"brightness": 1.25}}},
        "steps": [
            {"id": "see", "look_at": "view3d", "until": {"all": [
                {"present": "scene.front.source"}, {"between": ["scene.look.brightness", 1, 1.5]},
                {"any": [{"greater": ["measured.panes[1].late", 20]}, {"not_equal": ["scene.box.on", true]}]}]}},
            {"id": "choose", "look_at": "otfEditor", "set": {"scene": {"front": {"depth_mm": 4}}},
             "until": {"equal": ["panes[0].curve", "parabolic"]},
             "solution": {"panes": [{"curve": "parabolic"}]}, "question": {"answers": 2, "right": 1}}]})");
    return {"two-curves", {{"lesson.json", object.dump(2)}, {"en.md", lessonText}, {"wall.png", "PNG"}}};
}

/// The lesson whose lesson.json has another value at a JSON pointer; without a value the key is missing.
LessonFiles changedLesson(const char* pointer, const std::optional<ordered_json>& value) {
    LessonFiles files = smallLesson();
    ordered_json object = ordered_json::parse(files.bytes["lesson.json"]);
    const ordered_json::json_pointer place(pointer);
    if (value)
        object[place] = *value;
    else
        object.at(place.parent_pointer()).erase(place.back());
    files.bytes["lesson.json"] = object.dump();
    return files;
}

/// 1 + 10 × 21 conditions.
ordered_json manyConditions() {
    const ordered_json some{{"any", std::vector<ordered_json>(mostConditionParts, {{"present", "panes"}})}};
    return {{"all", std::vector<ordered_json>(10, some)}};
}

std::string refusal(const LessonFiles& files) {
    const auto lesson = lessonFrom(files);
    return lesson ? "" : lesson.error().sentence();
}

TEST(LessonFile, IsReadIntoDocumentsAndTexts) {
    const auto lesson = lessonFrom(smallLesson());
    ASSERT_TRUE(lesson) << lesson.error().sentence();
    EXPECT_EQ(std::get<SimulatedScan>(lesson->begins.study).seed, 7U);
    EXPECT_TRUE(lesson->begins.panes[0].curve == CurveKind::linear);
    ASSERT_EQ(lesson->steps.size(), 2U);
    EXPECT_FALSE(lesson->steps[0].set);
    Document set = lesson->begins;
    set.scene.front.depthMm = 4;
    EXPECT_TRUE(documentBefore(*lesson, 1) == set) << "a step's part is put over the lesson's beginning";
    set.panes[0].curve = CurveKind::parabolic;
    EXPECT_TRUE(documentAfter(*lesson, 1) == set);
    const LessonText& text = textIn(*lesson, "de");
    Lesson translated = *lesson;
    for (const char* language : {"pt", "pt-br"}) {
        EXPECT_EQ(textIn(translated, "pt-br").language, language == std::string("pt") ? "en" : "pt");
        translated.texts.push_back(text);
        translated.texts.back().language = language;
    }
    EXPECT_EQ(textIn(translated, "pt-br").language, "pt-br");
    LessonFiles withNotes = smallLesson();
    for (const char* notes : {"readme.md", "notes-x.md"}) withNotes.bytes[notes] = "# Notes";
    EXPECT_TRUE(lessonFrom(withNotes)) << refusal(withNotes);
    EXPECT_EQ(text.language, "en");
    EXPECT_EQ(text.title, "Two curves");
    EXPECT_EQ(text.summary, "What a curve does.");
    EXPECT_EQ(text.steps[1].title, "Choose");
    EXPECT_EQ(text.steps[1].hint, "Its button stands below the curve.");
    EXPECT_EQ(text.steps[1].question, "Why is the wall gone?");
    EXPECT_EQ(text.steps[1].answers, (std::vector<std::string>{"It is dark.", "Its echo is *weak*, and is squared."}));
    EXPECT_EQ(text.steps[1].explanation, "Half of the echo is a quarter of the opacity.");
    EXPECT_EQ(lesson->images.at("wall.png"), "PNG");
}

TEST(LessonFile, ReadsBackWhatItWrote) {
    const auto lesson = lessonFrom(smallLesson());
    ASSERT_TRUE(lesson);
    const TemporaryFolder folder;
    const std::string place = folder.path() + "/new lesson";
    const auto written = writeLesson(place, *lesson);
    ASSERT_TRUE(written) << written.error().sentence();
    const auto again = readLesson(place);
    ASSERT_TRUE(again) << again.error().sentence();
    EXPECT_TRUE(*again == *lesson);
    EXPECT_EQ(filesOf(*again).bytes, filesOf(*lesson).bytes);

    EXPECT_FALSE(fs::exists(place + ".unfinished"));

    Lesson heading = *lesson;
    heading.texts[0].steps[0].text = "Look\n## again {#see}";
    EXPECT_FALSE(writeLesson(place, heading)) << "it would be read as another step";
    EXPECT_TRUE(*readLesson(place) == *lesson) << "what was there stays";
    std::ofstream(folder.path() + "/file") << "no folder";
    EXPECT_FALSE(writeLesson(folder.path() + "/file/new", *lesson));
    Lesson unwritable = *lesson;
    unwritable.images["wall.png/a.png"] = "PNG";
    EXPECT_FALSE(writeLesson(folder.path() + "/half", unwritable));
    // What a person keeps beside it is left alone, whether the lesson can be written or not.
    const std::string own = folder.path() + "/next.unfinished";
    fs::create_directory(own);
    std::ofstream(own + "/de.md") << "own";
    ASSERT_TRUE(writeLesson(folder.path() + "/next", *lesson));
    EXPECT_TRUE(fs::exists(own + "/de.md"));
    EXPECT_FALSE(fs::exists(folder.path() + "/next/de.md"));
    EXPECT_TRUE(*readLesson(folder.path() + "/next") == *lesson);
    EXPECT_FALSE(fs::exists(own + "-1"));
    EXPECT_FALSE(fs::exists(folder.path() + "/half")) << "a new folder is whole";
}

TEST(LessonFile, AStepMayTakeItsDocumentFromASession) {
    LessonFiles files = changedLesson("/steps/1/set", std::nullopt);
    ordered_json object = ordered_json::parse(files.bytes["lesson.json"]);
    object["steps"][1]["session"] = "deep.session.json";
    files.bytes["lesson.json"] = object.dump();
    SavedSession session{.document = lessonFrom(smallLesson())->begins};
    session.document.scene.front.depthMm = 9;
    files.bytes["deep.session.json"] = jsonOf(session);
    const auto lesson = lessonFrom(files);
    ASSERT_TRUE(lesson) << lesson.error().sentence();
    EXPECT_TRUE(documentBefore(*lesson, 1) == session.document);

    session.document.study = SimulatedScan{.seed = 8};
    files.bytes["deep.session.json"] = jsonOf(session);
    EXPECT_EQ(refusal(files),
              "two-curves/deep.session.json: study must be the lesson's simulated scan. Correct the "
              "file, or ask who made the lesson.");
    object["steps"][1]["session"] = "../deep.session.json";
    files.bytes["lesson.json"] = object.dump();
    EXPECT_NE(refusal(files).find("steps[1].session must be the name of a session file"), std::string::npos);
}

TEST(LessonFile, EachRefusalNamesFileAndKey) {
    struct Wrong {
        const char* pointer;
        std::optional<ordered_json> value;
        const char* says;
    };
    const std::string longId(longestLessonId + 1, 'a');
    const std::vector<Wrong> wrongs{
        {"/format", "echolucent-document", "format must be \"echolucent-lesson\""},
        {"/version", 2, "version must be 1, not 2"},
        {"/colour", 1, "colour is no key of a lesson"},
        {"/study/bytes", 1, "study.bytes is no key of a lesson"},
        {"/steps/0/run", "rm", "steps[0].run is no key of a lesson"},
        {"/steps/1/question/code", 1, "steps[1].question.code is no key of a lesson"},
        {"/minutes", 0, "minutes must be 1 to 600, not 0"},
        {"/minutes", std::nullopt, "minutes is missing"},
        {"/study", std::nullopt, "study is missing"},
        {"/study/scene", "liver", "study.scene must not be \"liver\""},
        {"/study/size", ordered_json{300, 64, 64}, "study.size must be three whole numbers from 1 to 256"},
        {"/study/size", ordered_json{8, 64, 64}, "study.size must be three numbers from 24 to 256"},
        {"/begins/study", ordered_json{{"file", {{"path", "/etc/passwd"}}}}, "begins.study is that of the lesson"},
        {"/begins/scene/look/brightness", "much", "begins.scene.look.brightness must not be \"much\""},
        {"/begins/scene/loook", 1, "begins.scene.loook names no value of this document"},
        {"/session", "a.session.json", "session must not stand beside begins"},
        {"/steps", ordered_json::array(), "steps must be 1 to 60"},
        {"/steps", ordered_json(std::vector<int>(mostLessonSteps + 1)), "steps must hold at most 60 entries, not 61"},
        {"/steps/0/id", "See it", "steps[0].id must be 1 to 40 lower case letters, digits and hyphens"},
        {"/steps/0/id", longId, "steps[0].id must be 1 to 40"},
        {"/steps/0/set", 3, "steps[0].set must be a part of a document as a JSON object"},
        {"/steps/0/until", "true", "steps[0].until must be one of all, any"},
        {"/steps/0/until", ordered_json{{"run", "x"}}, "steps[0].until must be one of all, any"},
        {"/steps/0/until", ordered_json{{"equal", {"system", 1}}},
         "steps[0].until.equal names \"system\", which is neither"},
        {"/steps/0/until", ordered_json{{"equal", {"measured.panes[4].late", 1}}}, "which is neither a value"},
        {"/steps/0/until", ordered_json{{"equal", {"measured.panes[N].late", 1}}}, "which is neither a value"},
        {"/begins/scene/phase", 1, "begins must not ask for a phase beyond the first"},
        {"/steps/1/set/scene/phase", 1, "steps[1].set must not ask for a phase beyond the first"},
        {"/steps/1/set/motion", ordered_json{{"scenario", "object"}}, "steps[1].set must have the motion of the probe"},
        {"/steps/0/until", manyConditions(), "is one condition too many: a lesson holds at most 200"},
        {"/steps/0/until", ordered_json{{"less", {"panes[0].curve", "x"}}},
         "steps[0].until.less must compare with a number"},
        {"/steps/0/until", ordered_json{{"between", {"panes", 3, 1}}},
         "must be between a number and one that is not below it"},
        {"/steps/0/until", ordered_json{{"between", {"panes", 3}}}, "must be a list of a name and two numbers"},
        {"/steps/0/until", ordered_json{{"equal", {"panes", {1, 2}}}}, "must compare with a number, a text"},
        {"/steps/0/until", ordered_json{{"all", ordered_json::array()}},
         "steps[0].until.all must be a list of 1 to 20 conditions"},
        {"/steps/0/until", ordered_json::parse(R"({"all":[{"all":[{"all":[{"all":[{"present":"panes"}]}]}]}]})"),
         "nests deeper than 4 conditions"},
        {"/steps/1/solution", ordered_json{{"panes", 3}}, "steps[1].solution.panes must be a list"},
        {"/steps/1/question/answers", 7, "steps[1].question.answers must be 2 to 6, not 7"},
        {"/steps/1/question/right", 2, "steps[1].question.right must be 0 to 1, not 2"},
        {"/steps/1/question/answers", 3, "en.md must have a question with 3 answers in the step choose"},
    };
    for (const Wrong& wrong : wrongs) {
        const std::string said = refusal(changedLesson(wrong.pointer, wrong.value));
        EXPECT_NE(said.find(wrong.says), std::string::npos) << wrong.pointer << ": " << said;
        EXPECT_TRUE(said.starts_with("two-curves/lesson.json: ")) << said;
    }
}

TEST(LessonFile, TextsBelongToStepsAndShowNoStrangersImages) {
    const auto said = [](const std::string& from, const std::string& to) {
        LessonFiles files = smallLesson();
        std::string& text = files.bytes["en.md"];
        text.replace(text.find(from), from.size(), to);
        return refusal(files);
    };
    const std::string image = "shows an image that is no file of the lesson's folder";
    for (const char* name : {"/etc/logo.png", "../wall.png", "http://a.example/x.png", "file:///wall.png", "other.png",
                             "data:image/png;base64,AA", "//a.example/x.png"})
        EXPECT_NE(said("wall.png", name).find(image), std::string::npos) << name;
    for (const char* hidden : {"![the wall][w]", "![a ![b](wall.png)](/etc/x.png)", "![a `](wall.png)` ](/etc/x.png)"})
        EXPECT_NE(said("![the wall](wall.png)", hidden).find(image), std::string::npos) << hidden;
    EXPECT_NE(said("{#choose}", "{#chose}").find("has a section {#chose} that is no step"), std::string::npos);
    EXPECT_NE(said("{#choose}", "{#see}").find("has two sections of {#see}"), std::string::npos);
    EXPECT_NE(said("### A hint {#hint}", "### {#tip}").find("{#tip} that is no hint"), std::string::npos);
    EXPECT_NE(said("## See {#see}", "### {#hint}").find("before the first step"), std::string::npos);
    EXPECT_NE(said("# Two curves", "").find("must have a title of 1 to 120 bytes"), std::string::npos);
    EXPECT_NE(said("Take **x²**.", "").find("a title and a text for the step choose"), std::string::npos);
    EXPECT_NE(said("Take **x²**.", std::string(longestLessonText + 1, 'x')).find("more than 8000 bytes"),
              std::string::npos);
    LessonFiles files = smallLesson();
    files.bytes.erase("en.md");
    EXPECT_NE(refusal(files).find("languages must be 1 to 20"), std::string::npos);
}

TEST(LessonFile, AFolderHoldsPlainFilesOfBoundedSize) {
    const TemporaryFolder folder;
    const std::string place = folder.path() + "/lesson";
    ASSERT_TRUE(writeLesson(place, *lessonFrom(smallLesson())));
    const auto write = [&](const std::string& name, std::size_t bytes) {
        std::ofstream(place + "/" + name) << std::string(bytes, 'x');
    };
    write("notes.txt", 10);
    write(".hidden.png", 10);
    fs::create_directory(place + "/more");
    ASSERT_TRUE(readLesson(place)) << "other files are not looked at";

    const auto said = [&] {
        const auto lesson = readLesson(place);
        return lesson ? std::string() : lesson.error().sentence();
    };
    fs::create_symlink("/etc/hostname", place + "/name.png");
    EXPECT_NE(said().find("name.png: is a link"), std::string::npos) << said();
    fs::remove(place + "/name.png");
    fs::create_directory(place + "/folder.png");
    EXPECT_NE(said().find("folder.png: is no file"), std::string::npos) << said();
    fs::remove(place + "/folder.png");
    write("large.png", largestLessonImage + 1);
    EXPECT_NE(said().find("large.png"), std::string::npos) << said();
    fs::remove(place + "/large.png");
    for (std::size_t i = 0; i < mostLessonFiles; ++i) write("x" + std::to_string(i) + ".md", 1);
    EXPECT_NE(said().find("holds more than 100 files of a lesson"), std::string::npos) << said();
    EXPECT_NE(readLesson(folder.path() + "/nowhere").error().sentence().find("is no folder"), std::string::npos);
}

TEST(LessonFile, DamagedLessonsEndInASentenceOrInALessonThatHoldsItsRules) {
    std::mt19937 random(36);
    const int rounds = takesSomeInputs ? 40 : 300;
    int read = 0;
    for (int i = 0; i < rounds; ++i) {
        LessonFiles files = smallLesson();
        auto file = files.bytes.begin();
        std::advance(file, i % 2);  // en.md, lesson.json
        std::string& bytes = file->second;
        for (int change = 0; change < 1 + i % 3; ++change) {
            const std::size_t at = random() % bytes.size();
            switch (random() % 4) {
                case 0: bytes[at] = static_cast<char>(random()); break;
                case 1: bytes.erase(at, 1 + random() % 8); break;
                case 2: bytes.insert(at, bytes.substr(random() % bytes.size(), 12)); break;
                default: bytes.insert(at, std::string(1 + random() % 70, "[{\"-#9"[random() % 6])); break;
            }
        }
        const auto lesson = lessonFrom(files);
        if (lesson) {
            ++read;
            EXPECT_EQ(problemOf(*lesson), "");
        } else {
            EXPECT_TRUE(lesson.error().sentence().starts_with("two-curves/")) << lesson.error().sentence();
        }
    }
    EXPECT_GT(read, 0);
    EXPECT_LT(read, rounds);
}

}  // namespace
}  // namespace echolucent
