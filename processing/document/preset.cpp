#include "processing/document/preset.h"

#include <algorithm>
#include <utility>

namespace echolucent {

namespace {

void takeCurve(CurveSet& curves, const CurveSet& from, CurveKind kind) {
    switch (kind) {
        case CurveKind::adaptive: return;
        case CurveKind::manual: curves.manual = from.manual; return;
        case CurveKind::linear: curves.linear = from.linear; return;
        case CurveKind::parabolic: curves.parabolic = from.parabolic; return;
        case CurveKind::quartic: curves.quartic = from.quartic; return;
    }
}

/// The curve of the document that the method begins with. If the method begins with a power of its own, this is the
/// adaptive curve, which takeCurve() leaves alone.
CurveKind initialCurveOf(const MethodChoice& method) {
    if (method.initial == InitialKind::linear) return CurveKind::linear;
    return method.initial == InitialKind::manual ? CurveKind::manual : CurveKind::adaptive;
}

/// As many whole characters of a UTF-8 text as fit into `bytes`.
std::string shortened(std::string text, std::size_t bytes) {
    if (text.size() <= bytes) return text;
    const auto continues = [&text](std::size_t at) { return (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U; };
    while (bytes > 0 && continues(bytes)) --bytes;
    text.resize(bytes);
    return text;
}

std::string trimmed(const std::string& text) {
    constexpr auto space = " \t\r\n";
    const std::size_t first = text.find_first_not_of(space);
    return first == std::string::npos ? std::string() : text.substr(first, text.find_last_not_of(space) - first + 1);
}

}  // namespace

Preset presetOf(const Document& document, std::size_t pane, std::string name) {
    Preset preset{.name = std::move(name), .curve = document.panes.at(pane).curve, .look = document.scene.look};
    takeCurve(preset.curves, curvesOf(document, pane), preset.curve);
    preset.curves.adjustment = document.curves.adjustment;
    if (preset.curve == CurveKind::adaptive) {
        preset.method = document.method;
        preset.method->config.grid.withoutTubes.clear();
        takeCurve(preset.curves, document.curves, initialCurveOf(*preset.method));
    }
    preset.look.step = Look{}.step;
    return preset;
}

Document withPreset(Document document, std::size_t pane, const Preset& preset) {
    Look& look = document.scene.look;
    look = [&preset, step = look.step] {
        Look taken = preset.look;
        taken.step = step;
        return taken;
    }();
    if (look.mode != RenderMode::direct) return document;
    document = withCurve(std::move(document), pane, preset.curve);
    document.panes.at(pane).linear.reset();
    takeCurve(document.curves, preset.curves, preset.curve);
    document.curves.adjustment = preset.curves.adjustment;
    if (preset.curve != CurveKind::adaptive || !preset.method) return document;
    const MethodChoice before = std::exchange(document.method, *preset.method);
    const TubeGrid& grid = before.config.grid;
    TubeGrid& taken = document.method.config.grid;
    taken.withoutTubes =
        taken.columns == grid.columns && taken.rows == grid.rows ? grid.withoutTubes : std::vector<int>{};
    takeCurve(document.curves, preset.curves, initialCurveOf(*preset.method));
    return document;
}

bool isMadeBy(const Document& document, std::size_t pane, const Preset& preset) {
    // Compares only the parts that a preset touches, so that nothing large is copied.
    Document parts;
    parts.scene.look = document.scene.look;
    parts.panes.front().curve = document.panes.at(pane).curve;
    if (const DesignerConfig* config = designerConfigOf(document, pane))
        parts = withDesigner(parts, firstPane, *config);
    parts.curves = curvesOf(document, pane);
    parts.method = document.method;
    return withPreset(parts, firstPane, preset) == parts;
}

std::string freePresetName(std::string name, const std::vector<std::string>& taken) {
    name = trimmed(shortened(trimmed(name), longestPresetName));
    if (name.empty()) name = "Preset";
    const auto isTaken = [&taken](const std::string& each) { return std::ranges::find(taken, each) != taken.end(); };
    std::string numbered = name;
    for (int number = 2; isTaken(numbered); ++number) {
        const std::string suffix = " (" + std::to_string(number) + ")";
        numbered = trimmed(shortened(name, longestPresetName - suffix.size())) + suffix;
    }
    return numbered;
}

}  // namespace echolucent
