// Presets as JSON files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "processing/document/preset.h"
#include "processing/result.h"

namespace echolucent {

/// The "format" of a preset file.
inline constexpr std::string_view presetsFormatName = "echolucent-presets";

/// {"format": "echolucent-presets", "version": 1, "presets": [{"name": ..., "curve": ..., "curves": {...}, "method":
/// {...} or null, "look": {...}}]}, with every value, and numbers with all their digits. Equal presets give equal
/// bytes. Throws nlohmann::json::exception if a name is not UTF-8.
[[nodiscard]] std::string jsonOf(const std::vector<Preset>& presets);

/// The presets that jsonOf() wrote as a text. Refusals and defaults are as in documentFromJson(). A name that is empty,
/// longer than longestPresetName or used twice is refused too.
[[nodiscard]] Result<std::vector<Preset>> presetsFromJson(std::string_view text, const std::string& file = {});

[[nodiscard]] Result<std::vector<Preset>> readPresets(const std::string& path);
/// Writes the file whole or not at all. Fails (unwritable) if the file cannot be written. Throws as jsonOf().
[[nodiscard]] Result<void> writePresets(const std::string& path, const std::vector<Preset>& presets);

}  // namespace echolucent
