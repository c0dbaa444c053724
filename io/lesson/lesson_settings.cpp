#include "io/lesson/lesson_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/document/document_paths.h"

namespace echolucent {

namespace {

using nlohmann::ordered_json;

constexpr std::size_t longestShownList = 8;

bool isShownWhole(const ordered_json& value) {
    const auto isPlain = [](const ordered_json& each) { return !each.is_structured(); };
    return !value.is_structured() || (value.is_array() && std::ranges::all_of(value, isPlain));
}

/// Whether an entry of a list has nothing here: a list replaces the whole list, and names all that an entry could have.
bool isMissing(const ordered_json& value, const std::string& path) {
    return path.find('[') != std::string::npos && (value.is_null() || value.empty());
}

void addSettings(const ordered_json& value, const std::string& path, std::vector<LessonSetting>& settings) {
    if (isMissing(value, path)) return;
    if (value.is_array() && value.size() > longestShownList)
        settings.push_back({path, fmt::format("{} entries", value.size())});
    else if (value.is_string())
        settings.push_back({path, value.get<std::string>()});
    else if (isShownWhole(value))
        settings.push_back({path, value.dump()});
    else
        for (const auto& [key, part] : value.items())
            addSettings(part,
                        value.is_array() ? fmt::format("{}[{}]", path, key) : path + (path.empty() ? "" : ".") + key,
                        settings);
}

}  // namespace

std::vector<std::vector<LessonSetting>> settingsOf(const Lesson& lesson) {
    std::vector<std::vector<LessonSetting>> settings;
    Document before = lessonGround(std::get<SimulatedScan>(lesson.begins.study));
    for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
        addSettings(ordered_json::parse(partBetween(before, documentBefore(lesson, step))), {},
                    settings.emplace_back());
        before = documentAfter(lesson, step);
    }
    return settings;
}

}  // namespace echolucent
