#include "app/study/study_loading.h"

#include <algorithm>
#include <filesystem>
#include <new>
#include <utility>
#include <variant>

#include "io/restricted/restricted_reader.h"
#include "processing/volume/coarse_grid.h"

namespace echolucent {

StudyReader readerOf(const StudyFile& file) {
    return [file](const Progress& progress) -> Result<Opening> {
        if (!restricted::holdsSeries(file.path) || !file.options.series.empty()) {
            auto study = restricted::readStudy(file.path, file.options, progress);
            if (!study) return tl::unexpected(study.error());
            return Opening{std::move(*study), nullptr};
        }
        auto listed = restricted::listSeries(file.path, progress);
        if (!listed) return tl::unexpected(listed.error());
        const auto list = std::make_shared<const SeriesList>(std::move(*listed));
        const auto isVolume = [](const SeriesEntry& entry) { return !entry.whyNot; };
        const auto volumes = std::count_if(list->series.begin(), list->series.end(), isVolume);
        // A person who opens the folder means its single volume among pictures and cines.
        const bool clear = volumes == 1 || list->series.size() == 1;
        if (!clear) return Opening{std::nullopt, list};
        auto chosen = std::find_if(list->series.begin(), list->series.end(), isVolume);
        if (chosen == list->series.end()) chosen = list->series.begin();
        auto study = restricted::readSeries(*list, *chosen, file.options, progress);
        if (study) return Opening{std::move(*study), list->series.size() > 1 ? list : nullptr};
        if (list->series.size() == 1 || study.error().kind == FailureKind::cancelled)
            return tl::unexpected(study.error());
        // The other series can still be chosen, beside the reason why this one does not open.
        SeriesList told = *list;
        told.series[static_cast<std::size_t>(chosen - list->series.begin())].whyNot = study.error();
        return Opening{std::nullopt, std::make_shared<const SeriesList>(std::move(told))};
    };
}

std::string kindOfScan(const Study& study) {
    std::string kind;
    for (const char* name : {"format", "manufacturer", "model"}) {
        const auto fact = std::ranges::find(study.facts, name, &ImportFact::name);
        if (fact == study.facts.end() || fact->value.empty()) continue;
        kind += (kind.empty() ? "" : " / ") + fact->value;
    }
    return kind;
}

Result<LookedThrough> lookThrough(const StudyReader& read, const std::string& path, const Progress& progress,
                                  const SidesByKind& taken) {
    try {
        bool isCoarseTold = false;
        const auto tellCoarse = [&](const CoarseVolume& coarse) {
            isCoarseTold = true;
            if (progress.coarse) progress.coarse(coarse);
        };
        Progress telling = progress;
        if (taken.empty()) telling.coarse = tellCoarse;
        auto opening = read(telling);
        if (!opening) return tl::unexpected(opening.error());
        LookedThrough looked{std::move(*opening)};
        if (!looked.opening.study) return looked;
        const auto& phases = looked.opening.study->phases;
        const auto& saved = looked.opening.saved;
        const auto kind = taken.find(kindOfScan(*looked.opening.study));
        if (!isCoarseTold && !saved && kind == taken.end())
            if (const auto coarse = coarseVolumeOf(*phases.front())) tellCoarse(*coarse);
        // Make the histograms here and not when a phase is shown: a 4D study plays its phases in the GUI thread.
        for (const auto& phase : phases) looked.histograms.push_back(intensityHistogram(*phase));
        const bool simulated = saved && std::holds_alternative<SimulatedScan>(saved->session.document.study);
        if (path.empty() || simulated) return looked;
        SaidOnOpening said;
        if (kind != taken.end()) said.sideOfKind = kind->second;
        looked.finds = findOnOpening(*phases.front(), {nullptr, progress.cancel}, said);
        return looked;
    } catch (const std::bad_alloc&) {
        return fail(FailureKind::unreadable, path, {}, "needs more memory than this machine has",
                    "Close other programs, or reduce the volume.");
    } catch (const std::filesystem::filesystem_error& problem) {
        return fail(FailureKind::unreadable, path, {}, "could not be read: " + problem.code().message());
    }
}

}  // namespace echolucent
