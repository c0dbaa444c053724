#include "processing/pane_picture/pane_measures.h"

#include <map>
#include <utility>

namespace echolucent {

std::string_view surfacesSentence(SurfacesFrom from) {
    switch (from) {
        case SurfacesFrom::truth: return "Surfaces are the true ones of the simulated scan.";
        case SurfacesFrom::tubeCores: break;
    }
    return "Nobody knows the true surfaces. Those that tube cores find in this view stand in for them, which favours "
           "the adaptive OTF.";
}

SurfaceSource surfaceSourceOf(const Document& document) {
    SurfaceSource source{viewpointOf(document), {}};
    const auto* simulated = std::get_if<SimulatedScan>(&document.study);
    if (simulated != nullptr && document.scene.strokes.empty()) source.known = *simulated;
    return source;
}

std::optional<MeasuredSurfaces> measuredSurfacesOf(const SurfaceSource& source, const Volume& raw,
                                                   const Progress& progress) {
    if (source.known) {
        PhantomConfig config = defaultPhantom(source.known->scene);
        config.size = source.known->size;
        config.seed = source.known->seed;
        MeasuredSurfaces known{SurfacesFrom::truth,
                               trueSurfaces(raw.geometry(), PhantomTruth(config), source.view,
                                            InterfaceInto::objectOrTissue, measuredRaySpacing, progress),
                               {measuredRaySpacing, measuredRaySpacing}};
        return progress.cancelled() ? std::nullopt : std::optional(std::move(known));
    }
    auto found = spacedSurfaces(raw, source.view, progress);
    if (!found) return std::nullopt;
    return MeasuredSurfaces{SurfacesFrom::tubeCores, std::move(found->rays), found->apartUnits};
}

std::optional<std::vector<std::optional<PaneMeasures>>> measuresOfPanes(const Document& document, StudyPhases phases,
                                                                        const Progress& progress) {
    std::vector<std::optional<PaneMeasures>> measured(document.panes.size());
    PaneCaster caster(std::move(phases));
    const Progress silent{{}, progress.cancel};
    std::map<int, std::vector<std::size_t>> places;  // by phase
    for (std::size_t place = 0; place < document.panes.size(); ++place)
        places[phaseOf(document, place)].push_back(place);
    std::size_t done = 0;
    for (const auto& [phase, ofPhase] : places) {
        std::vector<Classification> classifications;
        for (const std::size_t place : ofPhase) {
            const auto otf = caster.otf(document, place, silent);
            if (!otf) return std::nullopt;
            classifications.push_back(classificationOf(document, place, *otf));
        }
        const auto voxels = caster.phaseVoxels(document, phase, silent);
        if (!voxels) return std::nullopt;
        const auto surfaces = measuredSurfacesOf(surfaceSourceOf(document), *voxels->raw, silent);
        if (!surfaces) return std::nullopt;
        const auto measures =
            measuresOf(*voxels->shown, viewpointOf(document), surfaces->rays, classifications, silent);
        if (!measures) return std::nullopt;
        for (std::size_t i = 0; i < ofPhase.size() && !surfaces->rays.empty(); ++i)
            measured[ofPhase[i]] = PaneMeasures{surfaces->from, (*measures)[i]};
        progress.at(static_cast<double>(++done) / static_cast<double>(places.size()));
    }
    return measured;
}

}  // namespace echolucent
