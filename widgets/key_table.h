// Every key and gesture of the window: one table for the menus, the panel Explain and docs/keys.md.
#pragma once

#include <QKeySequence>
#include <QString>
#include <array>
#include <vector>

namespace echolucent {

/// Where a key or gesture works. The focused part is asked first, then the window.
enum class KeyPlace { picture, planes, curveEditor, window };
inline constexpr std::array allKeyPlaces{KeyPlace::picture, KeyPlace::planes, KeyPlace::curveEditor, KeyPlace::window};

/// The key of an action of the window. `action` is the action's object name.
struct KeyOfAction {
    QString action;
    QString key;  ///< as QKeySequence's portable text: "Ctrl+Shift+Z"
};

/// One line of the table: keys or gestures that belong together, and what they do.
struct KeyRow {
    KeyPlace place;
    QString keys;     ///< as people read them
    QString meaning;  ///< of the keys, in their order
    std::vector<KeyOfAction> actions{};
};

/// All rows, those of one place together.
[[nodiscard]] const std::vector<KeyRow>& keyTable();

/// "In the picture", "In a plane", "In the curve editor", "Anywhere in the window".
[[nodiscard]] QString titleOf(KeyPlace place);

/// The key of the action with this object name; an empty one if no row names the action.
[[nodiscard]] QKeySequence keyOf(const QString& action);

/// The whole page docs/keys.md as Markdown: a heading and a table for each place, in the order of allKeyPlaces.
[[nodiscard]] QString keysPage();

}  // namespace echolucent
