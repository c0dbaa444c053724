#include "widgets/theme_colours.h"

#include <array>
#include <cmath>

#include "processing/picture/annotation_layout.h"

namespace echolucent {

namespace {

constexpr std::array themeRows{
    ThemeColourRow{"background", &ThemeColours::background, 0x14171a, 0xd3d9df},
    ThemeColourRow{"panel", &ThemeColours::panel, 0x1e2226, 0xf1f3f5},
    ThemeColourRow{"head", &ThemeColours::head, 0x262b30, 0xe4e8ec},
    ThemeColourRow{"menu", &ThemeColours::menu, 0x23282d, 0xfbfcfd},
    ThemeColourRow{"field", &ThemeColours::field, 0x14171a, 0xffffff},
    ThemeColourRow{"fieldDisabled", &ThemeColours::fieldDisabled, 0x1b1f22, 0xeceff2},
    ThemeColourRow{"rowAlternate", &ThemeColours::rowAlternate, 0x181c1f, 0xf6f8f9},
    ThemeColourRow{"plot", &ThemeColours::plot, 0x15181b, 0xffffff},
    ThemeColourRow{"raised", &ThemeColours::raised, 0x2a2f35, 0xe3e7eb},
    ThemeColourRow{"raisedDisabled", &ThemeColours::raisedDisabled, 0x22272b, 0xeceff2},
    ThemeColourRow{"pointedAt", &ThemeColours::pointedAt, 0x343a41, 0xd5dbe1},
    ThemeColourRow{"pressed", &ThemeColours::pressed, 0x14171a, 0xc3cad1},
    ThemeColourRow{"line", &ThemeColours::line, 0x3d444c, 0xb4bdc6},
    ThemeColourRow{"lineDisabled", &ThemeColours::lineDisabled, 0x2c3238, 0xd8dde3},
    ThemeColourRow{"lineStrong", &ThemeColours::lineStrong, 0x4c545d, 0x8f9aa5},
    ThemeColourRow{"lineOfTable", &ThemeColours::lineOfTable, 0x2a2f35, 0xdde2e6},
    ThemeColourRow{"scrollPointedAt", &ThemeColours::scrollPointedAt, 0x6b747d, 0x6b747d},
    ThemeColourRow{"text", &ThemeColours::text, 0xd8dde2, 0x1b2126},
    ThemeColourRow{"textBehind", &ThemeColours::textBehind, 0xaeb6be, 0x434d57},
    ThemeColourRow{"secondary", &ThemeColours::secondary, 0x8b949e, 0x505a65},
    ThemeColourRow{"disabled", &ThemeColours::disabled, 0x6b747d, 0x8d97a1},
    ThemeColourRow{"textSelected", &ThemeColours::textSelected, 0xffffff, 0x0b0f12},
    ThemeColourRow{"mark", &ThemeColours::mark, 0xb4bcc4, 0x47515b},
    ThemeColourRow{"knob", &ThemeColours::knob, 0xd8dde2, 0x47515b},
    ThemeColourRow{"accent", &ThemeColours::accent, 0x4fb3bf, 0x1c7f8c},
    ThemeColourRow{"accentQuiet", &ThemeColours::accentQuiet, 0x24474d, 0xc9e4e8},
    ThemeColourRow{"selection", &ThemeColours::selection, 0x2f6f78, 0x9fd3da},
    ThemeColourRow{"progress", &ThemeColours::progress, 0x2a656e, 0x9fd3da},
    ThemeColourRow{"warning", &ThemeColours::warning, 0xe8b04b, 0x966400},
    ThemeColourRow{"error", &ThemeColours::error, 0xe07a72, 0xb83f4b},
    ThemeColourRow{"onSign", &ThemeColours::onSign, 0x000000, 0xffffff},
};

ThemeColours madeOf(Theme theme) {
    ThemeColours colours;
    for (const ThemeColourRow& row : themeRows)
        colours.*row.member = QColor(theme == Theme::dark ? row.dark : row.light);
    return colours;
}

}  // namespace

std::span<const ThemeColourRow> themeColourRows() { return themeRows; }

const ThemeColours& coloursOf(Theme theme) {
    static const ThemeColours dark = madeOf(Theme::dark), light = madeOf(Theme::light);
    return theme == Theme::dark ? dark : light;
}

const ThemeColours& coloursOverPictures() { return coloursOf(Theme::dark); }

QColor oldPictureShadeColour() { return QColor::fromRgbF(0, 0, 0, static_cast<float>(oldPictureShade)); }

Theme themeOf(const QPalette& palette) {
    // Ask neither for the background, which some controls lack, nor for disabled text, which is pale in both themes.
    return palette.color(QPalette::Active, QPalette::WindowText).lightness() < 128 ? Theme::light : Theme::dark;
}

const ThemeColours& coloursOf(const QPalette& palette) { return coloursOf(themeOf(palette)); }

QPalette paletteOf(Theme theme) {
    const ThemeColours& colours = coloursOf(theme);
    QPalette palette(colours.raised, colours.panel);
    const std::pair<QPalette::ColorRole, QColor> roles[] = {{QPalette::WindowText, colours.text},
                                                            {QPalette::Text, colours.text},
                                                            {QPalette::ButtonText, colours.text},
                                                            {QPalette::BrightText, colours.textSelected},
                                                            {QPalette::Base, colours.field},
                                                            {QPalette::AlternateBase, colours.rowAlternate},
                                                            {QPalette::ToolTipBase, colours.raised},
                                                            {QPalette::ToolTipText, colours.text},
                                                            {QPalette::PlaceholderText, colours.secondary},
                                                            {QPalette::Highlight, colours.selection},
                                                            {QPalette::HighlightedText, colours.textSelected},
                                                            {QPalette::Link, colours.text},
                                                            {QPalette::LinkVisited, colours.text}};
    for (const auto& [role, colour] : roles) palette.setColor(role, colour);
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, colours.disabled);
    return palette;
}

QColor mixed(const QColor& from, const QColor& to, double share) {
    const auto channel = [share](int a, int b) { return static_cast<int>(std::lround(a + share * (b - a))); };
    return {channel(from.red(), to.red()), channel(from.green(), to.green()), channel(from.blue(), to.blue())};
}

}  // namespace echolucent
