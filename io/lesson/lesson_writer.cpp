#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/document/document_paths.h"
#include "io/lesson/lesson_file.h"
#include "io/lesson/lesson_json.h"
#include "io/lesson/lesson_text.h"
#include "io/output/atomic_file.h"

namespace echolucent {

namespace {

using nlohmann::ordered_json;

ordered_json valueJson(const DocumentValue& value) {
    return std::visit(
        [](const auto& plain) -> ordered_json {
            if constexpr (std::is_same_v<std::decay_t<decltype(plain)>, std::monostate>)
                return nullptr;
            else
                return plain;
        },
        value);
}

ordered_json conditionJson(const LessonCondition& condition) {
    ordered_json value;
    switch (condition.kind) {
        case ConditionKind::all:
        case ConditionKind::any:
            value = ordered_json::array();
            for (const LessonCondition& part : condition.parts) value.push_back(conditionJson(part));
            break;
        case ConditionKind::present: value = condition.name; break;
        case ConditionKind::between:
            value = ordered_json::array({condition.name, valueJson(condition.value), condition.largest});
            break;
        default: value = ordered_json::array({condition.name, valueJson(condition.value)});
    }
    return {{std::string(nameOf(condition.kind)), value}};
}

ordered_json partJson(const Document& from, const Document& to) { return ordered_json::parse(partBetween(from, to)); }

/// Makes an empty folder of a name that nothing had before, beside the one that is to come.
std::filesystem::path newFolderBeside(const std::filesystem::path& folder, std::error_code& error) {
    namespace fs = std::filesystem;
    if (folder.has_parent_path()) fs::create_directories(folder.parent_path(), error);
    constexpr int mostTries = 1000;
    for (int i = 0; i < mostTries && !error; ++i) {
        const fs::path place(folder.string() + ".unfinished" + (i > 0 ? "-" + std::to_string(i) : ""));
        if (fs::create_directory(place, error)) return place;
    }
    if (!error) error = std::make_error_code(std::errc::file_exists);
    return {};
}

tl::unexpected<Failure> unwritable(const std::string& folder, const std::string& problem) {
    return fail(FailureKind::unwritable, folder, {}, problem);
}

}  // namespace

ordered_json lessonJson(const Lesson& lesson) {
    const auto& scan = std::get<SimulatedScan>(lesson.begins.study);
    ordered_json object{{"format", lessonFormatName},
                        {"version", 1},
                        {"minutes", lesson.minutes},
                        {"study", {{"scene", nameOf(scan.scene)}, {"size", scan.size}, {"seed", scan.seed}}},
                        {"begins", partJson(lessonGround(scan), lesson.begins)}};
    ordered_json steps = ordered_json::array();
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const LessonStep& step = lesson.steps[i];
        ordered_json entry{{"id", step.id}};
        if (!step.lookAt.empty()) entry["look_at"] = step.lookAt;
        if (step.set) entry["set"] = partJson(lesson.begins, *step.set);
        if (step.until) entry["until"] = conditionJson(*step.until);
        if (step.solved) entry["solution"] = partJson(documentBefore(lesson, i), *step.solved);
        if (step.answers > 0) entry["question"] = {{"answers", step.answers}, {"right", step.right}};
        steps.push_back(std::move(entry));
    }
    object["steps"] = std::move(steps);
    return object;
}

LessonFiles filesOf(const Lesson& lesson) {
    LessonFiles files;
    files.bytes = lesson.images;
    files.bytes[lessonFileName] = lessonJson(lesson).dump(2) + "\n";
    std::vector<std::string> ids;
    for (const LessonStep& step : lesson.steps) ids.push_back(step.id);
    for (const LessonText& text : lesson.texts) files.bytes[text.language + ".md"] = markdownOf(text, ids);
    return files;
}

Result<void> writeLesson(const std::string& folder, const Lesson& lesson) {
    if (const std::string problem = problemOf(lesson); !problem.empty()) return unwritable(folder, problem);
    const LessonFiles files = filesOf(lesson);
    const auto again = lessonFrom(files);
    if (!again) return unwritable(folder, "could not be opened again: " + again.error().sentence());
    if (*again != lesson) return unwritable(folder, "has a text or a condition that could not be read again");
    for (const auto& [name, bytes] : files.bytes)
        if (name == lessonFileName && bytes.size() > largestLessonFile)
            return unwritable(folder, "would be too large to be opened again");
    namespace fs = std::filesystem;
    std::error_code error;
    const bool isThere = fs::exists(folder, error);
    const fs::path whole = fs::path(folder).has_filename() ? fs::path(folder) : fs::path(folder).parent_path();
    // A new folder gets its name once it is whole.
    const fs::path place = isThere ? whole : newFolderBeside(whole, error);
    if (error) return unwritable(folder, "cannot be made: " + error.message());
    for (const auto& [name, bytes] : files.bytes)
        if (auto written = writeFileAtomically((place / name).string(), bytes); !written) {
            if (!isThere) fs::remove_all(place, error);
            return written;
        }
    if (isThere) return {};
    fs::rename(place, whole, error);
    if (!error) return {};
    const std::string why = error.message();
    fs::remove_all(place, error);
    return unwritable(folder, "cannot be made: " + why);
}

}  // namespace echolucent
