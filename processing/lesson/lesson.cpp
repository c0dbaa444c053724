#include "processing/lesson/lesson.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "processing/document/asked_phases.h"

namespace echolucent {

namespace {

bool isPlainName(const std::string& name, std::size_t longest) {
    const auto isPlain = [](char letter) {
        return (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') || letter == '-';
    };
    return !name.empty() && name.size() <= longest && name.front() != '-' && std::ranges::all_of(name, isPlain);
}

const SimulatedScan* scanOf(const Document& document) { return std::get_if<SimulatedScan>(&document.study); }

/// A simulated scan has one phase, as a session of it must.
std::string problemOfPhases(const Document& document) {
    if (lastPhaseOf(document) > 0) return "must not ask for a phase beyond the first, which is the only one";
    if (document.motion.scenario != MotionScenario::probe) return "must have the motion of the probe, of a still scan";
    return {};
}

std::string problemOfStep(const Lesson& lesson, const LessonStep& step) {
    if (!isLessonId(step.id)) return "id must be 1 to 40 lower case letters, digits and hyphens";
    if (std::ranges::count(lesson.steps, step.id, &LessonStep::id) != 1)
        return "id must be another than that of the other steps";
    if (step.lookAt.size() > longestLessonTitle) return "look_at must be the name of a control";
    if (step.until)
        if (std::string problem = problemOf(*step.until); !problem.empty()) return "until " + problem;
    const bool asks = step.answers > 0;
    if (asks && (step.answers < fewestLessonAnswers || step.answers > mostLessonAnswers))
        return "question.answers must be 2 to 6";
    if (asks && step.right >= step.answers) return "question.right must be the place of an answer, counted from 0";
    for (const auto& [name, document] : {std::pair("set", &step.set), std::pair("solution", &step.solved)}) {
        if (!*document) continue;
        if ((*document)->study != lesson.begins.study) return std::string(name) + " must not set another study";
        if (std::string problem = problemOfPhases(**document); !problem.empty())
            return std::string(name) + " " + problem;
    }
    return {};
}

bool isTooLong(const LessonStepText& text) {
    const auto tooLong = [](const std::string& each) { return each.size() > longestLessonText; };
    return text.title.size() > longestLessonTitle || std::ranges::any_of(text.answers, tooLong) || tooLong(text.text) ||
           tooLong(text.hint) || tooLong(text.question) || tooLong(text.explanation);
}

std::string problemOfText(const Lesson& lesson, const LessonText& text) {
    if (!isLessonLanguage(text.language)) return "must be named after its language";
    if (text.title.empty() || text.title.size() > longestLessonTitle) return "must have a title of 1 to 120 bytes";
    if (text.summary.size() > longestLessonText) return "has too long a summary";
    if (text.steps.size() != lesson.steps.size()) return "must have a text for each step";
    for (std::size_t i = 0; i < text.steps.size(); ++i) {
        const LessonStepText& step = text.steps[i];
        const std::string& id = lesson.steps[i].id;
        if (step.title.empty() || step.text.empty()) return "must have a title and a text for the step " + id;
        if (isTooLong(step))
            return "has a text of more than 8000 bytes, or a title of more than 120, in the step " + id;
        if (step.answers.size() != lesson.steps[i].answers || step.question.empty() != step.answers.empty())
            return "must have a question with " + std::to_string(lesson.steps[i].answers) + " answers in the step " +
                   id;
        if (step.question.empty() && !step.explanation.empty())
            return "must not explain an answer without a question in the step " + id;
    }
    return {};
}

}  // namespace

bool isLessonId(const std::string& id) { return isPlainName(id, longestLessonId); }

bool isLessonLanguage(const std::string& language) {
    const auto areLetters = [](std::string_view part) {
        return std::ranges::all_of(part, [](char letter) { return letter >= 'a' && letter <= 'z'; });
    };
    const std::string_view whole = language;
    const std::size_t hyphen = std::min(whole.find('-'), whole.size());
    const std::string_view own = whole.substr(0, hyphen), country = whole.substr(hyphen);
    const bool named = (own.size() == 2 || own.size() == 3) && areLetters(own);
    return named && (country.empty() || (country.size() == 3 && areLetters(country.substr(1))));
}

Document lessonGround(const SimulatedScan& scan) {
    Document document;
    document.study = scan;
    return document;
}

Document documentBefore(const Lesson& lesson, std::size_t step) {
    if (lesson.steps.at(step).set) return *lesson.steps[step].set;
    return step == 0 ? lesson.begins : documentAfter(lesson, step - 1);
}

Document documentAfter(const Lesson& lesson, std::size_t step) {
    const auto& solved = lesson.steps.at(step).solved;
    return solved ? *solved : documentBefore(lesson, step);
}

const LessonText& textIn(const Lesson& lesson, const std::string& language) {
    if (lesson.texts.empty()) throw std::invalid_argument("textIn: the lesson has no texts");
    for (const std::string& wanted : {language, language.substr(0, language.find('-')), std::string("en")})
        if (const auto found = std::ranges::find(lesson.texts, wanted, &LessonText::language);
            found != lesson.texts.end())
            return *found;
    return lesson.texts.front();
}

std::string problemOfSteps(const Lesson& lesson) {
    constexpr int mostMinutes = 600;
    if (lesson.minutes < 1 || lesson.minutes > mostMinutes) return "minutes must be 1 to 600";
    const SimulatedScan* scan = scanOf(lesson.begins);
    if (scan == nullptr) return "study must be a simulated scan";
    constexpr std::int64_t smallest = 24;
    for (const std::int64_t voxels : scan->size)
        if (voxels < smallest || voxels > largestLessonScan) return "study.size must be three numbers from 24 to 256";
    if (lesson.steps.empty() || lesson.steps.size() > mostLessonSteps) return "steps must be 1 to 60";
    if (const std::string problem = problemOfPhases(lesson.begins); !problem.empty()) return "begins " + problem;
    std::size_t conditions = 0;
    for (const LessonStep& step : lesson.steps) conditions += step.until ? conditionsIn(*step.until) : 0;
    if (conditions > mostLessonConditions) return "must hold at most 200 conditions";
    for (std::size_t i = 0; i < lesson.steps.size(); ++i)
        if (const std::string problem = problemOfStep(lesson, lesson.steps[i]); !problem.empty())
            return "steps[" + std::to_string(i) + "]." + problem;
    return {};
}

std::string problemOf(const Lesson& lesson) {
    if (std::string problem = problemOfSteps(lesson); !problem.empty()) return problem;
    if (lesson.texts.empty() || lesson.texts.size() > mostLessonLanguages) return "languages must be 1 to 20";
    for (const LessonText& text : lesson.texts)
        if (const std::string problem = problemOfText(lesson, text); !problem.empty())
            return text.language + ".md " + problem;
    if (lesson.images.size() > mostLessonImages) return "must have at most 40 images";
    for (const auto& [name, bytes] : lesson.images)
        if (bytes.size() > largestLessonImage) return "has an image of more than 4 MiB: " + name;
    return {};
}

}  // namespace echolucent
