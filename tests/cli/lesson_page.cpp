// A lesson as a page: every word of it, nothing from elsewhere, and the command that writes it.
#include <fmt/format.h>

#include <filesystem>
#include <regex>

#include "app/pages/lesson_handout.h"
#include "app/pages/markdown_markup.h"
#include "io/lesson/lesson_file.h"
#include "tests/cli/program.h"
#include "tests/cli/well_formed.h"

namespace echolucent {
namespace {

/// A step that sets two panes, one that goes on, and one with a view of its own.
Lesson smallLesson() {
    Lesson lesson;
    lesson.minutes = 3;
    lesson.begins = lessonGround({PhantomScene::fetus, {32, 32, 24}, 7});
    lesson.begins.scene.look = Look{};
    lesson.begins.panes = {{.curve = CurveKind::linear}, {.curve = CurveKind::quartic}};
    Document one = lesson.begins;
    one.panes = {{.curve = CurveKind::parabolic}};
    one.scene.look.brightness = 1.25;
    lesson.steps = {{.id = "two"}, {.id = "on", .answers = 2, .right = 1}, {.id = "one", .set = one}};
    lesson.texts = {
        {"en",
         "Curves & <b>pictures</b>",
         "What a *curve* does.",
         {{"Two", "Look at **both**, [here](http://example.org/x).\n\n- a < b\n- so"},
          {"On", "Go on: ![the wall](wall.png) ![gone](gone.png)", "No `hint`", "Why?", {"No", "*Yes*"}, "So."},
          {"One", "<img src=\"file:///etc/passwd\"> &amp;"}}}};
    lesson.images["wall.png"] = "\x89PNG\r\n\x1a\n";
    return lesson;
}

/// The page without its pictures' bytes.
std::string bare(std::string page) {
    const std::string head = ";base64,";
    for (std::size_t at = page.find(head); at != std::string::npos; at = page.find(head, at + 1))
        page.erase(at + head.size(), page.find('"', at) - at - head.size());
    return page;
}

std::size_t countOfPart(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
    return count;
}

TEST(Markdown, IsWellFormedWhateverItIs) {
    const std::map<std::string, std::string> images{{"a.png", "\x89PNG\r\n\x1a\n"}, {"c.png", "something else"}};
    const auto markup = [&](const std::string& text) {
        std::set<std::string> embedded;
        return markdownMarkup(text, images, embedded);
    };
    EXPECT_EQ(markup("**strong *and* more**"), "<p><strong>strong <em>and</em> more</strong></p>\n");
    EXPECT_EQ(markup("2 * 3 * 4 and a\\*b\\*"), "<p>2 * 3 * 4 and a*b*</p>\n");
    EXPECT_EQ(markup("a\nb\n\nc"), "<p>a\nb</p>\n<p>c</p>\n");
    EXPECT_EQ(markup("1. one\n  goes on\n2. two\n\ntext\n- b"),
              "<ol>\n<li>one\ngoes on</li>\n<li>two</li>\n</ol>\n<p>text</p>\n<ul>\n<li>b</li>\n</ul>\n");
    EXPECT_EQ(markup("#### Small"), "<p><strong>Small</strong></p>\n");
    EXPECT_EQ(markup("![w](a.png) ![again](a.png) ![no image](c.png)"),
              "<p><img alt=\"w\" src=\"data:image/png;base64,iVBORw0KGgo=\"/> again no image</p>\n")
        << "each image once, and nothing that is none";
    EXPECT_EQ(markup("![w](b.png) [words](http://x)"), "<p>w words</p>\n");
    const std::string signs = "*`[]()!- #1.\\<>&\"ab \n";
    unsigned random = 5;
    for (int i = 0; i < 300; ++i) {
        std::string text;
        for (int k = 0; k < 60; ++k) text += signs[(random = random * 1664525U + 1013904223U) / 65536U % signs.size()];
        EXPECT_EQ(problemOf("<body>" + markup(text) + "</body>"), "") << text;
    }
    EXPECT_EQ(problemOf("<body>" + markup(std::string(8000, '*') + std::string(8000, '[')) + "</body>"), "");
}

TEST(LessonHandout, HoldsEveryStepAndNothingFromElsewhere) {
    const Lesson lesson = smallLesson();
    const auto pictures = lessonPictures(lesson);
    ASSERT_TRUE(pictures);
    ASSERT_EQ(pictures->size(), 3U);
    EXPECT_EQ((*pictures)[0].size(), 2U);
    EXPECT_EQ((*pictures)[0][1].second, "2: quartic");
    EXPECT_TRUE((*pictures)[1].empty()) << "the step shows what the one before showed";
    ASSERT_EQ((*pictures)[2].size(), 1U);
    EXPECT_EQ((*pictures)[2][0].first.width, 480);
    EXPECT_EQ((*pictures)[0][0].first.width, 320);
    EXPECT_NE((*pictures)[0][0].first.rgba, (*pictures)[0][1].first.rgba);

    LessonHandout handout;
    handout.language = "de";
    handout.program = "Echolucent 1";
    handout.pictures = *pictures;
    const std::string page = bare(lessonHandout(lesson, handout));
    EXPECT_EQ(problemOf(page), "");
    for (const char* part :
         {"<h1>Curves &amp; &lt;b&gt;pictures&lt;/b&gt;</h1>", "What a <em>curve</em> does.", "<h2>1. Two</h2>",
          "Look at <strong>both</strong>, here.", "<li>a &lt; b</li>", "<em>Hint:</em> No <code>hint</code>", "Why?",
          "(b) <em>Yes</em>", "<strong>2. (b)</strong> <em>Yes</em>", "<p>So.</p>",
          "&lt;img src=&quot;file:///etc/passwd&quot;&gt; &amp;amp;", "32 x 32 x 24 voxels, seed 7", "no patient",
          "<td>scene.look.brightness</td>", "Echolucent 1", "not a medical device"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
    EXPECT_LT(page.find("<h2>3. One</h2>"), page.find("<h2>Answers</h2>"));
    EXPECT_GT(page.find("<p>So.</p>"), page.find("<h2>Answers</h2>"));
    EXPECT_NE(page.find("<td>panes[0].curve</td><td>parabolic</td>"), std::string::npos);
    EXPECT_EQ(page.find("<td>null</td>"), std::string::npos);
    EXPECT_EQ(page.find("http"), std::string::npos);
    EXPECT_EQ(page.find("href="), std::string::npos);
    EXPECT_EQ(countOfPart(page, " src=\""), countOfPart(page, " src=\"data:image/"));
    EXPECT_EQ(countOfPart(page, "<img "), 4U) << "three pictures and the wall";
}

TEST(LessonHandout, TheCommandWritesAFolderAsAPage) {
    const Folder folder;
    Lesson whole = smallLesson();
    whole.texts[0].steps[1].text = "Go on: ![the wall](wall.png)";  // all of its images are there
    ASSERT_TRUE(writeLesson(folder / "curves", whole));
    const std::string page = folder / "curves.html", lesson = "lesson \"" + folder / "curves" + "\" --page \"";
    const Outcome outcome = runProgram(lesson + page + "\"");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    const std::string text = contentsOf(page);
    EXPECT_EQ(problemOf(bare(text)), "");
    EXPECT_NE(text.find("<h2>3. One</h2>"), std::string::npos);
    EXPECT_EQ(countOfPart(text, "<img "), 4U);
    EXPECT_EQ(text.find(folder.path()), std::string::npos);
    EXPECT_EQ(runProgram(lesson + folder / "curves/en.md" + "\"").status, 2) << "it was read";
    EXPECT_TRUE(readLesson(folder / "curves"));
    const Outcome missing = runProgram("lesson \"" + folder / "none" + "\" --page \"" + page + "\"");
    EXPECT_EQ(missing.status, 3);
    EXPECT_NE(missing.errors.find("no folder"), std::string::npos) << missing.errors;
}

}  // namespace
}  // namespace echolucent
