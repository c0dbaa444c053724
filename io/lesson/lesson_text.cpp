#include "io/lesson/lesson_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace echolucent {

namespace {

constexpr const char* remedyOfText = "Correct the text of the lesson.";

/// A heading: "## Title {#id}".
struct Heading {
    std::size_t level = 0;
    std::string title, id;
};

std::string trimmed(const std::string& text) {
    const auto begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1);
}

std::optional<Heading> headingIn(const std::string& line) {
    constexpr std::size_t deepest = 3;
    const std::size_t level = line.find_first_not_of('#');
    if (level == std::string::npos || level < 1 || level > deepest || line[level] != ' ') return std::nullopt;
    Heading heading{level, trimmed(line.substr(level)), {}};
    const std::size_t mark = heading.title.rfind("{#");
    if (mark != std::string::npos && heading.title.back() == '}') {
        heading.id = heading.title.substr(mark + 2, heading.title.size() - mark - 3);
        heading.title = trimmed(heading.title.substr(0, mark));
    }
    return heading;
}

/// The question and its answers, of a section whose list items are the answers.
void splitQuestion(const std::string& section, LessonStepText& step) {
    std::string text;
    std::size_t begin = 0;
    while (begin < section.size()) {
        const std::size_t end = std::min(section.find('\n', begin), section.size());
        const std::string line = section.substr(begin, end - begin);
        if (line.starts_with("- "))
            step.answers.push_back(trimmed(line.substr(2)));
        else if (!step.answers.empty() && !trimmed(line).empty())
            step.answers.back() += " " + trimmed(line);
        else if (step.answers.empty())
            text += line + "\n";
        begin = end + 1;
    }
    step.question = trimmed(text);
}

/// Reads the sections one after the other.
class TextReader {
public:
    TextReader(LessonText& text, const std::vector<std::string>& ids) : m_text(text), m_ids(ids) {
        m_text.steps.resize(ids.size());
    }

    /// What is wrong with a heading; empty if nothing is.
    std::string begin(const Heading& heading) {
        endSection();
        if (heading.level == 1) {
            if (!m_text.title.empty()) return "has more than one title";
            m_text.title = heading.title;
            m_into = &m_text.summary;
            return {};
        }
        if (!m_seen.insert(heading.level == 2 ? heading.id : m_step + "#" + heading.id).second)
            return "has two sections of {#" + heading.id + "}";
        if (heading.level == 2) {
            const auto place = std::ranges::find(m_ids, heading.id);
            if (place == m_ids.end()) return "has a section {#" + heading.id + "} that is no step of the lesson";
            m_step = heading.id;
            m_present = &m_text.steps[static_cast<std::size_t>(place - m_ids.begin())];
            m_present->title = heading.title;
            m_into = &m_present->text;
            return {};
        }
        if (m_present == nullptr) return "has a section {#" + heading.id + "} before the first step";
        m_isQuestion = heading.id == "question";
        if (heading.id == "hint")
            m_into = &m_present->hint;
        else if (heading.id == "explanation")
            m_into = &m_present->explanation;
        else if (m_isQuestion)
            m_into = nullptr;
        else
            return "has a section {#" + heading.id + "} that is no hint, question or explanation";
        return {};
    }
    void add(const std::string& line) { m_section += line + "\n"; }
    void endSection() {
        if (m_isQuestion && m_present != nullptr)
            splitQuestion(m_section, *m_present);
        else if (m_into != nullptr)
            *m_into = trimmed(m_section);
        m_section.clear();
        m_isQuestion = false;
        m_into = nullptr;
    }

private:
    LessonText& m_text;
    const std::vector<std::string>& m_ids;
    std::set<std::string> m_seen;
    std::string m_step, m_section;
    LessonStepText* m_present = nullptr;
    std::string* m_into = nullptr;
    bool m_isQuestion = false;
};

}  // namespace

std::vector<std::string> imagesIn(const std::string& markdown) {
    std::vector<std::string> names;
    for (std::size_t at = markdown.find("!["); at != std::string::npos; at = markdown.find("![", at + 2)) {
        const std::size_t close = markdown.find(']', at);
        if (close == std::string::npos || close + 1 >= markdown.size()) break;
        // An image within the words, or words that hide a bracket, would hide the outer image's name.
        const bool plain = markdown.substr(at + 2, close - at - 2).find_first_of("[`\\<") == std::string::npos;
        const std::size_t begin = markdown.find_first_not_of(markdown[close + 1] == ':' ? ": \t" : "( \t<", close + 1);
        if (!plain || (markdown[close + 1] != '(' && markdown[close + 1] != ':') || begin == std::string::npos) {
            names.emplace_back();  // or refers to a definition elsewhere, which no image of a lesson does
            continue;
        }
        names.push_back(markdown.substr(begin, markdown.find_first_of(" \t\r\n)>", begin) - begin));
    }
    return names;
}

Result<LessonText> lessonTextFrom(const std::string& markdown, const std::string& language,
                                  const std::vector<std::string>& ids, const std::vector<std::string>& images,
                                  const std::string& file) {
    const auto refuse = [&](const std::string& problem) {
        return fail(FailureKind::unreadable, file, {}, problem, remedyOfText);
    };
    for (const std::string& image : imagesIn(markdown))
        if (std::ranges::find(images, image) == images.end())
            return refuse("shows an image that is no file of the lesson's folder");
    LessonText text;
    text.language = language;
    TextReader reader(text, ids);
    std::size_t begin = 0;
    while (begin < markdown.size()) {
        const std::size_t end = std::min(markdown.find('\n', begin), markdown.size());
        std::string line = markdown.substr(begin, end - begin);
        begin = end + 1;
        if (!line.empty() && line.back() == '\r') line.pop_back();
        if (const auto heading = headingIn(line)) {
            if (const std::string problem = reader.begin(*heading); !problem.empty()) return refuse(problem);
        } else {
            reader.add(line);
        }
    }
    reader.endSection();
    return text;
}

std::string markdownOf(const LessonText& text, const std::vector<std::string>& ids) {
    std::string markdown = "# " + text.title + "\n";
    const auto add = [&](const std::string& heading, const std::string& words) {
        if (!words.empty()) markdown += (heading.empty() ? "\n" : "\n### " + heading + "\n") + words + "\n";
    };
    add({}, text.summary);
    for (std::size_t i = 0; i < text.steps.size(); ++i) {
        const LessonStepText& step = text.steps[i];
        markdown += fmt::format("\n## {} {{#{}}}\n", step.title, ids.at(i));
        add({}, step.text);
        add("Hint {#hint}", step.hint);
        std::string question = step.question;
        for (const std::string& answer : step.answers) question += "\n- " + answer;
        add("Question {#question}", question);
        add("Explanation {#explanation}", step.explanation);
    }
    return markdown;
}

std::vector<LessonProblem> problemsOfMarkdown(const Lesson& lesson) {
    std::vector<std::string> images;
    for (const auto& [name, bytes] : lesson.images) images.push_back(name);
    std::vector<LessonProblem> problems;
    for (std::size_t language = 0; language < lesson.texts.size(); ++language) {
        const LessonText& text = lesson.texts[language];
        const auto differs = [&](const LessonText& part, const std::vector<std::string>& ids) {
            const auto read = lessonTextFrom(markdownOf(part, ids), part.language, ids, images, {});
            return !read || *read != part;
        };
        if (differs({text.language, text.title, text.summary, {}}, {}))
            problems.push_back({LessonField::summary,
                                {},
                                language,
                                "A line must not begin with #, which begins a section, and only images of the lesson's "
                                "folder are shown."});
        for (std::size_t step = 0; step < text.steps.size(); ++step)
            if (differs({text.language, text.title, {}, {text.steps[step]}}, {"step"}))
                problems.push_back({LessonField::text, step, language,
                                    "A line must not begin with #, which begins a section, a line of a question not "
                                    "with a hyphen, which begins an answer, and only images of the lesson's folder are "
                                    "shown."});
    }
    return problems;
}

}  // namespace echolucent
