#include "app/explain/tube_core_overlay.h"

#include <algorithm>
#include <string>

#include "app/planes/scene_colour.h"
#include "widgets/tube_core_colours.h"

namespace echolucent {

namespace {

constexpr double stretchUnits = 8.0;                                     // before a surface
constexpr double leastRadius = 2.5, mostRadius = 4.5, rim = 1.25;        // plain pixels
constexpr double chosenRadius = 6.0, chosenWidth = 3.0, textGap = 11.0;  // plain pixels
constexpr Colour black{0, 0, 0};

void addLine(Overlay& overlay, const Vec3& from, const Vec3& to, const Colour& colour, double width) {
    overlay.spaceLines.push_back({from, to, black, width + 2.0 * rim});
    overlay.spaceLines.push_back({from, to, colour, width});
}

void addDisc(Overlay& overlay, const Vec3& at, const Colour& colour, double radius) {
    overlay.discs.push_back({at, black, radius + rim});
    overlay.discs.push_back({at, colour, radius});
}

}  // namespace

std::vector<int> tubeCoresIn3d(const TubeCoreMarks& marks, std::optional<int> chosen) {
    std::vector<int> numbers = thinned(marks, mostTubeCoresIn3d);
    if (!chosen || marks.of(*chosen) == nullptr) return numbers;
    const auto place = std::ranges::lower_bound(numbers, *chosen);
    if (place == numbers.end() || *place != *chosen) numbers.insert(place, *chosen);
    return numbers;
}

Overlay overlayOf(const TubeCoreMarks& marks, std::optional<int> chosen) {
    Overlay overlay;
    const ThemeColours& colours = coloursOverPictures();
    std::vector<const TubeCoreMark*> shown;
    for (const int number : tubeCoresIn3d(marks, chosen)) shown.push_back(marks.of(number));
    // The heavier lies over the lighter, and the chosen one over all.
    std::ranges::stable_sort(shown, {},
                             [&](const TubeCoreMark* mark) { return mark->number == chosen ? 2.0 : mark->share; });
    for (const TubeCoreMark* mark : shown) {
        const Colour colour = sceneColourOf(tubeCoreColour(mark->share, colours));
        if (mark->number == chosen) {
            const Colour white = sceneColourOf(colours.text);
            addLine(overlay, mark->beginMm, mark->endMm, white, chosenWidth);
            const Vec3 named = mark->surfaceMm.value_or(mark->beginMm);
            if (mark->surfaceMm) {
                addDisc(overlay, *mark->surfaceMm, white, chosenRadius);
                overlay.discs.push_back({*mark->surfaceMm, colour, chosenRadius - 2.0});
            }
            overlay.texts.push_back({{named}, std::to_string(mark->number), white, textGap});
            continue;
        }
        if (!mark->surfaceMm) continue;
        const double before = std::min(stretchUnits * marks.unitMm, length(*mark->surfaceMm - mark->beginMm));
        addLine(overlay, *mark->surfaceMm - marks.axes.forward * before, *mark->surfaceMm, colour,
                tubeCoreWidth(mark->share));
        addDisc(overlay, *mark->surfaceMm, colour, leastRadius + (mostRadius - leastRadius) * mark->share);
    }
    return overlay;
}

}  // namespace echolucent
