// How a picture is made of any volume, by name: the curve, the look and the mode together.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "processing/document/document.h"

namespace echolucent {

/// What a person gives a name to. Of `curves` only the curve of the kind that is rendered counts, with the adjustment;
/// of the look all but the step, which the qualities of the 3D view choose.
struct Preset {
    std::string name;  ///< UTF-8, for people
    CurveKind curve = CurveKind::adaptive;
    CurveSet curves{};
    /// How the adaptive curve is computed; nothing where a document keeps its own method. The tube cores that are never
    /// placed belong to a volume: they play no part, and there are none.
    std::optional<MethodChoice> method{};
    Look look = lookAtStart();
    friend bool operator==(const Preset&, const Preset&) = default;
};

/// The most bytes that a preset's name may have.
inline constexpr std::size_t longestPresetName = 60;

/// How a pane's picture is made now.
[[nodiscard]] Preset presetOf(const Document& document, std::size_t pane, std::string name);

/// The document whose pane is made as a preset says. What plays no part in such a picture stays as it was: the other
/// curves; in another mode than direct every curve; the method where the curve is not the adaptive one. The tube cores
/// that are never placed stay where the grid has the columns and rows that it had; else none is left out.
[[nodiscard]] Document withPreset(Document document, std::size_t pane, const Preset& preset);

/// Whether a pane's picture is made as a preset says: whether withPreset() would change nothing.
[[nodiscard]] bool isMadeBy(const Document& document, std::size_t pane, const Preset& preset);

/// What the program comes with; the first is the look and the curve that the program starts with.
[[nodiscard]] std::span<const Preset> standardPresets();

/// The name without the white space around it, shortened to longestPresetName at a character's end, and numbered
/// ("Skin (2)") where one of `taken` has it already; "Preset" where nothing is left of it.
[[nodiscard]] std::string freePresetName(std::string name, const std::vector<std::string>& taken);

}  // namespace echolucent
