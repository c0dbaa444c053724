#include <fmt/format.h>
#include <fmt/ranges.h>

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

/// What makes an OTF what it is, and what it cannot know. This is true of any simulated scan: the numbers beside it say
/// what comes of it.
std::string_view reasonOf(const std::string& name) {
    static const std::map<std::string, std::string_view> reasons{
        {parabola, "It knows nothing of the scan."},
        {"levoy", "It is opaque near the values of its contours, and clear elsewhere."},
        {"kindlmann", "It is opaque within boundaries. Speckle has boundaries too."},
        {"template",
         "Its curve was made on a simulated scan, with reduction medium. On simulated scans that is an advantage, "
         "which "
         "no scan of a clinic gives it."},
        {"contour-spectrum", "It begins at the intensity with the steepest contours."},
        {"otsu", "Its ramp lies around the threshold between dark and bright voxels."},
        {"percentile",
         "It counts voxels: 60 of 100 are clear, whatever they are. It does not know which of them are fluid."},
        {"fetal-preset", "It knows nothing of the scan: it is made for one gain."},
        {"echo-ramp", "It knows nothing of the scan: its threshold is a fixed share of white."},
    };
    const auto found = reasons.find(name);
    return found != reasons.end() ? found->second : std::string_view{};
}

constexpr double seenDifference = 1.0;  // percent; nobody sees less in a picture

/// "; 18.7 % are early": how most of those that are not right are shown. Empty if nearly all are right.
std::string mostlyMissed(const std::vector<NamedSurfaces>& rows, const std::string& name, SurfaceKind kind) {
    ShownSurface most = ShownSurface::early;
    double percent = 0.0;
    for (const ShownSurface shown : {ShownSurface::early, ShownSurface::late, ShownSurface::never})
        if (const double share = meanPercent(rows, name, kind, shown).value_or(0.0); share > percent) {
            most = shown;
            percent = share;
        }
    if (percent < seenDifference) return {};
    return fmt::format("; {:.1f} % are {}{}", percent, nameOf(most), most == ShownSurface::never ? " shown" : "");
}

/// " It is worst in hard_ramp8: 46.9 %." Empty if there are no several conditions.
std::string worstOf(const std::vector<NamedSurfaces>& rows, const std::string& name, SurfaceKind kind) {
    const auto conditions = conditionsOf(rows);
    if (conditions.size() < 2) return {};
    const auto right = [&](const std::string& condition) {
        return meanPercent(rows, name, condition, kind, ShownSurface::right).value_or(100.0);
    };
    const double least = right(*std::ranges::min_element(conditions, {}, right));
    std::vector<std::string> worst;
    for (const std::string& condition : conditions)
        if (right(condition) < least + 0.05) worst.push_back(condition);
    return fmt::format(" It is worst in {}: {:.1f} %.", fmt::join(worst, " and "), least);
}

}  // namespace

std::string labelOfCompared(const std::string& name) {
    if (name == parabola) return "x²";
    const auto designer = designerFromName(name);
    return designer ? std::string(labelOf(*designer)) : "Adaptive, " + name;  // nameOfAim()
}

std::vector<std::string> besideAdaptive(const std::vector<NamedSurfaces>& rows) {
    const auto right = [&](const std::string& name, SurfaceKind kind) {
        return meanPercent(rows, name, kind, ShownSurface::right);
    };
    // "77.3 against 93.7 % (88.7 % with an aim of 1); 11.2 % are early." The aim stands there if the other OTF is
    // better.
    const auto against = [&](const std::string& name, SurfaceKind kind, double bestAim) {
        const double own = *right(name, kind), adaptive = *right(nameOfAdaptive(), kind);
        const Percent aimed = right(nameOfAim(bestAim), kind);
        const bool better = aimed && own >= adaptive + seenDifference;
        return fmt::format("{:.1f} against {:.1f} %{}{}.", own, adaptive,
                           better ? fmt::format(" ({:.1f} % with an aim of {:g})", *aimed, bestAim) : std::string(),
                           mostlyMissed(rows, name, kind));
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
        std::string text = fmt::format("{} shows {} the adaptive OTF{}: {}", labelOfCompared(name), words,
                                       truth ? "" : ", by the tube cores' surfaces, which favour the latter",
                                       against(name, kind, 1.0));
        if (right(name, SurfaceKind::objects) && right(name, SurfaceKind::walls))
            text += " Objects: " + against(name, SurfaceKind::objects, 0.0) +
                    " Walls: " + against(name, SurfaceKind::walls, 1.0);
        if (truth) text += " " + std::string(reasonOf(name));
        text += worstOf(rows, name, kind);
        sentences.push_back(std::move(text));
    }
    return sentences;
}

}  // namespace echolucent::cli
