#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "app/measuring/designers/study_designers.h"
#include "app/measuring/study_output.h"
#include "app/measuring/study_phantoms.h"
#include "processing/designers/adaptive_design.h"

namespace echolucent::cli {

namespace {

using Percent = std::optional<double>;

const std::string parabola = "x2";

std::string nameOfAdaptive() { return std::string(echolucent::nameOf(designerOf(AdaptiveConfig{}))); }

/// What an OTF does to surfaces, and what it cannot know. The docs of the designers hold the figures.
std::string_view reasonOf(const std::string& name) {
    static const std::map<std::string, std::string_view> reasons{
        {parabola,
         "It knows nothing of the scan: haze stands before bright surfaces, and dark ones are washed through."},
        {"levoy",
         "It is opaque near one value, so it stands at walls. The blurred edge of a bright object passes this value "
         "before the surface."},
        {"kindlmann",
         "It is opaque within boundaries. Speckle has boundaries too, and they hold light back before the surface."},
        {"template",
         "Its curve was made on a simulated scan with the echoes, the speckle and the reduction of these scans. "
         "On them it has an advantage that no scan of a clinic gives it."},
        {"contour-spectrum",
         "It begins at the intensity with the steepest contours. In strong speckle these are no surfaces."},
        {"otsu",
         "Its ramp lies around the threshold between dark and bright voxels, so it stands at walls. The blurred edge "
         "of a bright object passes the threshold before the surface."},
        {"percentile",
         "It counts voxels: 60 of 100 are clear, whatever they are. If fewer than 60 of 100 are fluid, it is clear in "
         "tissue too, and walls are washed through. If more are, it is opaque in fluid."},
        {"fetal-preset",
         "It knows nothing of the scan. If the gain suits it, bright objects are right. The fluid of a compressed scan "
         "is opaque to it, and a dim scan is clear."},
        {"echo-ramp",
         "It knows nothing of the scan. Its threshold is low: if the gain suits it, walls are right, and objects are "
         "early. The fluid of a compressed scan lies above the threshold."},
    };
    const auto found = reasons.find(name);
    return found != reasons.end() ? found->second : std::string_view{};
}

constexpr double seenDifference = 1.0;  // percent; nobody sees less in a picture

/// " Its worst scans are hard_ramp8: 46.9 %." Empty if there are no several conditions.
std::string worstOf(const std::vector<NamedSurfaces>& rows, const std::string& name, SurfaceKind kind) {
    const auto conditions = conditionsOf(rows);
    if (conditions.size() < 2) return {};
    const auto right = [&](const std::string& condition) {
        return meanPercent(rows, name, condition, kind, ShownSurface::right).value_or(100.0);
    };
    const std::string worst = *std::ranges::min_element(conditions, {}, right);
    return fmt::format(" Its worst scans are {}: {:.1f} %.", worst, right(worst));
}

}  // namespace

std::string labelOfCompared(const std::string& name) {
    if (name == parabola) return "x²";
    const auto designer = designerFromName(name);
    return designer ? std::string(labelOf(*designer)) : "Adaptive, " + name;
}

std::vector<std::string> besideAdaptive(const std::vector<NamedSurfaces>& rows) {
    const auto right = [&](const std::string& name, SurfaceKind kind) {
        return meanPercent(rows, name, kind, ShownSurface::right);
    };
    // "77.3 against 93.7 %", with the end of the aim that shows most of these if the other OTF is better.
    const auto against = [&](const std::string& name, SurfaceKind kind, double bestAim) {
        const double own = *right(name, kind), adaptive = *right(nameOfAdaptive(), kind);
        const Percent aimed = right(nameOfAim(bestAim), kind);
        const bool better = aimed && own >= adaptive + seenDifference;
        return fmt::format("{:.1f} against {:.1f} %{}.", own, adaptive,
                           better ? fmt::format(" ({:.1f} % with an aim of {:g})", *aimed, bestAim) : std::string());
    };
    const bool truth = std::ranges::any_of(rows, [](const NamedSurfaces& row) { return bool(row.surfaces.truth); });
    const SurfaceKind kind = truth ? SurfaceKind::all : SurfaceKind::tubeCores;
    std::vector<std::string> sentences;
    for (const std::string& name : namesIn(rows, [](const NamedSurfaces& row) { return row.name; })) {
        const Percent own = right(name, kind), adaptive = right(nameOfAdaptive(), kind);
        if (reasonOf(name).empty() || !own || !adaptive) continue;
        const char* words = std::abs(*own - *adaptive) < seenDifference ? "as many surfaces right as"
                            : *own > *adaptive                          ? "more surfaces right than"
                                                                        : "fewer surfaces right than";
        std::string text =
            fmt::format("{} shows {} the adaptive OTF: {}", labelOfCompared(name), words, against(name, kind, 1.0));
        if (right(name, SurfaceKind::objects) && right(name, SurfaceKind::walls))
            text += " Objects: " + against(name, SurfaceKind::objects, 0.0) +
                    " Walls: " + against(name, SurfaceKind::walls, 1.0);
        text += " " + std::string(reasonOf(name)) + worstOf(rows, name, kind);
        sentences.push_back(std::move(text));
    }
    return sentences;
}

}  // namespace echolucent::cli
