// Lessons while they are written: made of snapshots, changed, and told what is wrong with them.
#include "processing/lesson/lesson_draft.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace echolucent {
namespace {

const SimulatedScan scan{PhantomScene::shapes, {48, 48, 40}, 7};

Snapshot snapshot(const std::string& name, CurveKind curve) {
    Snapshot made{name, lessonGround(scan)};
    made.document.study = {};  // as a session file holds it
    made.document.panes[0].curve = curve;
    return made;
}

Lesson threeSteps() {
    return lessonOfSnapshots(scan,
                             {snapshot("Snapshot 1", CurveKind::linear), snapshot("x²", CurveKind::parabolic),
                              snapshot("Snapshot 1", CurveKind::quartic)},
                             "en");
}

/// A lesson that holds its rules, in two languages.
Lesson wholeLesson() {
    Lesson lesson = threeSteps();
    lesson.steps[1].until = LessonCondition{ConditionKind::equal, "panes[0].curve", std::string("quartic")};
    lesson.steps[1].lookAt = "view3d";
    addAnswer(lesson, 2);
    addAnswer(lesson, 2);
    lesson.texts[0].title = "Curves";
    for (LessonStepText& step : lesson.texts[0].steps) step.text = "Look.";
    lesson.texts[0].steps[2].question = "Why?";
    lesson.texts[0].steps[2].answers = {"No", "Yes"};
    lesson.texts.push_back(lesson.texts[0]);
    lesson.texts[1].language = "pt";
    return lesson;
}

LessonNames names() {
    return {[](std::size_t, const std::string& name) { return name == "panes[0].curve"; },
            [](const std::string& name) { return name == "view3d"; }};
}

TEST(LessonDraft, EachSnapshotBecomesAStep) {
    const Lesson lesson = threeSteps();
    ASSERT_EQ(lesson.steps.size(), 3U);
    EXPECT_EQ(lesson.steps[0].id, "snapshot-1");
    EXPECT_EQ(lesson.steps[1].id, "x");
    EXPECT_EQ(lesson.steps[2].id, "snapshot-1-2");
    EXPECT_TRUE(lesson.steps[1].set->panes[0].curve == CurveKind::parabolic);
    EXPECT_TRUE(lesson.steps[1].set->study == StudyReference(scan));
    EXPECT_TRUE(lesson.begins == *lesson.steps[0].set);
    EXPECT_EQ(lesson.texts[0].steps[1].title, "x²");
    EXPECT_EQ(freeLessonId(lesson, "²"), "step");
    EXPECT_TRUE(isLessonId(freeLessonId(lesson, std::string(90, 'A') + "-")));
}

TEST(LessonDraft, SaysWhyThereIsNoLesson) {
    EXPECT_EQ(whyNoLesson(scan, 3), "");
    StudyFile heart;
    heart.path = "/heart.mha";
    EXPECT_NE(whyNoLesson(heart, 3).find("It holds no voxels"), std::string::npos);
    EXPECT_EQ(whyNoLesson(heart, 3).find("heart"), std::string::npos);
    EXPECT_NE(whyNoLesson(scan, 0).find("no snapshot"), std::string::npos);
    SimulatedScan large = scan;
    large.size[1] = 257;
    EXPECT_NE(whyNoLesson(large, 3).find("256 voxels"), std::string::npos);
    EXPECT_THROW((void)lessonOfSnapshots(large, {snapshot("a", CurveKind::linear)}, "en"), std::invalid_argument);
}

TEST(LessonDraft, StepsAndAnswersChangeInAllLanguages) {
    Lesson lesson = wholeLesson();
    moveStep(lesson, 2, 0);
    EXPECT_EQ(lesson.steps[0].id, "snapshot-1-2");
    EXPECT_EQ(lesson.steps[1].id, "snapshot-1");
    EXPECT_EQ(lesson.texts[1].steps[0].question, "Why?");
    moveStep(lesson, 0, 2);
    EXPECT_TRUE(lesson == wholeLesson());
    insertStep(lesson, 1, "New", lesson.begins);
    EXPECT_EQ(lesson.texts[1].steps[1].title, "New");
    removeStep(lesson, 1);
    EXPECT_TRUE(lesson == wholeLesson());
    EXPECT_THROW(removeStep(lesson, 3), std::out_of_range);

    addAnswer(lesson, 2);
    lesson.steps[2].right = 1;
    removeAnswer(lesson, 2, 0);
    EXPECT_EQ(lesson.steps[2].right, 0U) << "the right answer is the same one";
    EXPECT_EQ(lesson.texts[1].steps[2].answers, (std::vector<std::string>{"Yes", ""}));
    lesson.steps[2].right = 1;
    removeAnswer(lesson, 2, 1);
    EXPECT_EQ(lesson.steps[2].right, 0U);
    EXPECT_THROW(removeAnswer(lesson, 2, 1), std::out_of_range);
}

TEST(LessonDraft, ValuesAreTypedAndShown) {
    for (const DocumentValue& value :
         {DocumentValue(std::monostate{}), DocumentValue(true), DocumentValue(0.1), DocumentValue(-12.0),
          DocumentValue(std::numeric_limits<double>::max()), DocumentValue(std::string("linear")),
          DocumentValue(std::string("12")), DocumentValue(std::string("true")), DocumentValue(std::string(" a ")),
          DocumentValue(std::string("\"a\"")), DocumentValue(std::string())})
        EXPECT_TRUE(valueTyped(typedOf(value)) == value) << typedOf(value);
    EXPECT_EQ(typedOf(12.5), "12.5");
    EXPECT_EQ(typedOf(std::string("12")), "\"12\"");
    EXPECT_TRUE(valueTyped(" 3 ") == DocumentValue(3.0));
    EXPECT_TRUE(valueTyped("3 mm") == DocumentValue(std::string("3 mm")));
}

TEST(LessonDraft, ConditionsAreListsOfComparisons) {
    const LessonCondition linear{ConditionKind::equal, "panes[0].curve", std::string("linear")};
    const LessonCondition two{ConditionKind::less, "panes", 2.0};
    EXPECT_FALSE(conditionOf(ConditionKind::any, {}));
    EXPECT_TRUE(*conditionOf(ConditionKind::any, {linear}) == linear);
    const auto both = conditionOf(ConditionKind::any, {linear, two});
    EXPECT_TRUE(both->kind == ConditionKind::any);
    EXPECT_TRUE(comparisonsIn(both) == (std::vector<LessonCondition>{linear, two}));
    EXPECT_TRUE(comparisonsIn(linear) == std::vector<LessonCondition>{linear});
    EXPECT_TRUE(comparisonsIn(std::nullopt)->empty());
    LessonCondition nested{ConditionKind::all};
    nested.parts = {*both};
    EXPECT_FALSE(comparisonsIn(nested));
}

TEST(LessonDraft, EveryFieldSaysWhatIsWrong) {
    EXPECT_TRUE(problemsOf(wholeLesson(), names()).empty());
    EXPECT_EQ(problemOf(wholeLesson()), "");
    struct Wrong {
        LessonField field;
        const char* words;
        std::function<void(Lesson&)> change;
    };
    const std::string tooLong(8001, 'a');
    const Wrong table[] = {
        {LessonField::title, "needs a title", [](Lesson& lesson) { lesson.texts[0].title = " \n"; }},
        {LessonField::summary, "longer than 8000", [&](Lesson& lesson) { lesson.texts[0].summary = tooLong; }},
        {LessonField::stepTitle, "needs a title", [](Lesson& lesson) { lesson.texts[0].steps[1].title = ""; }},
        {LessonField::text, "Write what", [](Lesson& lesson) { lesson.texts[0].steps[1].text = ""; }},
        {LessonField::text, "longer than 8000", [&](Lesson& lesson) { lesson.texts[0].steps[1].text = tooLong; }},
        {LessonField::hint, "longer than 8000", [&](Lesson& lesson) { lesson.texts[0].steps[1].hint = tooLong; }},
        {LessonField::target, "no control", [](Lesson& lesson) { lesson.steps[1].lookAt = "view4d"; }},
        {LessonField::condition, "must name a value", [](Lesson& lesson) { lesson.steps[1].until->name = ""; }},
        {LessonField::condition, "neither a value", [](Lesson& lesson) { lesson.steps[1].until->name = "panes.x"; }},
        {LessonField::condition, "with a number",
         [](Lesson& lesson) { lesson.steps[1].until->kind = ConditionKind::less; }},
        {LessonField::question, "2 to 6", [](Lesson& lesson) { removeAnswer(lesson, 2, 0); }},
        {LessonField::question, "Write the question", [](Lesson& lesson) { lesson.texts[0].steps[2].question = ""; }},
        {LessonField::question, "each answer", [](Lesson& lesson) { lesson.texts[0].steps[2].answers[1] = " "; }},
        {LessonField::explanation, "Only a question",
         [](Lesson& lesson) { lesson.texts[0].steps[1].explanation = "So."; }},
        {LessonField::steps, "1 to 60",
         [](Lesson& lesson) {
             while (!lesson.steps.empty()) removeStep(lesson, 0);
         }},
        {LessonField::whole, "another study",
         [](Lesson& lesson) { lesson.steps[1].set->study = SimulatedScan{.seed = 8}; }},
    };
    for (const Wrong& wrong : table) {
        Lesson lesson = wholeLesson();
        wrong.change(lesson);
        const auto problems = problemsOf(lesson, names());
        ASSERT_FALSE(problems.empty()) << wrong.words;
        EXPECT_TRUE(problems[0].field == wrong.field) << problems[0].sentence;
        EXPECT_NE(problems[0].sentence.find(wrong.words), std::string::npos) << problems[0].sentence;
        EXPECT_TRUE(problems[0].sentence.ends_with('.'));
        const bool isOfStep = lesson.steps.size() == 3 && wrong.field != LessonField::title &&
                              wrong.field != LessonField::summary && wrong.field != LessonField::whole;
        EXPECT_EQ(problems[0].step.has_value(), isOfStep) << wrong.words;
    }
    Lesson other = wholeLesson();
    other.texts[1].steps[0].text = "";
    EXPECT_EQ(problemsOf(other, names()),
              (std::vector<LessonProblem>{{LessonField::text, 0, 1, "Write what is to be seen and done."}}));
}

}  // namespace
}  // namespace echolucent
