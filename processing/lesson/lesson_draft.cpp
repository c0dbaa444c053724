#include "processing/lesson/lesson_draft.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace echolucent {

namespace {

constexpr std::string_view blanks = " \t\r\n";

void trim(std::string& text) {
    const auto begin = text.find_first_not_of(blanks);
    text = begin == std::string::npos ? std::string() : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

bool isComparison(const LessonCondition& condition) {
    return condition.kind != ConditionKind::all && condition.kind != ConditionKind::any;
}

std::optional<double> numberIn(std::string_view text) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number)) return std::nullopt;
    return number;
}

/// The value of a text without quotes; none if it is a text.
std::optional<DocumentValue> plainValue(std::string_view text) {
    if (text == "null") return DocumentValue(std::monostate{});
    if (text == "true" || text == "false") return DocumentValue(text == "true");
    if (const auto number = numberIn(text)) return DocumentValue(*number);
    return std::nullopt;
}

bool isQuoted(std::string_view text) { return text.size() >= 2 && text.front() == '"' && text.back() == '"'; }

/// Gathers problems. Of each field of a step and a language the first one is kept.
class LessonProblems {
public:
    LessonProblems(const Lesson& lesson, const LessonNames& names) : m_lesson(lesson), m_names(names) {}

    std::vector<LessonProblem> all() {
        for (std::size_t language = 0; language < m_lesson.texts.size(); ++language) lookAtWhole(language);
        if (m_lesson.steps.empty() || m_lesson.steps.size() > mostLessonSteps)
            add(LessonField::steps, {}, {}, "A lesson has 1 to " + std::to_string(mostLessonSteps) + " steps.");
        std::size_t conditions = 0;
        for (std::size_t step = 0; step < m_lesson.steps.size(); ++step) {
            for (std::size_t language = 0; language < m_lesson.texts.size(); ++language) lookAtWords(step, language);
            lookAtStep(step);
            const auto& until = m_lesson.steps[step].until;
            conditions += until ? conditionsIn(*until) : 0;
            if (conditions > mostLessonConditions)
                add(LessonField::condition, step, {},
                    "A lesson holds at most " + std::to_string(mostLessonConditions) + " conditions.");
        }
        if (m_problems.empty())
            if (const std::string problem = problemOf(m_lesson); !problem.empty())
                add(LessonField::whole, {}, {}, "The lesson cannot be saved: " + problem + ".");
        return std::move(m_problems);
    }

private:
    void add(LessonField field, std::optional<std::size_t> step, std::optional<std::size_t> language,
             std::string sentence) {
        const auto isSame = [&](const LessonProblem& each) {
            return each.field == field && each.step == step && each.language == language;
        };
        if (std::ranges::none_of(m_problems, isSame))
            m_problems.push_back({field, step, language, std::move(sentence)});
    }
    void limit(LessonField field, std::optional<std::size_t> step, std::size_t language, const std::string& text) {
        if (text.size() > longestLessonText)
            add(field, step, language, "This is longer than " + std::to_string(longestLessonText) + " bytes.");
    }
    void lookAtWhole(std::size_t language) {
        const LessonText& text = m_lesson.texts[language];
        if (text.title.empty() || text.title.size() > longestLessonTitle)
            add(LessonField::title, {}, language,
                "The lesson needs a title of at most " + std::to_string(longestLessonTitle) + " bytes.");
        limit(LessonField::summary, {}, language, text.summary);
    }
    void lookAtWords(std::size_t step, std::size_t language) {
        const LessonStepText& words = m_lesson.texts[language].steps.at(step);
        if (words.title.empty() || words.title.size() > longestLessonTitle)
            add(LessonField::stepTitle, step, language,
                "The step needs a title of at most " + std::to_string(longestLessonTitle) + " bytes.");
        if (words.text.empty()) add(LessonField::text, step, language, "Write what is to be seen and done.");
        limit(LessonField::text, step, language, words.text);
        limit(LessonField::hint, step, language, words.hint);
        lookAtQuestion(step, language, words);
        limit(LessonField::explanation, step, language, words.explanation);
    }
    void lookAtQuestion(std::size_t step, std::size_t language, const LessonStepText& words) {
        const std::size_t answers = m_lesson.steps[step].answers;
        const auto say = [&](const std::string& sentence) { add(LessonField::question, step, language, sentence); };
        if (answers == 0 && words.question.empty()) {
            if (!words.explanation.empty())
                add(LessonField::explanation, step, language, "Only a question has an explanation of its answer.");
            return;
        }
        if (words.question.empty()) say("Write the question, or remove its answers.");
        if (answers < fewestLessonAnswers || answers > mostLessonAnswers)
            say("A question has " + std::to_string(fewestLessonAnswers) + " to " + std::to_string(mostLessonAnswers) +
                " answers.");
        if (std::ranges::any_of(words.answers, &std::string::empty)) say("Write each answer, or remove it.");
        limit(LessonField::question, step, language, words.question);
        for (const std::string& answer : words.answers) limit(LessonField::question, step, language, answer);
    }
    void lookAtStep(std::size_t step) {
        const LessonStep& each = m_lesson.steps[step];
        if (each.lookAt.size() > longestLessonTitle || (!each.lookAt.empty() && !m_names.isControl(each.lookAt)))
            add(LessonField::target, step, {}, "The window has no control of this name.");
        if (!each.until) return;
        if (const std::string problem = problemOf(*each.until); !problem.empty())
            return add(LessonField::condition, step, {}, "The condition " + problem + ".");
        for (const std::string& name : namesIn(*each.until))
            if (!m_names.isValue(step, name))
                add(LessonField::condition, step, {},
                    "\"" + name + "\" is neither a value of the document nor a measured number.");
    }

    const Lesson& m_lesson;
    const LessonNames& m_names;
    std::vector<LessonProblem> m_problems;
};

}  // namespace

std::string whyNoLesson(const StudyReference& study, std::size_t snapshots) {
    const auto* scan = std::get_if<SimulatedScan>(&study);
    if (scan == nullptr)
        return "A lesson runs on a simulated scan, which every program makes anew from its seed. It holds no voxels, "
               "so snapshots of another study cannot become one. Open a simulated scan.";
    if (std::ranges::any_of(scan->size, [](std::int64_t voxels) { return voxels > largestLessonScan; }))
        return "A lesson's scan has at most " + std::to_string(largestLessonScan) + " voxels along each axis.";
    if (snapshots == 0) return "There is no snapshot. The panel Study keeps them.";
    if (snapshots > mostLessonSteps)
        return "A lesson has at most " + std::to_string(mostLessonSteps) + " steps, and there are more snapshots.";
    return {};
}

Lesson lessonOfSnapshots(const SimulatedScan& scan, const std::vector<Snapshot>& snapshots,
                         const std::string& language) {
    if (!whyNoLesson(scan, snapshots.size()).empty())
        throw std::invalid_argument("lessonOfSnapshots: no lesson can be made of these snapshots");
    Lesson lesson;
    lesson.begins = snapshots.front().document;
    lesson.begins.study = scan;
    lesson.texts = {LessonText{language, {}, {}, {}}};
    for (const Snapshot& snapshot : snapshots)
        insertStep(lesson, lesson.steps.size(), snapshot.name, snapshot.document);
    return lesson;
}

std::string freeLessonId(const Lesson& lesson, const std::string& name) {
    std::string plain;
    for (const char letter : name) {
        const bool capital = letter >= 'A' && letter <= 'Z';
        if (capital || (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9'))
            plain += capital ? static_cast<char>(letter - 'A' + 'a') : letter;
        else if (!plain.empty() && plain.back() != '-')
            plain += '-';
    }
    constexpr std::size_t roomForNumber = 3;
    plain.resize(std::min(plain.size(), longestLessonId - roomForNumber));
    while (!plain.empty() && plain.back() == '-') plain.pop_back();
    if (plain.empty()) plain = "step";
    std::string id = plain;
    for (int number = 2; std::ranges::find(lesson.steps, id, &LessonStep::id) != lesson.steps.end(); ++number)
        id = plain + "-" + std::to_string(number);
    return id;
}

void insertStep(Lesson& lesson, std::size_t place, const std::string& title, const Document& set) {
    if (place > lesson.steps.size()) throw std::out_of_range("insertStep: there is no such place");
    LessonStep step{.id = freeLessonId(lesson, title), .set = set};
    step.set->study = lesson.begins.study;
    const auto offset = static_cast<std::ptrdiff_t>(place);
    lesson.steps.insert(lesson.steps.begin() + offset, std::move(step));
    for (LessonText& text : lesson.texts) text.steps.insert(text.steps.begin() + offset, LessonStepText{title, {}});
}

void removeStep(Lesson& lesson, std::size_t step) {
    (void)lesson.steps.at(step);
    const auto offset = static_cast<std::ptrdiff_t>(step);
    lesson.steps.erase(lesson.steps.begin() + offset);
    for (LessonText& text : lesson.texts) text.steps.erase(text.steps.begin() + offset);
}

void moveStep(Lesson& lesson, std::size_t step, std::size_t place) {
    (void)lesson.steps.at(step);
    (void)lesson.steps.at(place);
    const auto move = [&](auto& list) {
        const auto from = list.begin() + static_cast<std::ptrdiff_t>(step),
                   to = list.begin() + static_cast<std::ptrdiff_t>(place);
        from < to ? std::rotate(from, from + 1, to + 1) : std::rotate(to, from, from + 1);
    };
    move(lesson.steps);
    for (LessonText& text : lesson.texts) move(text.steps);
}

void addAnswer(Lesson& lesson, std::size_t step) {
    ++lesson.steps.at(step).answers;
    for (LessonText& text : lesson.texts) text.steps.at(step).answers.emplace_back();
}

void removeAnswer(Lesson& lesson, std::size_t step, std::size_t answer) {
    LessonStep& asked = lesson.steps.at(step);
    if (answer >= asked.answers) throw std::out_of_range("removeAnswer: there is no such answer");
    --asked.answers;
    if (asked.right > answer || (asked.right == answer && asked.right == asked.answers && asked.right > 0))
        --asked.right;
    for (LessonText& text : lesson.texts) {
        std::vector<std::string>& answers = text.steps.at(step).answers;
        answers.erase(answers.begin() + static_cast<std::ptrdiff_t>(answer));
    }
}

Lesson trimmed(Lesson lesson) {
    for (LessonText& text : lesson.texts) {
        for (std::string* each : {&text.title, &text.summary}) trim(*each);
        for (LessonStepText& step : text.steps) {
            for (std::string* each : {&step.title, &step.text, &step.hint, &step.question, &step.explanation})
                trim(*each);
            for (std::string& answer : step.answers) trim(answer);
        }
    }
    return lesson;
}

std::optional<std::vector<LessonCondition>> comparisonsIn(const std::optional<LessonCondition>& until) {
    if (!until) return std::vector<LessonCondition>{};
    if (isComparison(*until)) return std::vector<LessonCondition>{*until};
    if (!std::ranges::all_of(until->parts, isComparison)) return std::nullopt;
    return until->parts;
}

std::optional<LessonCondition> conditionOf(ConditionKind allOrAny, const std::vector<LessonCondition>& comparisons) {
    if (comparisons.empty()) return std::nullopt;
    if (comparisons.size() == 1) return comparisons.front();
    LessonCondition condition{allOrAny};
    condition.parts = comparisons;
    return condition;
}

std::string typedOf(const DocumentValue& value) {
    if (std::holds_alternative<std::monostate>(value)) return "null";
    if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    if (const auto* number = std::get_if<double>(&value)) {
        constexpr std::size_t longest = 32;
        std::string text(longest, '\0');
        text.resize(
            static_cast<std::size_t>(std::to_chars(text.data(), text.data() + longest, *number).ptr - text.data()));
        return text;
    }
    const auto& text = std::get<std::string>(value);
    std::string bare = text;
    trim(bare);
    return plainValue(text) || isQuoted(text) || bare != text || text.empty() ? "\"" + text + "\"" : text;
}

DocumentValue valueTyped(std::string_view text) {
    std::string bare(text);
    trim(bare);
    if (isQuoted(bare)) return bare.substr(1, bare.size() - 2);
    if (const auto value = plainValue(bare)) return *value;
    return bare;
}

std::vector<LessonProblem> problemsOf(const Lesson& lesson, const LessonNames& names) {
    const Lesson words = trimmed(lesson);
    return LessonProblems(words, names).all();
}

}  // namespace echolucent
