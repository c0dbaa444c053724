#include "widgets/otf_editor/node_reduction.h"

#include <QCoreApplication>
#include <cmath>
#include <stdexcept>

#include "widgets/otf_editor/otf_editor_state.h"

namespace echolucent {

namespace {

/// The sample between `first` and `last` farthest from their chord, along the opacity axis.
struct Farthest {
    std::size_t index = 0;
    double distance = 0.0;
};

Farthest farthestFromChord(const std::vector<double>& values, std::size_t first, std::size_t last) {
    Farthest farthest{first, 0.0};
    for (std::size_t i = first + 1; i < last; ++i) {
        const double share = static_cast<double>(i - first) / static_cast<double>(last - first);
        const double distance = std::abs(values[i] - (values[first] + share * (values[last] - values[first])));
        if (distance > farthest.distance) farthest = {i, distance};
    }
    return farthest;
}

/// Appends the samples to keep in (first, last], ascending.
void keepBetween(const std::vector<double>& values, std::size_t first, std::size_t last, double maxError,
                 std::vector<std::size_t>& kept) {
    const Farthest farthest = farthestFromChord(values, first, last);
    if (farthest.distance > maxError) {
        keepBetween(values, first, farthest.index, maxError, kept);
        keepBetween(values, farthest.index, last, maxError, kept);
    } else {
        kept.push_back(last);
    }
}

std::vector<CurvePreset> makePresets() {
    const auto translated = [](const char* text) { return QCoreApplication::translate("CurvePreset", text); };
    const ManualCurve parabola = reducedToNodes({sampledOpacities(PowerCurve{2, 1.0}, 256)}, copiedCurveMaxError);
    return {{"fetal", translated("Fetal (60, 120, 255)"), OtfEditorState{}.manual},
            {"parabolic", translated("x² as nodes"), parabola},
            {"ramp", translated("Ramp"), ManualCurve{{{0.0, 0.0}, {1.0, 1.0}}}}};
}

}  // namespace

ManualCurve reducedToNodes(const SampledCurve& curve, double maxError) {
    if (!(maxError > 0.0)) throw std::invalid_argument("reducedToNodes: the bound must be positive");
    const std::vector<double>& values = curve.opacities;
    if (values.empty()) return ManualCurve{{{0.0, 0.0}}};
    if (values.size() == 1) return ManualCurve{{{0.0, values.front()}}};
    std::vector<std::size_t> kept{0};
    keepBetween(values, 0, values.size() - 1, maxError, kept);
    ManualCurve reduced;
    for (const std::size_t i : kept)
        reduced.nodes.push_back({static_cast<double>(i) / static_cast<double>(values.size() - 1), values[i]});
    return reduced;
}

const std::vector<CurvePreset>& curvePresets() {
    static const std::vector<CurvePreset> presets = makePresets();
    return presets;
}

}  // namespace echolucent
