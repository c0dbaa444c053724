#include "app/measuring/shown_surfaces.h"

#include <fmt/format.h>

#include <utility>

#include "app/measuring/measures/rank_correlation.h"
#include "app/measuring/study_phantoms.h"

namespace echolucent::cli {

namespace {

/// The words above a group of columns.
std::string wordsOf(SurfaceKind kind) {
    switch (kind) {
        case SurfaceKind::objects: return "objects";
        case SurfaceKind::walls: return "walls";
        case SurfaceKind::all: return "all";
        case SurfaceKind::tubeCores: return "tube cores";
    }
    return {};
}

std::string percentText(const std::optional<double>& percent) {
    return percent ? fmt::format("{:.1f}", *percent) : "-";
}

std::vector<std::string> namesOf(const std::vector<NamedSurfaces>& rows) {
    return namesIn(rows, [](const NamedSurfaces& row) { return row.name; });
}

}  // namespace

ShownDepth ShownSurfaces::ByTruth::all() const {
    ShownDepth both = objects;
    return both += walls;
}

std::vector<ShownSurfaces> shownSurfacesOf(const Volume& raw, const Volume& shown, const Viewpoint& view,
                                           const PhantomTruth* truth, std::span<const Classification> classifications) {
    std::vector<ShownSurfaces> all(classifications.size());
    const auto found = *measuresOf(shown, view, *foundSurfaces(raw, view), classifications);
    for (std::size_t i = 0; i < all.size(); ++i) all[i].tubeCores = found[i];
    if (truth == nullptr) return all;
    const auto measuresInto = [&](InterfaceInto into) {
        return *measuresOf(shown, view, trueSurfaces(raw.geometry(), *truth, view, into), classifications);
    };
    const auto objects = measuresInto(InterfaceInto::object), walls = measuresInto(InterfaceInto::tissue);
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i].truth = {objects[i].depth, walls[i].depth, objects[i].contrast.contrastToNoise()};
    return all;
}

std::string nameOf(SurfaceKind kind) { return kind == SurfaceKind::tubeCores ? "tube_cores" : wordsOf(kind); }

std::string nameOf(ShownSurface shown) {
    switch (shown) {
        case ShownSurface::right: return "right";
        case ShownSurface::early: return "early";
        case ShownSurface::late: return "late";
        case ShownSurface::never: return "never";
    }
    return {};
}

std::optional<double> percentOf(const ShownSurfaces& one, SurfaceKind kind, ShownSurface shown) {
    const auto percent = [&](const ShownDepth& depth) {
        const auto share = depth.share(shown);
        return share ? std::optional(100.0 * *share) : std::nullopt;
    };
    if (kind == SurfaceKind::tubeCores) return percent(one.tubeCores.depth);
    if (!one.truth) return std::nullopt;
    if (kind == SurfaceKind::all) return percent(one.truth->all());
    return percent(kind == SurfaceKind::objects ? one.truth->objects : one.truth->walls);
}

std::vector<std::string> conditionsOf(const std::vector<NamedSurfaces>& rows) {
    return namesIn(rows, [](const NamedSurfaces& row) { return row.condition; });
}

std::optional<double> meanPercent(const std::vector<NamedSurfaces>& rows, const std::string& name,
                                  const std::string& condition, SurfaceKind kind, ShownSurface shown) {
    std::vector<std::optional<double>> values;
    for (const NamedSurfaces& row : rows)
        if (row.name == name && row.condition == condition) values.push_back(percentOf(row.surfaces, kind, shown));
    return meanOf(values);
}
std::optional<double> meanPercent(const std::vector<NamedSurfaces>& rows, const std::string& name, SurfaceKind kind,
                                  ShownSurface shown) {
    std::vector<std::optional<double>> means;
    for (const std::string& condition : conditionsOf(rows))
        means.push_back(meanPercent(rows, name, condition, kind, shown));
    return meanOf(means);
}

std::vector<std::string> shownSurfaceColumns() {
    std::vector<std::string> columns;
    for (const SurfaceKind kind : allSurfaceKinds)
        for (const ShownSurface shown : allShownSurfaces)
            columns.push_back(nameOf(shown) + "_" + nameOf(kind) + "_percent");
    return columns;
}

std::vector<CsvCell> shownSurfaceCells(const ShownSurfaces& one) {
    std::vector<CsvCell> cells;
    for (const SurfaceKind kind : allSurfaceKinds)
        for (const ShownSurface shown : allShownSurfaces) cells.emplace_back(percentOf(one, kind, shown));
    return cells;
}

TextTable shownSurfaceTable(const std::vector<NamedSurfaces>& rows) {
    TextTable table{{"shown depth, %"}, {}};
    std::vector<std::pair<SurfaceKind, ShownSurface>> columns;
    for (const SurfaceKind kind : allSurfaceKinds)
        for (const ShownSurface shown : allShownSurfaces) {
            bool known = false;
            for (const NamedSurfaces& row : rows) known = known || percentOf(row.surfaces, kind, shown);
            if (!known) continue;
            columns.emplace_back(kind, shown);
            table.columns.push_back(shown == ShownSurface::right ? wordsOf(kind) + ": right" : nameOf(shown));
        }
    for (const std::string& name : namesOf(rows)) {
        std::vector<std::string> cells{name};
        for (const auto& [kind, shown] : columns) cells.push_back(percentText(meanPercent(rows, name, kind, shown)));
        table.rows.push_back(std::move(cells));
    }
    return table;
}

TextTable rightTable(const std::vector<NamedSurfaces>& rows, SurfaceKind kind) {
    TextTable table{{kind == SurfaceKind::tubeCores ? "right by tube cores, %" : "right by the truth, %"}, {}};
    const auto conditions = conditionsOf(rows);
    table.columns.insert(table.columns.end(), conditions.begin(), conditions.end());
    table.columns.emplace_back("mean");
    for (const std::string& name : namesOf(rows)) {
        std::vector<std::string> cells{name};
        for (const std::string& condition : conditions)
            cells.push_back(percentText(meanPercent(rows, name, condition, kind, ShownSurface::right)));
        cells.push_back(percentText(meanPercent(rows, name, kind, ShownSurface::right)));
        table.rows.push_back(std::move(cells));
    }
    return table;
}

std::string rankSentence(const std::vector<NamedSurfaces>& rows) {
    std::vector<double> truth, tubeCores;
    for (const std::string& name : namesOf(rows)) {
        const auto one = meanPercent(rows, name, SurfaceKind::all, ShownSurface::right);
        const auto other = meanPercent(rows, name, SurfaceKind::tubeCores, ShownSurface::right);
        if (!one || !other) continue;
        truth.push_back(*one);
        tubeCores.push_back(*other);
    }
    const auto correlation = rankCorrelation(truth, tubeCores);
    if (!correlation) return {};
    return fmt::format(
        "Rank correlation (Spearman) of what is right by the truth, all surfaces, and by the tube cores' surfaces, "
        "over "
        "the means of {} OTFs: {:.2f}.",
        truth.size(), *correlation);
}

}  // namespace echolucent::cli
