// Presets as JSON files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "processing/document/preset.h"
#include "processing/result.h"

namespace echolucent {

/// The "format" of such a file.
inline constexpr std::string_view presetsFormatName = "echolucent-presets";

/// {"format": "echolucent-presets", "version": 1, "presets": [{"name": ..., "curve": ..., "curves": {...}, "method":
/// {...} or null, "look": {...}}]}: every value, numbers with all their digits. Equal presets give equal bytes.
[[nodiscard]] std::string jsonOf(const std::vector<Preset>& presets);

/// The presets of a text that jsonOf() wrote: equal ones. What is refused and what has its default is as in
/// documentFromJson(); a name that is empty or longer than longestPresetName, or stands twice, is refused too.
[[nodiscard]] Result<std::vector<Preset>> presetsFromJson(std::string_view text, const std::string& file = {});

[[nodiscard]] Result<std::vector<Preset>> readPresets(const std::string& path);
/// Writes the file whole or not at all.
[[nodiscard]] Result<void> writePresets(const std::string& path, const std::vector<Preset>& presets);

}  // namespace echolucent
