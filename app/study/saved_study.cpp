#include "app/study/saved_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "io/document/session_file.h"
#include "io/headers/raw_volume.h"
#include "io/restricted/restricted_reader.h"
#include "io/study/named_study.h"
#include "io/study/simulated_study.h"
#include "processing/document/asked_phases.h"
#include "processing/document/turned_document.h"

namespace echolucent {

namespace {

namespace fs = std::filesystem;

/// Refuses documents that the window cannot show with this number of phases.
Result<void> requireShowable(const SavedSession& session, const std::string& file, std::size_t phases) {
    const auto check = [&](const Document& document, const std::string& place) -> Result<void> {
        const int last = lastPhaseOf(document);
        if (last >= static_cast<int>(phases))
            return fail(FailureKind::unreadable, file, place + "phases",
                        fmt::format("asks for phase {}, but the study has {}", last + 1, phases),
                        "Open the study that the session was saved of.");
        return {};
    };
    if (auto shown = check(session.document, ""); !shown) return shown;
    for (std::size_t i = 0; i < session.snapshots.size(); ++i)
        if (auto shown = check(session.snapshots[i].document, fmt::format("session.snapshots[{}].document.", i));
            !shown)
            return shown;
    return {};
}

/// If the study has one phase, makes the motions those of the probe: no object moves.
void keepToPhases(SavedSession& session, std::size_t phases) {
    if (phases > 1) return;
    session.document.motion.scenario = MotionScenario::probe;
    for (Snapshot& snapshot : session.snapshots) snapshot.document.motion.scenario = MotionScenario::probe;
}

/// The document in the grid of the study as it was read, and with the name of that study.
Document ofStudy(Document document, const Study& study) {
    document = inGridOfStudy(std::move(document), study.turnedAxis, study.phases.front()->geometry());
    if (auto* file = std::get_if<StudyFile>(&document.study)) *file = asOpened(std::move(*file), study);
    return document;
}

/// The same for all documents of a session.
void nameStudy(SavedSession& session, const Study& study) {
    session.document = ofStudy(std::move(session.document), study);
    for (Snapshot& snapshot : session.snapshots) snapshot.document = ofStudy(std::move(snapshot.document), study);
}

void nameStudy(SavedSession& session, const StudyReference& study) {
    session.document.study = study;
    for (Snapshot& snapshot : session.snapshots) snapshot.document.study = study;
}

/// The study at `place`, with the series beside it.
Result<ReadSession> readPlaced(const std::string& place, const ReadOptions& options, const Progress& progress) {
    if (!restricted::holdsSeries(place)) {
        auto study = restricted::readStudy(place, options, progress);
        if (!study) return tl::unexpected(study.error());
        return ReadSession{OpenedSession(), std::move(*study)};
    }
    auto listed = restricted::listSeries(place, progress);
    if (!listed) return tl::unexpected(listed.error());
    const auto list = std::make_shared<const SeriesList>(std::move(*listed));
    const auto entry = findSeries(*list, options.series);
    if (!entry) return tl::unexpected(entry.error());
    auto study = restricted::readSeries(*list, **entry, options, progress);
    if (!study) return tl::unexpected(study.error());
    return ReadSession{OpenedSession(), std::move(*study), list->series.size() > 1 ? list : nullptr};
}

}  // namespace

Result<SavedReading> readSaved(const std::string& file, const SavedStudyAnswer& answer, StudySearch search,
                               const Progress& progress) {
    auto session = readSession(file);
    if (!session) return tl::unexpected(session.error());
    if (const auto* scan = std::get_if<SimulatedScan>(&session->document.study)) {
        if (auto shown = requireShowable(*session, file, 1); !shown) return tl::unexpected<Failure>(shown.error());
        auto study = simulatedStudy(*scan, progress);
        if (!study) return tl::unexpected(study.error());
        keepToPhases(*session, study->phases.size());
        return ReadSession{{file, std::move(*session)}, std::move(*study)};
    }
    const auto* named = std::get_if<StudyFile>(&session->document.study);
    if (named == nullptr)
        return fail(FailureKind::unreadable, file, "study", "is null: the session names no study",
                    "Open the study, and then save its session again.");
    const StudyFile saved = *named;
    const std::optional<std::string> place =
        answer.study.empty() ? placeOfStudy(saved, file, std::move(search), progress) : answer.study;
    if (progress.cancelled()) return fail(FailureKind::cancelled, {}, {}, "cancelled");
    if (!place) return SavedStudyProblem{SavedStudyProblem::Kind::missing, file, studyPathFrom(file, saved.path), {}};

    auto read = readPlaced(*place, saved.options, progress);
    if (!read) return tl::unexpected(read.error());
    const Study& study = read->study;
    const auto checksum = checksumOf(study.files, progress);
    if (!checksum) return tl::unexpected(checksum.error());
    if (const std::string change = changeOf(saved, *checksum); !change.empty() && !answer.evenChanged)
        return SavedStudyProblem{SavedStudyProblem::Kind::changed, file, *place, change};
    if (auto shown = requireShowable(*session, file, study.phases.size()); !shown)
        return tl::unexpected<Failure>(shown.error());
    StudyFile found = withChecksum(saved, *checksum);
    std::error_code error;
    const fs::path absolute = fs::absolute(*place, error).lexically_normal();
    found.path = error ? *place : absolute.string();
    nameStudy(*session, found);
    nameStudy(*session, study);
    keepToPhases(*session, study.phases.size());
    read->opened = {file, std::move(*session)};
    // Made from the value: a tl::expected that is made from one of another type leaks.
    return SavedReading(std::move(*read));
}

std::vector<KeptFiles> filesRead(const Study& study, const std::optional<OpenedSession>& saved) {
    std::vector<KeptFiles> kept;
    if (saved) kept.emplace_back(std::vector{saved->file}, OutputKind::session);
    std::vector<std::string> voxels, layouts;
    for (const std::string& file : study.files) (file.ends_with(rawLayoutEnding) ? layouts : voxels).push_back(file);
    kept.emplace_back(std::move(voxels));
    kept.emplace_back(std::move(layouts), OutputKind::rawLayout);
    return kept;
}

}  // namespace echolucent
