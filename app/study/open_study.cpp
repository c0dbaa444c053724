#include "app/study/open_study.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "app/study/freed_elsewhere.h"
#include "io/document/session_file.h"
#include "io/restricted/restricted_reader.h"
#include "io/study/named_study.h"
#include "io/study/simulated_study.h"

namespace echolucent {

namespace {

double millisecondsOf(const QElapsedTimer& clock) { return static_cast<double>(clock.nsecsElapsed()) * 1e-6; }

/// Qt puts U+FFFD for what is no UTF-8 in the name of a file, and nobody can find the file any more.
Result<void> requireReadableName(const std::string& path) {
    std::error_code error;
    if (path.find("\xef\xbf\xbd") == std::string::npos || std::filesystem::exists(path, error)) return {};
    return fail(FailureKind::unreadable, path, {},
                "is named in another coding than UTF-8, which the window cannot open",
                "Rename it, or use echolucent-cli.");
}

Result<void> requireNoFolder(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::is_directory(path, error)) return {};
    return fail(FailureKind::unreadable, path, {}, "is a folder, and more was dropped with it",
                "The window shows one study: drop one file or one folder, or all slices of one folder.");
}

}  // namespace

OpenStudy::OpenStudy(Works& works, QObject* parent)
    : QObject(parent),
      m_checksum(&checksumOf),
      m_quiet(works),
      m_cut(works),
      m_loader(works, QStringLiteral("study loader"), {.words = tr("loading"), .urgency = Urgency::loading}),
      m_checksumThread(works, QStringLiteral("study checksum")) {
    connect(&m_loader, &NewestWinsThread::busyChanged, this, &OpenStudy::loadingChanged);
    connect(&m_cut, &CutPhases::made, this, &OpenStudy::takeCut);
    connect(&m_cut, &CutPhases::made, this, &OpenStudy::phaseVoxelsChanged);
    connect(&m_checksumThread, &NewestWinsThread::busyChanged, this, &OpenStudy::takingChecksumChanged);
    connect(&m_cut, &CutPhases::busyChanged, this, &OpenStudy::cuttingChanged);
    connect(&m_cut, &CutPhases::failed, this, &OpenStudy::cuttingFailed);
    connect(&m_quiet, &QuietPhases::made, this, &OpenStudy::takeQuietVoxels);
    connect(&m_quiet, &QuietPhases::made, this, &OpenStudy::phaseVoxelsChanged);
    connect(&m_quiet, &QuietPhases::busyChanged, this, [this](bool busy) {
        if (busy)
            m_quieteningClock.start();
        else if (m_quiet.reduction() != SpeckleReduction::off)  // else nobody wants what that work made
            m_quieteningMilliseconds = millisecondsOf(m_quieteningClock);
    });
    connect(&m_quiet, &QuietPhases::busyChanged, this, &OpenStudy::quieteningChanged);
    connect(&m_quiet, &QuietPhases::failed, this,
            [this](int, const QString& sentence) { emit quieteningFailed(sentence); });
}

void OpenStudy::open(const QString& path, const ReadOptions& options) {
    const StudyFile file{.path = path.toStdString(), .options = options, .checksum = {}};
    load(file,
         [file, study = readerOf(file), saved = readerOfSaved(path, {})](const Progress& progress) -> Result<Opening> {
             if (auto readable = requireReadableName(file.path); !readable) return tl::unexpected(readable.error());
             return looksLikeDocument(file.path) ? saved(progress) : study(progress);
         });
}

void OpenStudy::openSlices(const QString& folder, const QStringList& slices) {
    const StudyFile file{.path = folder.toStdString(), .options = {}, .checksum = {}};
    load(file, [file, slices, study = readerOf(file)](const Progress& progress) -> Result<Opening> {
        for (const QString& slice : slices) {
            if (progress.cancelled()) return fail(FailureKind::cancelled, file.path, {}, "was not read: cancelled");
            if (auto isFile = requireNoFolder(slice.toStdString()); !isFile) return tl::unexpected(isFile.error());
        }
        return study(progress);
    });
}

StudyReader OpenStudy::readerOfSaved(const QString& file, const SavedStudyAnswer& answer) const {
    const StudySearch search = m_studySearch ? m_studySearch() : StudySearch{};
    return [file = file.toStdString(), answer, search](const Progress& progress) -> Result<Opening> {
        // A session says how its study is seen, so it opens without a coarse picture first.
        auto read = readSaved(file, answer, search, Progress{progress.report, progress.cancel});
        if (!read) return tl::unexpected(read.error());
        if (auto* problem = std::get_if<SavedStudyProblem>(&*read)) return Opening{.problem = std::move(*problem)};
        auto& session = std::get<ReadSession>(*read);
        return Opening{std::move(session.study), std::move(session.series), std::move(session.opened)};
    };
}

void OpenStudy::openSaved(const QString& file, const SavedStudyAnswer& answer, const std::optional<QString>& askedFor) {
    load(StudyFile{.path = file.toStdString(), .options = {}, .checksum = {}}, readerOfSaved(file, answer), askedFor);
}

void OpenStudy::openSeries(std::shared_ptr<const SeriesList> list, std::size_t entry, ReadOptions options) {
    options.series = list->series.at(entry).uid;
    const StudyFile file{.path = list->path, .options = options, .checksum = {}};
    load(file, [list = std::move(list), entry, options](const Progress& progress) -> Result<Opening> {
        auto study = restricted::readSeries(*list, list->series[entry], options, progress);
        if (!study) return tl::unexpected(study.error());
        return Opening{std::move(*study), list};
    });
}

namespace {

StudyReader readerOf(const SimulatedScan& scan) {
    return [scan](const Progress& progress) -> Result<Opening> {
        auto study = simulatedStudy(scan, progress);
        if (!study) return tl::unexpected(study.error());
        return Opening{std::move(*study), nullptr};
    };
}

}  // namespace

void OpenStudy::openSimulatedScan(const SimulatedScan& scan) { load(scan, readerOf(scan)); }

void OpenStudy::openSimulatedScan(const Document& document) {
    const SimulatedScan scan = std::get<SimulatedScan>(document.study);
    load(scan, readerOf(scan), std::nullopt, document);
}

QString OpenStudy::path() const {
    const auto* file = std::get_if<StudyFile>(&m_reference);
    return file ? QString::fromStdString(file->path) : QString();
}

void OpenStudy::cancelLoading() { m_loader.cancel(); }

void OpenStudy::load(const StudyReference& reference, StudyReader reader, const std::optional<QString>& asked,
                     const std::optional<Document>& given) {
    const auto* file = std::get_if<StudyFile>(&reference);
    const ReadOptions options = file ? file->options : ReadOptions{};
    const QString path = file ? QString::fromStdString(file->path) : QString();
    m_asked = asked.value_or(path);
    m_loadingClock.start();
    emit loadingBegun();
    m_loader.submit([this, reference, path, options, given, taken = m_sidesTaken ? m_sidesTaken() : SidesByKind{},
                     reader = std::move(reader)](const Progress& progress) -> NewestWinsThread::Deliver {
        Progress telling = progress;
        telling.coarse = [this](const CoarseVolume& coarse) {
            m_loader.deliverMeanwhile([this, coarse] { emit coarseVolumeRead(coarse); });
        };
        auto read = lookThrough(reader, path.toStdString(), telling, taken);
        if (progress.cancelled()) return {};
        if (!read) {
            return [this, path, options, failure = read.error()] {
                if (failure.kind != FailureKind::cancelled) emit openFailed(path, failure, options);
            };
        }
        Opening& opening = read->opening;
        if (opening.problem) return [this, problem = *opening.problem] { emit savedStudyAsked(problem); };
        const auto series = opening.series;
        if (!opening.study) return [this, series, options] { emit seriesFound(series, options); };
        for (auto& phase : opening.study->phases) phase = freedElsewhere(std::move(phase));
        auto shared = std::make_shared<const Study>(std::move(*opening.study));
        auto saved = std::move(opening.saved);
        Kept next{
            reference, shared, series, std::move(saved), given, std::move(read->finds), std::move(read->histograms)};
        if (next.saved) next.reference = next.saved->session.document.study;
        if (auto* named = std::get_if<StudyFile>(&next.reference)) *named = asOpened(std::move(*named), *shared);
        next.phase = next.saved ? next.saved->session.document.scene.phase : 0;
        return [this, next = std::move(next)] {
            m_loadingMilliseconds = millisecondsOf(m_loadingClock);
            replaceBy(next);
        };
    });
}

void OpenStudy::replaceBy(const Kept& next) {
    emit aboutToReplace();
    m_reference = next.reference;
    m_saved = next.saved;
    m_given = next.given;
    m_study = next.study;
    m_filesRead = filesRead(*m_study, m_saved);
    m_seriesBeside = next.series;
    m_histograms = next.histograms;
    m_finds = next.finds;
    m_quiet.begin(m_study->phases);
    m_quieteningMilliseconds.reset();
    m_cut.begin(m_study->phases);
    m_alsoWanted.reset();
    m_phase = next.phase;
    m_volume = volumeOf(m_phase);
    m_beginning = true;
    emit studyReplaced();
    m_beginning = false;
    show(m_phase);
    emit studyOpened();
    takeChecksum();
}

std::shared_ptr<const OpenStudy::Kept> OpenStudy::keep() const {
    if (!m_study) return nullptr;
    return std::make_shared<const Kept>(
        Kept{m_reference, m_study, m_seriesBeside, m_saved, m_given, m_finds, m_histograms, m_phase});
}

void OpenStudy::comeBack(const Kept& kept) {
    m_loader.cancel();
    replaceBy(kept);
}

void OpenStudy::takeChecksum() {
    m_checksumThread.cancel();
    const auto* file = std::get_if<StudyFile>(&m_reference);
    if (file == nullptr || !file->checksum.empty()) return;
    m_checksumThread.submit(
        [this, take = m_checksum, study = m_study](const Progress& progress) -> NewestWinsThread::Deliver {
            // If the checksum cannot be taken, a session is saved without it.
            try {
                const auto checksum = take(study->files, progress);
                if (!checksum) return {};
                return [this, study, taken = *checksum] {
                    if (study != m_study) return;
                    m_reference = withChecksum(std::get<StudyFile>(m_reference), taken);
                    emit studyNamed();
                };
            } catch (const std::exception&) {
                return {};
            }
        });
}

void OpenStudy::setPhase(int phase) {
    if (!m_study || phase < 0 || phase >= static_cast<int>(m_study->phases.size()))
        throw std::out_of_range("OpenStudy::setPhase: no such phase");
    if (phase != m_phase) show(phase);
}

void OpenStudy::show(int phase) {
    m_phase = phase;
    m_volume = volumeOf(phase);
    wantQuietVoxels();
    m_cut.want(m_phase, std::vector(m_cut.strokes()));
    emit volumeChanged();
}

void OpenStudy::setReduction(SpeckleReduction reduction) {
    if (std::exchange(m_reduction, reduction) == reduction || !m_volume) return;
    wantQuietVoxels();
    if (reduction == SpeckleReduction::off) takeQuietVoxels(m_phase);  // the raw voxels are there already
}

std::shared_ptr<const Volume> OpenStudy::volumeOf(int phase) {
    return m_study ? m_cut.of(phase, m_study->phases[static_cast<std::size_t>(phase)]) : nullptr;
}

std::optional<int> OpenStudy::phaseOfVoxels(const Volume& volume) const {
    if (!m_study) return std::nullopt;
    const auto found =
        std::ranges::find(m_study->phases, &volume.voxels(), [](const auto& phase) { return &phase->voxels(); });
    if (found == m_study->phases.end()) return std::nullopt;
    return static_cast<int>(found - m_study->phases.begin());
}

std::shared_ptr<const Volume> OpenStudy::newestVoxelsOf(int phase) {
    const std::shared_ptr<const Volume> quiet = m_quiet.of(phase);
    return quiet ? m_cut.of(phase, quiet) : volumeOf(phase);
}

std::shared_ptr<const Volume> OpenStudy::newestVoxels() { return newestVoxelsOf(m_phase); }

void OpenStudy::alsoWant(int phase) {
    if (!m_study) return;
    phase = std::clamp(phase, 0, static_cast<int>(m_study->phases.size()) - 1);
    if (std::exchange(m_alsoWanted, phase) != phase) wantQuietVoxels();
}

void OpenStudy::setStrokes(const std::vector<ScalpelStroke>& strokes) {
    if (m_volume && strokes != m_cut.strokes()) m_cut.want(m_phase, strokes);
}

void OpenStudy::takeCut(int phase) {
    if (!isWanted(phase)) return;
    m_volume = volumeOf(m_phase);
    emit volumeCut();
}

const IntensityHistogram& OpenStudy::histogramOf(const Volume& voxels) const {
    const auto quiet = m_quiet.of(m_phase);
    const auto ofQuiet = m_quiet.histogramOf(m_phase);
    return quiet && ofQuiet && &quiet->voxels() == &voxels.voxels() ? *ofQuiet : histogram();
}

void OpenStudy::takeQuietVoxels(int phase) {
    if (isWanted(phase)) emit quietVoxelsMade();
}

}  // namespace echolucent
