#include "io/document/preset_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/files/input_file.h"
#include "io/json/json_document.h"
#include "io/output/atomic_file.h"

namespace echolucent {

namespace {

using nlohmann::ordered_json;

constexpr std::size_t largestFile = std::size_t{4} << 20;
constexpr const char* remedyOfPresets = "Correct the file, or export the presets again from the program.";

Preset presetIn(JsonFields& fields) {
    Preset preset{.name = fields.text("name")};
    if (preset.name.empty() || preset.name.size() > longestPresetName)
        fields.wrong("name", "must have 1 to " + std::to_string(longestPresetName) + " bytes");
    preset.curve = fields.choice("curve", &curveKindFromName);
    preset.curves = curvesIn(fields.object("curves"));
    if (!fields.isNull("method")) {
        JsonFields method = fields.object("method");
        preset.method = methodIn(method);
    }
    JsonFields look = fields.object("look");
    preset.look = lookIn(look);
    return preset;
}

}  // namespace

std::string jsonOf(const std::vector<Preset>& presets) {
    ordered_json list = ordered_json::array();
    for (const Preset& preset : presets)
        list.push_back({{"name", preset.name},
                        {"curve", nameOf(preset.curve)},
                        {"curves", curvesJson(preset.curves)},
                        {"method", preset.method ? methodJson(*preset.method) : ordered_json()},
                        {"look", lookJson(preset.look)}});
    const ordered_json object{{"format", presetsFormatName}, {"version", 1}, {"presets", list}};
    return object.dump(2) + "\n";
}

Result<std::vector<Preset>> presetsFromJson(std::string_view text, const std::string& file) {
    const auto object = jsonObject(text, file, std::string(presetsFormatName), remedyOfPresets);
    if (!object) return tl::unexpected(object.error());
    JsonProblems problems{file, std::nullopt};
    std::vector<Preset> presets;
    for (JsonFields& fields : JsonFields(*object, {}, problems).list("presets")) {
        Preset preset = presetIn(fields);
        if (std::ranges::find(presets, preset.name, &Preset::name) != presets.end())
            fields.wrong("name", "names two presets");
        presets.push_back(std::move(preset));
    }
    if (problems.first) return problems.refused(remedyOfPresets);
    return presets;
}

Result<std::vector<Preset>> readPresets(const std::string& path) {
    const auto text = readWholeFile(path, largestFile);
    if (!text) return tl::unexpected(text.error());
    return presetsFromJson(*text, path);
}

Result<void> writePresets(const std::string& path, const std::vector<Preset>& presets) {
    const std::string text = jsonOf(presets);
    if (text.size() > largestFile)
        return fail(FailureKind::unwritable, path, "", "would be too large to be opened again",
                    "Remove presets that nobody needs, and save again.");
    return writeFileAtomically(path, text, OutputKind::presets);
}

}  // namespace echolucent
