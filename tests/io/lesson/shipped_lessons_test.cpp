// The lessons that come with the program, played through their own conditions without a window.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "io/document/document_paths.h"
#include "io/lesson/lesson_file.h"
#include "io/study/simulated_study.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/document/panes.h"
#include "processing/pane_picture/pane_measures.h"

namespace echolucent {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lessonFolders() {
    std::vector<std::string> folders;
    for (const auto& each : fs::directory_iterator(std::string(ECHOLUCENT_SOURCE_DIR) + "/resources/lessons"))
        folders.push_back(each.path().string());
    std::sort(folders.begin(), folders.end());
    return folders;
}

std::shared_ptr<const Volume> scanOf(const Lesson& lesson) {
    static std::map<std::string, std::shared_ptr<const Volume>> made;
    const auto& scan = std::get<SimulatedScan>(lesson.begins.study);
    auto& volume = made[textAt(lesson.begins, "study").value()];
    if (volume) return volume;
    return volume = simulatedStudy(scan)->phases.front();
}

/// What the window knows of a document: its values, and what it measures at rest.
class Window {
public:
    Window(const Document& document, const std::shared_ptr<const Volume>& scan) : m_document(document), m_scan(scan) {}

    std::optional<DocumentValue> valueOf(std::string_view name) {
        if (name == "tubes of panes[1]")
            return static_cast<double>(
                adaptOpacity(*m_scan, otfViewpointOf(m_document, 1), configOf(m_document))->tubesWithWeight);
        if (name.ends_with(" of tube core 157")) {
            const auto otf = adaptOpacity(*m_scan, otfViewpointOf(m_document, firstPane), configOf(m_document));
            const TubeCore& tube = otf->tubes.at(157);
            if (name.starts_with("I_L")) return tube.lowIntensity.value();
            if (name.starts_with("I_H")) return tube.highIntensity.value();
            return tube.d;
        }
        if (!isLessonMeasure(name)) {
            auto value = valueAt(m_document, name);
            return value ? std::optional(*value) : std::nullopt;
        }
        if (name.starts_with("measured.tubes")) {
            const auto otf = adaptOpacity(*m_scan, otfViewpointOf(m_document, firstPane), configOf(m_document));
            return static_cast<double>(name == "measured.tubes" ? otf->tubesMeetingVolume : otf->tubesWithWeight);
        }
        const auto pane = static_cast<std::size_t>(name[name.find('[') + 1] - '0');
        if (!isCompared(m_document) || pane >= m_document.panes.size()) return std::nullopt;
        if (m_measures.empty()) m_measures = *measuresOfPanes(m_document, {.scans = {m_scan}});
        const ClassificationMeasures& measures = m_measures[pane]->measures;
        const std::string_view key = name.substr(name.rfind('.') + 1);
        if (key == "contrast") return measures.contrast.contrastToNoise();
        const ShownSurface shown = key == "right"   ? ShownSurface::right
                                   : key == "early" ? ShownSurface::early
                                   : key == "late"  ? ShownSurface::late
                                                    : ShownSurface::never;
        return 100.0 * *measures.depth.share(shown);
    }

private:
    const Document& m_document;
    std::shared_ptr<const Volume> m_scan;
    std::vector<std::optional<PaneMeasures>> m_measures;
};

bool isReached(const LessonCondition& until, const Document& document, const std::shared_ptr<const Volume>& scan) {
    Window window(document, scan);
    return holds(until, [&](std::string_view name) { return window.valueOf(name); });
}

/// Whether a person does the step by choosing a tube core, which is no part of a document. Skipping chooses it.
bool isChoiceOfTubeCore(const LessonCondition& until) {
    return until.kind == ConditionKind::equal && until.name == "measured.tube_core";
}

TEST(ShippedLessons, EachKeepsItsRules) {
    const std::vector<std::string> folders = lessonFolders();
    ASSERT_FALSE(folders.empty());
    for (const std::string& folder : folders) {
        const auto lesson = readLesson(folder);
        ASSERT_TRUE(lesson) << lesson.error().sentence();
        EXPECT_EQ(problemOf(*lesson), "") << folder;
        EXPECT_GE(lesson->steps.size(), 8U) << folder;
        EXPECT_LE(lesson->steps.size(), 12U) << folder;
        std::size_t questions = 0, tasks = 0;
        const LessonText& text = textIn(*lesson, "en");
        for (std::size_t i = 0; i < lesson->steps.size(); ++i) {
            const LessonStep& step = lesson->steps[i];
            questions += step.answers > 0 ? 1 : 0;
            tasks += step.until ? 1 : 0;
            EXPECT_EQ(step.until && !isChoiceOfTubeCore(*step.until), step.solved.has_value())
                << step.id << ": a task has a solution";
            EXPECT_TRUE(!step.until || !text.steps[i].hint.empty()) << step.id << ": a task has a hint";
            EXPECT_TRUE(step.answers == 0 || !text.steps[i].explanation.empty()) << step.id;
        }
        EXPECT_GE(questions, 4U) << folder;
        EXPECT_GE(tasks, 3U) << folder;
    }
}

bool isMeasured(const LessonCondition& until) {
    return std::ranges::any_of(namesIn(until), [](const std::string& name) { return isLessonMeasure(name); });
}

/// Applies the solution of each step whose condition is measured, or is not.
void playSteps(bool measured) {
    int played = 0;
    for (const std::string& folder : lessonFolders()) {
        const auto lesson = readLesson(folder);
        ASSERT_TRUE(lesson) << lesson.error().sentence();
        for (std::size_t i = 0; i < lesson->steps.size(); ++i) {
            const LessonStep& step = lesson->steps[i];
            if (!step.until || isChoiceOfTubeCore(*step.until) || isMeasured(*step.until) != measured) continue;
            ++played;
            const auto scan = measured ? scanOf(*lesson) : nullptr;
            EXPECT_FALSE(isReached(*step.until, documentBefore(*lesson, i), scan)) << folder << " " << step.id;
            EXPECT_TRUE(isReached(*step.until, documentAfter(*lesson, i), scan)) << folder << " " << step.id;
        }
    }
    EXPECT_GT(played, 0);
}

/// A number that the words of a step say.
struct SaidNumber {
    const char* lesson;
    const char* step;
    const char* name;
    double least, most;
    const char* of = "";  ///< what it is measured of: the step as it begins; `solved`; or a part put over that document
};

constexpr char solved[] = "solved";

constexpr SaidNumber saidNumbers[] = {
    {"x-squared", "three-powers", "measured.panes[0].right", 7.5, 8.5},
    {"x-squared", "three-powers", "measured.panes[0].late", 86.5, 87.5},
    {"x-squared", "three-powers", "measured.panes[1].right", 16.5, 17.5},
    {"x-squared", "three-powers", "measured.panes[1].late", 77.5, 78.5},
    {"x-squared", "three-powers", "measured.panes[2].never", 67.5, 68.5},
    {"x-squared", "one-number", "measured.panes[0].early", 69.5, 70.5},
    {"x-squared", "contrast", "measured.panes[0].right", 85.5, 86.5},
    {"x-squared", "contrast", "measured.panes[1].right", 87.5, 88.5},
    {"x-squared", "contrast", "measured.panes[0].contrast", 0.9, 1.1},
    {"x-squared", "contrast", "measured.panes[1].contrast", 2.1, 2.4},
    {"x-squared", "other-view", "measured.panes[0].right", 64, 68},
    {"x-squared", "other-view", "measured.panes[1].right", 74, 76},
    {"x-squared", "other-view", "measured.panes[0].contrast", 0.5, 0.6},
    {"x-squared", "other-view", "measured.panes[1].contrast", 1, 1.1},
    {"tube-core", "choose-one", "measured.tubes", 225, 225},
    {"tube-core", "choose-one", "measured.tubes_with_weight", 206, 206},
    {"tube-core", "ranks", "I_L of tube core 157", 0.0485, 0.0495},
    {"tube-core", "ranks", "I_H of tube core 157", 0.2245, 0.2255},
    {"tube-core", "ranks", "d of tube core 157", 0.01845, 0.01855},
    {"tube-core", "what-the-program-changes", "measured.panes[0].right", 32.5, 33.5},
    {"tube-core", "without-one", "measured.panes[0].right", 81.5, 81.55},
    {"tube-core", "without-one", "measured.panes[1].right", 81.65, 81.75},
    {"tube-core", "from-one-to-many", "measured.tubes_with_weight", 0, 0},
    {"others-and-speckle", "only-the-gradient", "measured.panes[1].early", 99.5, 100},
    {"others-and-speckle", "smooth-first", "measured.panes[0].right", 88.5, 89.5, solved},
    {"others-and-speckle", "smooth-first", "measured.panes[1].right", 30.5, 31.5, solved},
    {"others-and-speckle", "smooth-first", "measured.panes[1].early", 68.5, 69.5, solved},
    {"others-and-speckle", "intensity-alone", "measured.panes[0].right", 8.5, 9.5},
    {"others-and-speckle", "intensity-alone", "measured.panes[0].right", 85.5, 86.5, solved},
    {"others-and-speckle", "one-isosurface", "measured.panes[0].never", 47.5, 48.5},
    {"others-and-speckle", "isosurface-by-hand", "measured.panes[1].right", 87.5, 88.5, solved},
    {"others-and-speckle", "isosurface-by-hand", "measured.panes[0].right", 90.5, 91.5, solved},
    {"others-and-speckle", "a-step-edge", "measured.panes[0].right", 65.5, 66.5},
    {"others-and-speckle", "cells", "measured.panes[0].right", 72.5, 73.5},
    {"others-and-speckle", "cells", "measured.panes[0].right", 80.5, 81.5, solved},
    {"others-and-speckle", "two-hills", "measured.panes[0].right", 87.5, 88.5},
    {"others-and-speckle", "two-hills", "measured.panes[1].right", 88.5, 89.5},
    {"others-and-speckle", "another-view", "measured.panes[0].right", 74.5, 75.5},
    {"others-and-speckle", "another-view", "measured.panes[1].right", 74.5, 75.5},
    {"others-and-speckle", "another-view", "measured.panes[2].right", 60.5, 61.5},
    {"others-and-speckle", "another-view", "measured.panes[3].right", 73.5, 74.5},
    {"others-and-speckle", "another-view", "measured.panes[0].contrast", 1.085, 1.095},
    {"others-and-speckle", "another-view", "measured.panes[1].contrast", 0.855, 0.865},
    {"others-and-speckle", "another-view", "measured.panes[2].contrast", 0.265, 0.275},
    {"others-and-speckle", "another-view", "measured.panes[3].contrast", 0.775, 0.785},
    {"others-and-speckle", "smooth-first", "measured.panes[1].right", 15.5, 16.5,
     R"({"scene": {"look": {"reduction": "medium"}}})"},
    {"others-and-speckle", "intensity-alone", "measured.panes[0].right", 85.5, 86.5,
     R"({"scene": {"look": {"reduction": "strong"}}, "curves": {"linear": {"slope": 2}}})"},
    {"others-and-speckle", "isosurface-by-hand", "measured.panes[0].right", 47.5, 48.5,
     R"({"curves": {"linear": {"lower": 0.3}}})"},
    {"others-and-speckle", "isosurface-by-hand", "measured.panes[0].right", 55.5, 56.5,
     R"({"curves": {"linear": {"lower": 0.12}}})"},
    {"others-and-speckle", "cells", "measured.panes[0].right", 82, 100,
     R"({"method": {"parameters": {"cell_size": 7}}})"},
    {"others-and-speckle", "two-hills", "measured.panes[0].right", 81.5, 82.5,
     R"({"scene": {"look": {"reduction": "off"}}})"},
    {"others-and-speckle", "two-hills", "measured.panes[1].right", 87, 88,
     R"({"scene": {"look": {"reduction": "off"}}})"},
    {"one-otf-or-one-a-view", "question", "measured.tubes", 225, 225},
    {"one-otf-or-one-a-view", "question", "measured.tubes_with_weight", 213, 213},
    {"one-otf-or-one-a-view", "at-thirty", "measured.panes[0].right", 75.05, 75.15},
    {"one-otf-or-one-a-view", "at-thirty", "measured.panes[1].right", 75.15, 75.25},
    {"one-otf-or-one-a-view", "at-thirty", "tubes of panes[1]", 193, 193},
    {"one-otf-or-one-a-view", "look-for-a-difference", "measured.panes[0].right", 72.5, 73.5},
    {"one-otf-or-one-a-view", "look-for-a-difference", "measured.panes[1].right", 74.5, 75.5},
    {"one-otf-or-one-a-view", "fewer-tube-cores", "measured.tubes_with_weight", 213, 213},
    {"one-otf-or-one-a-view", "fewer-tube-cores", "tubes of panes[1]", 178, 178},
    {"one-otf-or-one-a-view", "fewer-tube-cores", "measured.panes[0].right", 62.5, 63.5},
    {"one-otf-or-one-a-view", "fewer-tube-cores", "measured.panes[1].right", 62.5, 63.5},
};

Document documentOf(const Lesson& lesson, const SaidNumber& said) {
    const auto step = std::ranges::find(lesson.steps, said.step, &LessonStep::id);
    const auto place = static_cast<std::size_t>(step - lesson.steps.begin());
    const std::string of = said.of;
    if (of == solved) return documentAfter(lesson, place);
    return of.empty() ? documentBefore(lesson, place) : withPart(documentBefore(lesson, place), of).value();
}

TEST(LongShippedLessons, TheWordsSayWhatIsMeasured) {
    std::size_t compared = 0;
    for (const std::string& folder : lessonFolders()) {
        const auto lesson = readLesson(folder);
        ASSERT_TRUE(lesson) << lesson.error().sentence();
        const auto scan = scanOf(*lesson);
        std::optional<Document> document;
        std::optional<Window> window;  // one for the numbers of the same document, which follow each other
        for (const SaidNumber& said : saidNumbers) {
            if (fs::path(folder).filename() != said.lesson) continue;
            ++compared;
            const Document next = documentOf(*lesson, said);
            if (document != next) window.emplace(document.emplace(next), scan);
            const auto value = window->valueOf(said.name);
            ASSERT_TRUE(value) << said.step << " " << said.name;
            EXPECT_GE(std::get<double>(*value), said.least) << said.step << " " << said.name << " " << said.of;
            EXPECT_LE(std::get<double>(*value), said.most) << said.step << " " << said.name << " " << said.of;
        }
    }
    EXPECT_EQ(compared, std::size(saidNumbers)) << "a number names a lesson that there is not";
}

TEST(ShippedLessons, EachStepIsDoneByItsSolutionAndNotBefore) { playSteps(false); }

TEST(LongShippedLessons, EachMeasuredStepIsDoneByItsSolutionAndNotBefore) { playSteps(true); }

}  // namespace
}  // namespace echolucent
