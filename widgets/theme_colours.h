// All colours of the dark and of the light theme.
#pragma once

#include <QColor>
#include <QPalette>
#include <optional>
#include <span>
#include <string_view>

#include "processing/choice_names.h"

namespace echolucent {

/// Reading rooms are dark, and so is the default theme. Pictures are on black in both.
enum class Theme { dark, light };

inline constexpr ChoiceNames<2> themeNames{"dark", "light"};

/// "dark", "light".
[[nodiscard]] inline std::string_view nameOf(Theme theme) { return nameIn(themeNames, theme); }
[[nodiscard]] inline std::optional<Theme> themeFromName(std::string_view name) {
    return choiceNamed<Theme>(themeNames, name);
}

/// A colour with one meaning, for the ground of each theme.
struct ColourOfThemes {
    QColor dark, light;

    [[nodiscard]] const QColor& in(Theme theme) const { return theme == Theme::dark ? dark : light; }
};

/// The use of each colour of a theme. The style sheet (resources/theme.qss) knows them by the same names. The contrast
/// of texts with their ground is at least 4.5 : 1 (WCAG 2.1, 1.4.3), except on disabled controls.
struct ThemeColours {
    QColor background;       ///< behind and between panels
    QColor panel;            ///< the ground of controls and texts
    QColor head;             ///< titles of docks, heads of tables
    QColor menu;             ///< menus that are open
    QColor field;            ///< fields, lists and tables
    QColor fieldDisabled;    ///< fields that are disabled
    QColor rowAlternate;     ///< every other row of a table
    QColor plot;             ///< the ground of plots
    QColor raised;           ///< buttons
    QColor raisedDisabled;   ///< buttons that are disabled
    QColor pointedAt;        ///< buttons and menus under the pointer
    QColor pressed;          ///< buttons that are held down
    QColor line;             ///< rims, grooves of sliders
    QColor lineDisabled;     ///< rims of what is disabled
    QColor lineStrong;       ///< rims under the pointer and of menus, handles of scroll bars
    QColor lineOfTable;      ///< between the cells of a table
    QColor scrollPointedAt;  ///< handles of scroll bars under the pointer
    QColor text;             ///< texts
    QColor textBehind;       ///< texts of tabs, heads and the status line
    QColor secondary;        ///< less prominent texts, rims of check boxes
    QColor disabled;         ///< texts and marks of what is disabled
    QColor textSelected;     ///< on `accentQuiet` and `selection`
    QColor mark;             ///< arrows of controls
    QColor knob;             ///< knobs of sliders
    QColor accent;           ///< the active part
    QColor accentQuiet;      ///< rows that are selected, buttons that are checked
    QColor selection;        ///< letters that are selected
    QColor progress;         ///< the part of a bar that is done
    QColor warning;          ///< signs of warnings
    QColor error;            ///< signs of errors
    QColor onSign;           ///< the letter on the sign of a message
};

struct ThemeColourRow {
    std::string_view name;  ///< name of the member
    QColor ThemeColours::*member;
    QRgb dark, light;
};
[[nodiscard]] std::span<const ThemeColourRow> themeColourRows();

[[nodiscard]] const ThemeColours& coloursOf(Theme theme);

/// Pictures are on black in both themes, so drawings over them have the dark theme's colours.
[[nodiscard]] const ThemeColours& coloursOverPictures();

/// Painted over a picture that another is about to replace (oldPictureShade).
[[nodiscard]] QColor oldPictureShadeColour();

/// The theme of a widget, by its palette: dark if its text is light.
[[nodiscard]] Theme themeOf(const QPalette& palette);
[[nodiscard]] const ThemeColours& coloursOf(const QPalette& palette);

/// The palette of the whole program, for what the style sheet does not reach.
[[nodiscard]] QPalette paletteOf(Theme theme);

/// The colour at a share in [0,1] of the way from one colour to another, without transparency.
[[nodiscard]] QColor mixed(const QColor& from, const QColor& to, double share);

}  // namespace echolucent
