#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>

#include "io/document/document_paths.h"
#include "io/document/session_file.h"
#include "io/files/input_file.h"
#include "io/json/json_fields.h"
#include "io/lesson/lesson_file.h"
#include "io/lesson/lesson_json.h"
#include "io/lesson/lesson_text.h"

namespace echolucent {

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr const char* remedyOfLesson = "Correct the file, or ask who made the lesson.";
constexpr std::string_view sessionSuffix = ".session.json", textSuffix = ".md";
constexpr std::array<std::string_view, 3> imageSuffixes{".png", ".jpg", ".jpeg"};

bool isImage(const std::string& name) {
    return std::ranges::any_of(imageSuffixes, [&](std::string_view suffix) { return name.ends_with(suffix); });
}

/// Reads lesson.json. The first problem is kept, as JsonFields does.
class LessonReader {
public:
    explicit LessonReader(const LessonFiles& files) : m_files(files), m_problems{pathOf(lessonFileName), {}} {}

    Result<Lesson> read() {
        const auto text = m_files.bytes.find(lessonFileName);
        if (text == m_files.bytes.end())
            return fail(FailureKind::unreadable, pathOf(lessonFileName), {}, "is missing", remedyOfLesson);
        const auto object = jsonObject(text->second, m_problems.file, std::string(lessonFormatName), remedyOfLesson);
        if (!object) return tl::unexpected(object.error());
        Lesson lesson = lessonIn(*object);
        if (m_problems.first) return refused();
        // Texts of steps that break a rule would be blamed for it.
        if (const std::string problem = problemOfSteps(lesson); !problem.empty()) return refuseLesson(problem);
        for (const auto& [name, bytes] : m_files.bytes)
            if (isImage(name)) lesson.images.emplace(name, bytes);
        if (auto texts = readTexts(lesson); !texts) return tl::unexpected(texts.error());
        if (const std::string problem = problemOf(lesson); !problem.empty()) return refuseLesson(problem);
        return lesson;
    }

private:
    [[nodiscard]] std::string pathOf(const std::string& name) const {
        return m_files.folder.empty() ? name : m_files.folder + "/" + name;
    }
    [[nodiscard]] tl::unexpected<Failure> refuseLesson(const std::string& problem) const {
        return fail(FailureKind::unreadable, m_problems.file, {}, problem, remedyOfLesson);
    }
    tl::unexpected<Failure> refused() {
        if (m_problems.first->kind == FailureKind::wrongUsage) m_problems.first->kind = FailureKind::unreadable;
        return m_problems.refused(remedyOfLesson);
    }
    void wrong(const Failure& failure) {
        if (!m_problems.first) m_problems.first = failure;
    }
    void wrong(const std::string& place, const std::string& problem) {
        wrong(Failure{FailureKind::unreadable, m_problems.file, place, problem, {}});
    }

    /// Refuses keys of an object that are none of `known`.
    void requireKnown(const json& object, const std::string& place, std::span<const std::string_view> known) {
        if (!object.is_object()) return;
        for (const auto& [key, value] : object.items())
            if (std::ranges::find(known, key) == known.end())
                wrong((place.empty() ? "" : place + ".") + JsonFields::shortened(key), "is no key of a lesson");
    }

    Lesson lessonIn(const json& root) {
        constexpr std::array<std::string_view, 7> keys{"format", "version", "minutes", "study",
                                                       "begins", "session", "steps"};
        requireKnown(root, {}, keys);
        JsonFields fields(root, {}, m_problems);
        Lesson lesson;
        lesson.minutes = static_cast<int>(fields.whole("minutes", 1, 600));
        lesson.begins = lessonGround(scanIn(root, fields));
        m_ground = lesson.begins;
        if (const auto begins = documentIn(root, "begins", {}, lesson.begins)) lesson.begins = *begins;
        m_ground = lesson.begins;
        Document before = lesson.begins;
        std::vector<JsonFields> steps = fields.list("steps", mostLessonSteps);
        for (std::size_t i = 0; i < steps.size() && !m_problems.first; ++i)
            lesson.steps.push_back(stepIn(root["steps"][i], steps[i], fmt::format("steps[{}]", i), before));
        return lesson;
    }

    SimulatedScan scanIn(const json& root, JsonFields& fields) {
        constexpr std::array<std::string_view, 3> keys{"scene", "size", "seed"};
        SimulatedScan scan;
        JsonFields study = fields.object("study");
        if (m_problems.first) return scan;
        requireKnown(root["study"], "study", keys);
        scan.scene = study.choice("scene", &phantomSceneFromName);
        scan.size = study.size("size", static_cast<double>(largestLessonScan));
        scan.seed = study.seed("seed");
        return scan;
    }

    /// The document of the key `part`, put over `ground`, or of the session named under "session". None without
    /// either key, and if something is wrong.
    std::optional<Document> documentIn(const json& object, const char* part, const std::string& place,
                                       const Document& ground) {
        const std::string before = place.empty() ? "" : place + ".";
        if (m_problems.first) return std::nullopt;
        const bool named = object.contains("session");
        if (named && object.contains(part)) {
            wrong(before + "session", fmt::format("must not stand beside {}", part));
            return std::nullopt;
        }
        if (named) return sessionIn(object, place);
        if (!object.contains(part)) return std::nullopt;
        if (object[part].is_object() && object[part].contains("study")) {
            wrong(before + part + ".study", "is that of the lesson");
            return std::nullopt;
        }
        auto read = withPart(ground, object[part].dump(), m_problems.file, before + part);
        if (read) return std::move(*read);
        wrong(read.error());
        return std::nullopt;
    }

    std::optional<Document> sessionIn(const json& object, const std::string& place) {
        const std::string name = JsonFields(object, place, m_problems).text("session");
        if (m_problems.first) return std::nullopt;
        const auto file = m_files.bytes.find(name);
        if (!name.ends_with(sessionSuffix) || file == m_files.bytes.end()) {
            wrong((place.empty() ? "" : place + ".") + "session",
                  "must be the name of a session file (….session.json) in the lesson's folder");
            return std::nullopt;
        }
        auto session = sessionFromJson(file->second, pathOf(name));
        if (!session) {
            wrong(session.error());
            return std::nullopt;
        }
        if (session->document.study != m_ground.study) {
            wrong(Failure{FailureKind::unreadable, pathOf(name), "study", "must be the lesson's simulated scan", {}});
            return std::nullopt;
        }
        return std::move(session->document);
    }

    LessonStep stepIn(const json& object, JsonFields& fields, const std::string& place, Document& before) {
        constexpr std::array<std::string_view, 7> keys{"id",    "look_at",  "set",     "session",
                                                       "until", "solution", "question"};
        requireKnown(object, place, keys);
        LessonStep step;
        step.id = fields.text("id");
        if (fields.has("look_at")) step.lookAt = fields.text("look_at");
        step.set = documentIn(object, "set", place, m_ground);
        if (step.set) before = *step.set;
        const Document beginning = before;
        if (fields.has("solution") && !m_problems.first) {
            auto solved = withPart(beginning, object["solution"].dump(), m_problems.file, place + ".solution");
            if (solved)
                step.solved = before = *solved;
            else
                wrong(solved.error());
        }
        if (fields.has("until") && !m_problems.first)
            step.until = conditionIn(object["until"], place + ".until", {&beginning, &before}, 1);
        if (fields.has("question")) {
            constexpr std::array<std::string_view, 2> questionKeys{"answers", "right"};
            JsonFields question = fields.object("question");
            requireKnown(object["question"], place + ".question", questionKeys);
            step.answers = static_cast<std::size_t>(question.whole("answers", fewestLessonAnswers, mostLessonAnswers));
            step.right =
                static_cast<std::size_t>(question.whole("right", 0, static_cast<std::int64_t>(step.answers) - 1));
        }
        return step;
    }

    /// {"equal": ["panes[0].curve", "linear"]}. Its names must name a value of one of the documents, or a measure.
    LessonCondition conditionIn(const json& object, const std::string& place,
                                const std::array<const Document*, 2>& documents, int depth) {
        LessonCondition condition;
        if (m_problems.first) return condition;
        if (++m_conditions > mostLessonConditions) {
            wrong(place, "is one condition too many: a lesson holds at most 200");
            return condition;
        }
        const bool single = object.is_object() && object.size() == 1;
        const auto kind = single ? conditionKindFromName(object.begin().key()) : std::nullopt;
        if (!kind) {
            wrong(place, "must be one of all, any, equal, not_equal, less, greater, between and present");
            return condition;
        }
        condition.kind = *kind;
        const json& value = object.begin().value();
        const std::string here = fmt::format("{}.{}", place, object.begin().key());
        if (*kind == ConditionKind::all || *kind == ConditionKind::any) {
            if (!value.is_array() || value.empty() || value.size() > mostConditionParts)
                wrong(here, "must be a list of 1 to 20 conditions");
            else if (depth >= deepestCondition)
                wrong(here, "nests deeper than 4 conditions");
            else
                for (std::size_t i = 0; i < value.size(); ++i)
                    condition.parts.push_back(
                        conditionIn(value[i], fmt::format("{}[{}]", here, i), documents, depth + 1));
            return condition;
        }
        const std::size_t count = *kind == ConditionKind::between ? 3 : 2;
        const bool only = *kind == ConditionKind::present && value.is_string();
        const bool list = value.is_array() && value.size() == count && value[0].is_string();
        if (*kind == ConditionKind::present ? !only : !list) {
            wrong(here, only || *kind == ConditionKind::present ? "must be the name of a value"
                        : count == 3                            ? "must be a list of a name and two numbers"
                                                                : "must be a list of a name and a value");
            return condition;
        }
        condition.name = only ? value.get<std::string>() : value[0].get<std::string>();
        const auto known = [&](const Document* document) { return valueAt(*document, condition.name).has_value(); };
        if (!isLessonMeasure(condition.name) && !std::ranges::any_of(documents, known)) {
            wrong(here, "names \"" + JsonFields::shortened(condition.name) +
                            "\", which is neither a value of the document nor a measured number");
            return condition;
        }
        if (only) return condition;
        if (!takeValue(value[1], condition.value))
            wrong(here, "must compare with a number, a text, true, false or null");
        if (count == 3 && value[2].is_number())
            condition.largest = value[2].get<double>();
        else if (count == 3)
            wrong(here, "must be a list of a name and two numbers");
        if (const std::string problem = problemOf(condition); !problem.empty()) wrong(here, problem);
        return condition;
    }

    Result<void> readTexts(Lesson& lesson) {
        std::vector<std::string> ids, images;
        for (const LessonStep& step : lesson.steps) ids.push_back(step.id);
        for (const auto& [name, bytes] : lesson.images) images.push_back(name);
        for (const auto& [name, bytes] : m_files.bytes) {
            if (!name.ends_with(textSuffix)) continue;
            const std::string language = name.substr(0, name.size() - textSuffix.size());
            if (!isLessonLanguage(language)) continue;  // README.md
            auto text = lessonTextFrom(bytes, language, ids, images, pathOf(name));
            if (!text) return tl::unexpected(text.error());
            lesson.texts.push_back(std::move(*text));
        }
        return {};
    }

    const LessonFiles& m_files;
    JsonProblems m_problems;
    Document m_ground;
    std::size_t m_conditions = 0;  ///< that were read
};

/// How many bytes a file of this name may hold; none if it belongs to no lesson.
std::optional<std::size_t> limitOf(const std::string& name) {
    if (name.starts_with('.')) return std::nullopt;
    if (isImage(name)) return largestLessonImage;
    if (name == lessonFileName || name.ends_with(textSuffix) || name.ends_with(sessionSuffix)) return largestLessonFile;
    return std::nullopt;
}

}  // namespace

bool takeValue(const json& value, DocumentValue& taken) {
    if (value.is_null())
        taken = std::monostate{};
    else if (value.is_boolean())
        taken = value.get<bool>();
    else if (value.is_number())
        taken = value.get<double>();
    else if (value.is_string())
        taken = value.get<std::string>();
    else
        return false;
    return true;
}

Result<LessonFiles> lessonFilesIn(const std::string& folder) {
    const auto refuse = [&](const std::string& file, const std::string& problem) {
        return fail(FailureKind::unreadable, file, {}, problem, remedyOfLesson);
    };
    LessonFiles files{folder, {}};
    std::error_code error;
    fs::directory_iterator entry(folder, error);
    if (error) return refuse(folder, "is no folder that can be read");
    std::size_t entries = 0, total = 0;
    for (; entry != fs::directory_iterator() && !error; entry.increment(error)) {
        if (++entries > mostLessonEntries) return refuse(folder, "holds more than 1000 files");
        const std::string name = entry->path().filename().string();
        const auto limit = limitOf(name);
        if (!limit) continue;
        const std::string path = entry->path().string();
        std::error_code unknown;
        if (fs::is_symlink(entry->symlink_status(unknown)))
            return refuse(path, "is a link, which a lesson must not hold");
        if (!fs::is_regular_file(entry->symlink_status(unknown))) return refuse(path, "is no file");
        if (files.bytes.size() >= mostLessonFiles) return refuse(folder, "holds more than 100 files of a lesson");
        auto bytes = readWholeFile(path, std::min(*limit, mostLessonBytes - total));
        if (!bytes) return tl::unexpected(bytes.error());
        total += bytes->size();
        files.bytes.emplace(name, std::move(*bytes));
    }
    if (error) return refuse(folder, "could not be read to its end");
    return files;
}

Result<Lesson> lessonFrom(const LessonFiles& files) { return LessonReader(files).read(); }

Result<Lesson> readLesson(const std::string& folder) {
    const auto files = lessonFilesIn(folder);
    if (!files) return tl::unexpected(files.error());
    return lessonFrom(*files);
}

}  // namespace echolucent
