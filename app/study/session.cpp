#include "app/study/session.h"

#include <stdexcept>
#include <utility>

#include "processing/phantom/phantom.h"

namespace echolucent {

namespace {

Result<Study> simulated(const SimulatedScan& scan, const Progress& progress) {
    PhantomConfig config = defaultPhantom(scan.scene);
    config.size = scan.size;
    config.seed = scan.seed;
    auto volume = makePhantom(config, progress);
    if (!volume) return fail(FailureKind::cancelled, {}, {}, "cancelled");
    Study study;
    study.name = "Simulated fetal scan";
    study.phases.push_back(std::make_shared<const Volume>(std::move(*volume)));
    study.facts.push_back({"origin", "simulated by the program, no patient", "built in"});
    return study;
}

}  // namespace

Session::Session(QObject* parent)
    : QObject(parent),
      m_pipeline(&adaptOpacity),
      m_nearCutSearch(&suggestNearCut),
      m_loader(QStringLiteral("study loader")),
      m_otfThread(QStringLiteral("adaptive OTF")) {
    connect(&m_loader, &NewestWinsThread::busyChanged, this, &Session::loadingChanged);
    connect(&m_loader, &NewestWinsThread::progressed, this, &Session::loadingProgressed);
    connect(&m_otfThread, &NewestWinsThread::busyChanged, this, &Session::computingOtfChanged);
}

void Session::open(const QString& path, const ReadOptions& options) {
    const StudyFile file{.path = path.toStdString(), .series = {}, .options = options, .checksum = {}};
    load(file, [file](const Progress& progress) { return readStudy(file.path, file.options, progress); });
}

void Session::openSimulatedScan() {
    const SimulatedScan scan;
    load(scan, [scan](const Progress& progress) { return simulated(scan, progress); });
}

QString Session::path() const {
    const auto* file = std::get_if<StudyFile>(&m_reference);
    return file ? QString::fromStdString(file->path) : QString();
}

void Session::cancelLoading() { m_loader.cancel(); }

void Session::load(const StudyReference& reference, std::function<Result<Study>(const Progress&)> read) {
    const auto* file = std::get_if<StudyFile>(&reference);
    const QString path = file ? QString::fromStdString(file->path) : QString();
    m_loader.submit([this, reference, path,
                     read = std::move(read)](const Progress& progress) -> NewestWinsThread::Deliver {
        Result<Study> study = [&]() -> Result<Study> {
            try {
                return read(progress);
            } catch (const std::bad_alloc&) {
                return fail(FailureKind::unreadable, path.toStdString(), {}, "needs more memory than this machine has",
                            "Close other programs, or reduce the volume.");
            }
        }();
        if (!study) {
            return [this, path, failure = study.error()] {
                if (failure.kind != FailureKind::cancelled) emit openFailed(path, failure);
            };
        }
        // Here and not when a phase is shown: a 4D study plays its phases in the GUI thread.
        std::vector<IntensityHistogram> histograms;
        for (const auto& phase : study->phases) histograms.push_back(intensityHistogram(*phase));
        auto shared = std::make_shared<const Study>(std::move(*study));
        return [this, reference, shared, histograms = std::move(histograms)] {
            m_reference = reference;
            m_study = shared;
            m_histograms = histograms;
            show(0);
            emit studyOpened();
        };
    });
}

void Session::setPhase(int phase) {
    if (!m_study || phase < 0 || phase >= static_cast<int>(m_study->phases.size()))
        throw std::out_of_range("Session::setPhase: no such phase");
    if (phase != m_phase) show(phase);
}

void Session::show(int phase) {
    m_phase = phase;
    m_volume = m_study->phases[static_cast<std::size_t>(phase)];
    m_otf.reset();
    cancelComputing();
    emit volumeChanged();
}

void Session::requestOtf(const Viewpoint& view, const AdaptiveOtfConfig& config) {
    const OtfRequest asked{view, config};
    if (!m_volume || m_asked == asked) return;
    m_asked = asked;
    m_otfThread.submit([this, pipeline = m_pipeline, volume = m_volume, view,
                        config](const Progress& progress) -> NewestWinsThread::Deliver {
        std::optional<AdaptiveOtf> result;
        try {
            result = pipeline(*volume, view, config, progress);
        } catch (const std::bad_alloc&) {
            return [this] {
                m_asked.reset();
                emit otfFailed(tr("The adaptive OTF needs more memory than this machine has."));
            };
        }
        if (!result) return {};
        auto shared = std::make_shared<const AdaptiveOtf>(std::move(*result));
        return [this, volume, shared] {
            if (volume != m_volume) return;
            m_asked.reset();
            m_otf = shared;
            emit otfComputed();
        };
    });
}

void Session::cancelComputing() {
    m_asked.reset();
    m_otfThread.cancel();
}

void Session::requestNearCut(const Viewpoint& view, const AdaptiveOtfConfig& config) {
    if (!m_volume) return;
    m_asked.reset();
    m_otfThread.submit([this, search = m_nearCutSearch, volume = m_volume, view,
                        config](const Progress& progress) -> NewestWinsThread::Deliver {
        std::optional<NearCutSuggestion> result;
        try {
            result = search(*volume, view, config, progress);
        } catch (const std::bad_alloc&) {
            return [this] { emit otfFailed(tr("Looking for the near cut needs more memory than this machine has.")); };
        }
        if (!result) return {};
        return [this, volume, suggestion = std::move(*result)] {
            if (volume == m_volume) emit nearCutSuggested(suggestion);
        };
    });
}

}  // namespace echolucent
