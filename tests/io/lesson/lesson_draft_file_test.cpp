// Drafts of lessons: whatever was typed comes back, and damage ends in a sentence.
#include "io/lesson/lesson_draft_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include "io/files/input_file.h"
#include "tests/inputs.h"
#include "tests/io/written_files/temporary_folder.h"

namespace echolucent {
namespace {

/// Nothing of it could be saved as a lesson.
LessonDraft unfinishedDraft() {
    LessonDraft draft;
    draft.folder = "/somewhere/else";
    draft.step = 1;
    draft.language = 1;
    Lesson& lesson = draft.lesson;
    lesson.minutes = 7;
    lesson.begins = lessonGround({PhantomScene::fetus, {48, 48, 40}, 18'446'744'073'709'551'615U});
    lesson.begins.scene.look.brightness = 1.25;
    Document set = lesson.begins, solved = lesson.begins;
    set.panes = {{.curve = CurveKind::linear}, {.curve = CurveKind::quartic}};
    solved.panes[0].curve = CurveKind::parabolic;
    LessonCondition any{ConditionKind::any}, all{ConditionKind::all};
    any.parts = {{ConditionKind::equal, "", std::string("line\n")}, {ConditionKind::between, "no.name", true, 3.5}};
    all.parts = {any, {ConditionKind::present, "panes"}};
    lesson.steps = {{.id = "No id", .lookAt = "nothing", .set = set, .until = all, .answers = 1, .right = 0},
                    {.id = "No id", .solved = solved}};
    lesson.texts = {{"en", "", "# no summary", {{"", "## text {#id}\n", " "}, {"b", ""}}},
                    {"pt", "Título", "", {{"ç", "", "", "", {""}, "x"}, {"", ""}}}};
    lesson.texts[0].steps[0].answers = {"- a"};
    lesson.images = {{"wall.png", "PNG"}};
    return draft;
}

TEST(LessonDraftFile, WhateverWasTypedComesBack) {
    const TemporaryFolder folder;
    const std::string place = folder.path() + "/drafts/one";
    LessonDraft draft = unfinishedDraft();
    for (int i = 0; i < 2; ++i) {
        const auto written = writeLessonDraft(place, draft);
        ASSERT_TRUE(written) << written.error().sentence();
        const auto again = readLessonDraft(place);
        ASSERT_TRUE(again) << again.error().sentence();
        EXPECT_TRUE(*again == draft);
        draft.lesson.texts[0].title = "Now it has one";
        draft.lesson.images["floor.png"] = "png";
    }
    EXPECT_FALSE(readLessonDraft(folder.path()));
}

TEST(LessonDraftFile, DamageEndsInASentence) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeLessonDraft(folder.path(), unfinishedDraft()));
    const std::string file = folder.path() + "/" + lessonDraftFileName;
    const std::string whole = *readWholeFile(file, 1'000'000);
    std::mt19937 random(5);
    int refused = 0;
    const int count = takesSomeInputs ? 30 : 150;
    for (int i = 0; i < count; ++i) {
        std::string bytes = whole;
        for (int change = 0; change < 3; ++change) bytes[random() % bytes.size()] = static_cast<char>(random());
        if (i % 3 == 0) bytes.resize(random() % bytes.size());
        std::ofstream(file, std::ios::binary) << bytes;
        const auto draft = readLessonDraft(folder.path());
        if (draft) continue;
        ++refused;
        EXPECT_NE(draft.error().sentence().find(lessonDraftFileName), std::string::npos);
    }
    EXPECT_GT(refused, count / 3);
}

}  // namespace
}  // namespace echolucent
