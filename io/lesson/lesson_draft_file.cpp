#include "io/lesson/lesson_draft_file.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/document/document_paths.h"
#include "io/files/input_file.h"
#include "io/json/json_fields.h"
#include "io/lesson/lesson_file.h"
#include "io/lesson/lesson_json.h"
#include "io/output/atomic_file.h"

namespace echolucent {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* draftFormatName = "echolucent-lesson-draft";
constexpr const char* remedyOfDraft = "Begin the lesson anew.";

std::string pathIn(const std::string& folder, const std::string& name) {
    return (std::filesystem::path(folder) / name).string();
}

ordered_json draftTextJson(const LessonText& text) {
    ordered_json steps = ordered_json::array();
    for (const LessonStepText& step : text.steps)
        steps.push_back({{"title", step.title},
                         {"text", step.text},
                         {"hint", step.hint},
                         {"question", step.question},
                         {"answers", step.answers},
                         {"explanation", step.explanation}});
    return {{"language", text.language}, {"title", text.title}, {"summary", text.summary}, {"steps", steps}};
}

/// Reads draft.json. What is missing or of another kind throws json::exception; what breaks a rule of documents throws
/// Failure.
class DraftReader {
public:
    explicit DraftReader(const json& root) : m_root(root) {}

    LessonDraft read() {
        const json& object = m_root.at("lesson");
        LessonDraft draft;
        draft.folder = m_root.at("folder").get<std::string>();
        Lesson& lesson = draft.lesson;
        lesson.minutes = object.at("minutes").get<int>();
        const json& study = object.at("study");
        const auto scene = phantomSceneFromName(study.at("scene").get<std::string>());
        if (!scene) throw Failure{FailureKind::unreadable, {}, "study.scene", "names no scene", {}};
        lesson.begins = part(lessonGround({*scene, study.at("size").get<std::array<std::int64_t, 3>>(),
                                           study.at("seed").get<std::uint64_t>()}),
                             object.at("begins"));
        for (const json& step : object.at("steps")) addStep(lesson, step);
        for (const json& text : m_root.at("texts")) lesson.texts.push_back(textIn(text, lesson.steps));
        draft.step = m_root.at("step").get<std::size_t>();
        draft.language = m_root.at("language").get<std::size_t>();
        if (lesson.texts.empty() || draft.language >= lesson.texts.size() ||
            (draft.step > 0 && draft.step >= lesson.steps.size()))
            throw Failure{FailureKind::unreadable, {}, "step", "is none of the lesson", {}};
        return draft;
    }

private:
    static Document part(const Document& ground, const json& object) {
        auto read = withPart(ground, object.dump());
        if (!read) throw read.error();
        return std::move(*read);
    }
    static LessonCondition conditionIn(const json& object, int depth = 1) {
        const std::string kindName = object.is_object() && object.size() == 1 ? object.begin().key() : std::string();
        const auto kind = conditionKindFromName(kindName);
        if (!kind || depth > deepestCondition)
            throw Failure{FailureKind::unreadable, {}, "until", "is no condition", {}};
        LessonCondition condition{*kind};
        const json& value = object.at(kindName);
        if (*kind == ConditionKind::all || *kind == ConditionKind::any) {
            for (const json& part : value) condition.parts.push_back(conditionIn(part, depth + 1));
            return condition;
        }
        if (*kind == ConditionKind::present) {
            condition.name = value.get<std::string>();
            return condition;
        }
        condition.name = value.at(0).get<std::string>();
        if (!takeValue(value.at(1), condition.value))
            throw Failure{FailureKind::unreadable, {}, "until", "compares with no value", {}};
        if (*kind == ConditionKind::between) condition.largest = value.at(2).get<double>();
        return condition;
    }
    static void addStep(Lesson& lesson, const json& object) {
        const Document before = lesson.steps.empty() ? lesson.begins : documentAfter(lesson, lesson.steps.size() - 1);
        LessonStep step{.id = object.at("id").get<std::string>()};
        step.lookAt = object.value("look_at", "");
        if (object.contains("set")) step.set = part(lesson.begins, object["set"]);
        if (object.contains("until")) step.until = conditionIn(object["until"]);
        if (object.contains("solution")) step.solved = part(step.set ? *step.set : before, object["solution"]);
        if (object.contains("question")) {
            step.answers = object["question"].at("answers").get<std::size_t>();
            step.right = object["question"].at("right").get<std::size_t>();
        }
        lesson.steps.push_back(std::move(step));
    }
    static LessonText textIn(const json& object, const std::vector<LessonStep>& steps) {
        LessonText text{object.at("language").get<std::string>(), object.at("title").get<std::string>(),
                        object.at("summary").get<std::string>()};
        for (const json& each : object.at("steps"))
            text.steps.push_back({each.at("title").get<std::string>(), each.at("text").get<std::string>(),
                                  each.at("hint").get<std::string>(), each.at("question").get<std::string>(),
                                  each.at("answers").get<std::vector<std::string>>(),
                                  each.at("explanation").get<std::string>()});
        const auto fits = [&](const LessonStepText& words) {
            return words.answers.size() == steps[static_cast<std::size_t>(&words - text.steps.data())].answers;
        };
        if (text.steps.size() != steps.size() || !std::ranges::all_of(text.steps, fits))
            throw Failure{FailureKind::unreadable, {}, "texts", "do not fit the steps", {}};
        return text;
    }

    const json& m_root;
};

}  // namespace

Result<void> writeLessonDraft(const std::string& folder, const LessonDraft& draft) {
    ordered_json object{{"format", draftFormatName},
                        {"version", 1},
                        {"folder", draft.folder},
                        {"language", draft.language},
                        {"step", draft.step},
                        {"lesson", lessonJson(draft.lesson)},
                        {"texts", ordered_json::array()},
                        {"images", ordered_json::array()}};
    for (const LessonText& text : draft.lesson.texts) object["texts"].push_back(draftTextJson(text));
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) return fail(FailureKind::unwritable, folder, {}, "cannot be made: " + error.message());
    for (const auto& [name, bytes] : draft.lesson.images) {
        object["images"].push_back(name);
        if (std::filesystem::exists(pathIn(folder, name), error)) continue;  // images are never edited
        if (auto written = writeFileAtomically(pathIn(folder, name), bytes); !written) return written;
    }
    // A byte that is no UTF-8 becomes a sign that says so: what was typed around it stays.
    return writeFileAtomically(pathIn(folder, lessonDraftFileName),
                               object.dump(1, ' ', false, ordered_json::error_handler_t::replace));
}

Result<LessonDraft> readLessonDraft(const std::string& folder) {
    const std::string file = pathIn(folder, lessonDraftFileName);
    const auto refuse = [&](const std::string& problem) {
        return fail(FailureKind::unreadable, file, {}, problem, remedyOfDraft);
    };
    const auto bytes = readWholeFile(file, mostLessonBytes);
    if (!bytes) return tl::unexpected(bytes.error());
    const auto root = jsonObject(*bytes, file, draftFormatName, remedyOfDraft);
    if (!root) return tl::unexpected(root.error());
    try {
        LessonDraft draft = DraftReader(*root).read();
        const auto files = lessonFilesIn(folder);
        if (!files) return tl::unexpected(files.error());
        for (const json& name : root->at("images"))
            if (const auto image = files->bytes.find(name.get<std::string>()); image != files->bytes.end())
                draft.lesson.images.insert(*image);
        return draft;
    } catch (const json::exception&) {
        return refuse("is damaged");
    } catch (const Failure& failure) {
        return refuse("is damaged: " + failure.element + " " + failure.problem);
    }
}

}  // namespace echolucent
