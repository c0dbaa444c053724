// Recipes for pictures of any volume, by name: curve, look and mode together.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "processing/document/document.h"

namespace echolucent {

/// What a person gives a name to. From `curves` only the rendered kind counts, with the adjustment, and the curve that
/// `method` begins with. From the look all counts except the step, which the qualities of the 3D view choose.
struct Preset {
    std::string name;  ///< UTF-8, for people
    CurveKind curve = CurveKind::adaptive;
    CurveSet curves{};
    /// How the adaptive curve is computed. No value: a document keeps its own method. The list of tube cores that are
    /// never placed is empty, because they belong to one volume.
    std::optional<MethodChoice> method{};
    Look look = lookAtStart();
    friend bool operator==(const Preset&, const Preset&) = default;
};

/// The most bytes that a preset's name may have.
inline constexpr std::size_t longestPresetName = 60;

/// How a pane's picture is made. If the pane has a designer, the preset holds the pane's curve instead.
[[nodiscard]] Preset presetOf(const Document& document, std::size_t pane, std::string name);

/// The document whose pane is made as a preset says. In the mode direct the pane loses its designer. What such a
/// picture does not use stays: the other curves; every curve and the designer, in another mode than direct; the method,
/// if the curve is not the adaptive one. The method's list of tube cores that are never placed stays if the grid keeps
/// its columns and rows. Else the list is emptied.
[[nodiscard]] Document withPreset(Document document, std::size_t pane, const Preset& preset);

/// Whether withPreset() would change nothing in a pane's picture.
[[nodiscard]] bool isMadeBy(const Document& document, std::size_t pane, const Preset& preset);

/// The presets that the program comes with. The first has the look and the curve that the program starts with.
[[nodiscard]] std::span<const Preset> standardPresets();

/// The name without white space around it, shortened to longestPresetName at a character's end. If nothing is left,
/// "Preset". If `taken` holds this name already, a number follows ("Skin (2)").
[[nodiscard]] std::string freePresetName(std::string name, const std::vector<std::string>& taken);

}  // namespace echolucent
