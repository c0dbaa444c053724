#include "app/study/open_study.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "app/study/freed_elsewhere.h"
#include "io/document/session_file.h"
#include "io/restricted/restricted_reader.h"
#include "io/study/simulated_study.h"

namespace echolucent {

namespace {

double millisecondsOf(const QElapsedTimer& clock) { return static_cast<double>(clock.nsecsElapsed()) * 1e-6; }

}  // namespace

OpenStudy::OpenStudy(QObject* parent)
    : QObject(parent),
      m_pipeline(&adaptOpacity),
      m_nearCutSearch(&findNearCut),
      m_checksum(&checksumOf),
      m_loader(QStringLiteral("study loader")),
      m_checksumThread(QStringLiteral("study checksum")),
      m_otfThread(QStringLiteral("adaptive OTF")) {
    connect(&m_loader, &NewestWinsThread::busyChanged, this, &OpenStudy::loadingChanged);
    connect(&m_loader, &NewestWinsThread::progressed, this, &OpenStudy::loadingProgressed);
    connect(&m_otfThread, &NewestWinsThread::busyChanged, this, &OpenStudy::computingOtfChanged);
    connect(&m_cut, &CutPhases::made, this, &OpenStudy::takeCut);
    connect(&m_cut, &CutPhases::made, this, &OpenStudy::phaseVoxelsChanged);
    connect(&m_checksumThread, &NewestWinsThread::busyChanged, this, &OpenStudy::takingChecksumChanged);
    connect(&m_cut, &CutPhases::busyChanged, this, [this] {
        // Strokes that cut nothing tell of no cut.
        if (m_waiting && !waitsForVoxels()) requestWaitingOtf();
        emit computingOtfChanged(computingOtf());
    });
    connect(&m_cut, &CutPhases::failed, this, &OpenStudy::otfFailed);
    connect(&m_quiet, &QuietPhases::made, this, &OpenStudy::takeQuietVoxels);
    connect(&m_quiet, &QuietPhases::made, this, &OpenStudy::phaseVoxelsChanged);
    connect(&m_quiet, &QuietPhases::busyChanged, this, [this](bool busy) {
        if (busy)
            m_quieteningClock.start();
        else if (m_quiet.reduction() != SpeckleReduction::off)  // else what ended was of the study before
            m_quieteningMilliseconds = millisecondsOf(m_quieteningClock);
    });
    connect(&m_quiet, &QuietPhases::busyChanged, this, &OpenStudy::quieteningChanged);
    connect(&m_quiet, &QuietPhases::progressed, this, &OpenStudy::quieteningProgressed);
    connect(&m_quiet, &QuietPhases::failed, this, [this](int, const QString& sentence) {
        emit quieteningFailed(sentence);
        requestWaitingOtf();
    });
}

void OpenStudy::open(const QString& path, const ReadOptions& options) {
    const StudyFile file{.path = path.toStdString(), .options = options, .checksum = {}};
    load(file, [file, study = readerOf(file), saved = readerOfSaved(path, {})](const Progress& progress) {
        return looksLikeDocument(file.path) ? saved(progress) : study(progress);
    });
}

StudyReader OpenStudy::readerOfSaved(const QString& file, const SavedStudyAnswer& answer) const {
    const StudySearch search = m_studySearch ? m_studySearch() : StudySearch{};
    return [file = file.toStdString(), answer, search](const Progress& progress) -> Result<Opening> {
        // A session says how its study is seen, so that it opens without a picture from elsewhere.
        auto read = readSaved(file, answer, search, Progress{progress.report, progress.cancel});
        if (!read) return tl::unexpected(read.error());
        if (auto* problem = std::get_if<SavedStudyProblem>(&*read)) return Opening{.problem = std::move(*problem)};
        auto& session = std::get<ReadSession>(*read);
        return Opening{std::move(session.study), std::move(session.series), std::move(session.opened)};
    };
}

void OpenStudy::openSaved(const QString& file, const SavedStudyAnswer& answer) {
    load(StudyFile{.path = file.toStdString(), .options = {}, .checksum = {}}, readerOfSaved(file, answer));
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

void OpenStudy::openSimulatedScan() {
    const SimulatedScan scan;
    load(scan, [scan](const Progress& progress) -> Result<Opening> {
        auto study = simulatedStudy(scan, progress);
        if (!study) return tl::unexpected(study.error());
        return Opening{std::move(*study), nullptr};
    });
}

QString OpenStudy::path() const {
    const auto* file = std::get_if<StudyFile>(&m_reference);
    return file ? QString::fromStdString(file->path) : QString();
}

void OpenStudy::cancelLoading() { m_loader.cancel(); }

void OpenStudy::load(const StudyReference& reference, StudyReader reader) {
    const auto* file = std::get_if<StudyFile>(&reference);
    const ReadOptions options = file ? file->options : ReadOptions{};
    const QString path = file ? QString::fromStdString(file->path) : QString();
    m_loadingClock.start();
    emit loadingBegun();
    m_loader.submit([this, reference, path, options,
                     reader = std::move(reader)](const Progress& progress) -> NewestWinsThread::Deliver {
        Progress telling = progress;
        telling.coarse = [this](const CoarseVolume& coarse) {
            m_loader.deliverMeanwhile([this, coarse] { emit coarseVolumeRead(coarse); });
        };
        auto read = lookThrough(reader, path.toStdString(), telling);
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
        return [this, reference, shared, series, saved = std::move(saved), finds = std::move(read->finds),
                histograms = std::move(read->histograms)] {
            m_loadingMilliseconds = millisecondsOf(m_loadingClock);
            m_reference = saved ? saved->session.document.study : reference;
            m_saved = saved;
            m_study = shared;
            m_filesRead = filesRead(*m_study, m_saved);
            m_seriesBeside = series;
            m_histograms = histograms;
            m_finds = finds;
            m_kept.clear();
            m_quiet.begin(m_study->phases);
            m_quieteningMilliseconds.reset();
            m_cut.begin(m_study->phases);
            m_opening = true;
            m_otfPhase.reset();
            m_waitForQuiet = true;
            show(m_saved ? m_saved->session.document.scene.phase : 0);
            emit studyOpened();
            takeChecksum();
        };
    });
}

void OpenStudy::takeChecksum() {
    m_checksumThread.cancel();
    const auto* file = std::get_if<StudyFile>(&m_reference);
    if (file == nullptr || !file->checksum.empty()) return;
    m_checksumThread.submit(
        [this, take = m_checksum, study = m_study](const Progress& progress) -> NewestWinsThread::Deliver {
            // A session is saved without it.
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
    // One phase's OTF serves all, but what a search took the place of is asked for again.
    if (!m_otfPhase || lookingForNearCut()) {
        m_otf.reset();
        m_voxelsOfOtf.reset();
        cancelComputing();
    }
    wantQuietVoxels();
    m_cut.want(m_phase, std::vector(m_cut.strokes()));
    emit volumeChanged();
}

void OpenStudy::setReduction(SpeckleReduction reduction) {
    if (std::exchange(m_reduction, reduction) == reduction || !m_volume) return;
    wantQuietVoxels();
    if (reduction == SpeckleReduction::off) takeQuietVoxels(m_phase);  // they are there already
}

void OpenStudy::cancelQuietening() {
    m_quiet.cancel();
    requestWaitingOtf();
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

std::shared_ptr<const Volume> OpenStudy::voxelsForOtf() {
    return m_voxelsOfOtf && phaseOfOtf() == m_phase ? m_voxelsOfOtf : newestVoxels();
}

bool OpenStudy::otfIsOfNewestVoxels() { return m_otf && m_voxelsOfOtf == newestVoxelsOf(phaseOfOtf()); }

void OpenStudy::setOtfPhase(std::optional<int> phase) {
    if (!m_study) return;
    if (phase) phase = std::clamp(*phase, 0, static_cast<int>(m_study->phases.size()) - 1);
    if (std::exchange(m_otfPhase, phase) != phase) wantQuietVoxels();
}

void OpenStudy::setStrokes(const std::vector<ScalpelStroke>& strokes) {
    if (m_volume && strokes != m_cut.strokes()) m_cut.want(m_phase, strokes);
}

/// What was asked of the volume is asked of the one that is cut.
void OpenStudy::takeCut(int phase) {
    if (phase != m_phase && phase != phaseOfOtf()) return;
    const auto pending = m_asked ? m_asked : m_waiting;
    const bool searching = lookingForNearCut() && phase == m_phase;
    m_volume = volumeOf(m_phase);
    if (searching) requestNearCut(m_searchedAlong);
    if (pending) requestOtf(pending->view, pending->config);
    emit volumeCut();
}

const IntensityHistogram& OpenStudy::histogramOfOtf() const {
    const auto ofOtf = m_quiet.of(phaseOfOtf());
    const auto quiet = m_quiet.histogramOf(m_phase);
    return quiet && ofOtf && m_voxelsOfOtf && &m_voxelsOfOtf->voxels() == &ofOtf->voxels() ? *quiet : histogram();
}

void OpenStudy::takeQuietVoxels(int phase) {
    if (phase != m_phase && phase != phaseOfOtf()) return;
    if (phase == phaseOfOtf()) requestWaitingOtf();
    emit quietVoxelsMade();
}

bool OpenStudy::waitsForVoxels() {
    if (!m_opening) return false;
    return !m_cut.isCurrent(phaseOfOtf()) ||
           (m_waitForQuiet && !m_quiet.of(phaseOfOtf()) && m_volume->geometry().voxelCount() <= quietFirstVoxels);
}

void OpenStudy::requestWaitingOtf() {
    m_waitForQuiet = false;
    if (m_volume && waitsForVoxels()) return;
    m_opening = false;  // nothing waits from here on
    if (const auto waiting = std::exchange(m_waiting, std::nullopt)) requestOtf(waiting->view, waiting->config);
}

void OpenStudy::requestOtf(const Viewpoint& view, const AdaptiveOtfConfig& config) {
    const OtfRequest asked{volumeOf(phaseOfOtf()), newestVoxelsOf(phaseOfOtf()), view, config};
    if (!m_volume || m_asked == asked) return;
    if (waitsForVoxels()) {
        m_waiting = asked;
        return;
    }
    m_waiting.reset();
    m_asked = asked;
    m_searching = false;
    if (auto kept = m_kept.find(asked)) {
        m_otfThread.cancel();
        // Delivered as one that was computed would be: after the request has returned, and not where another was made.
        QMetaObject::invokeMethod(
            this,
            [this, asked, otf = std::move(kept)] {
                if (m_asked == asked) takeOtf(asked, otf);
                emit computingOtfChanged(computingOtf());
            },
            Qt::QueuedConnection);
        emit computingOtfChanged(true);
        return;
    }
    m_otfThread.submit([this, pipeline = m_pipeline, asked,
                        reduction = m_reduction](const Progress& progress) -> NewestWinsThread::Deliver {
        std::optional<AdaptiveOtf> result;
        try {
            const QuietVoxels shown =
                asked.voxels == asked.volume ? QuietVoxels{} : QuietVoxels{asked.voxels.get(), reduction};
            result = pipeline(*asked.volume, asked.view, asked.config, progress, shown);
        } catch (const std::bad_alloc&) {
            return [this] {
                m_asked.reset();
                emit otfFailed(tr("The adaptive OTF needs more memory than this machine has."));
            };
        }
        if (!result) return [this] { m_asked.reset(); };  // never of a run that was cancelled
        auto shared = std::make_shared<const AdaptiveOtf>(std::move(*result));
        return [this, asked, shared] {
            m_kept.keep(asked, shared);
            if (m_asked == asked) takeOtf(asked, shared);
        };
    });
}

void OpenStudy::takeOtf(const OtfRequest& asked, std::shared_ptr<const AdaptiveOtf> otf) {
    m_asked.reset();
    m_opening = false;
    m_otf = std::move(otf);
    m_voxelsOfOtf = asked.voxels;
    emit otfComputed();
}

void OpenStudy::cancelComputing() {
    m_searching = false;
    m_asked.reset();
    m_waiting.reset();
    m_otfThread.cancel();
}

void OpenStudy::requestNearCut(const Viewpoint& view) {
    if (!m_volume) return;
    m_asked.reset();
    m_waiting.reset();  // whoever asks for the near cut asks for the OTF afterwards
    m_opening = false;
    m_searching = true;
    m_searchedAlong = view;
    m_otfThread.submit([this, search = m_nearCutSearch, volume = m_volume,
                        view](const Progress& progress) -> NewestWinsThread::Deliver {
        std::optional<NearCutFinding> result;
        try {
            result = search(*volume, view, progress);
        } catch (const std::bad_alloc&) {
            return [this] { emit otfFailed(tr("Looking for the near cut needs more memory than this machine has.")); };
        }
        if (!result) return {};
        return [this, volume, finding = std::move(*result)] {
            if (volume == m_volume) emit nearCutFound(finding);
        };
    });
}

}  // namespace echolucent
