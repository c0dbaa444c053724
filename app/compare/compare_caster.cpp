#include "app/compare/compare_caster.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <optional>
#include <utility>

#include "app/picture/picture_image.h"
#include "processing/ray_caster.h"

namespace echolucent {

namespace {

constexpr double frameMilliseconds = 40.0;  // from one frame to the next while the hand moves

bool ofSameVolumes(const CompareRequest& one, const CompareRequest& other) {
    return std::ranges::equal(one.panes, other.panes, {}, &PaneRequest::volume, &PaneRequest::volume);
}

double millisecondsSince(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

/// The ray casters of the panes, and what each has cast last. Lives in the casting thread.
class CompareCaster::Casters {
public:
    struct Cast {
        std::vector<PanePicture> panes;
        bool allSampled = true;          ///< no pane was there already, or made of kept samples
        double lightMilliseconds = 0.0;  ///< of all panes
    };

    /// Nothing where it was cancelled.
    std::optional<Cast> cast(const CompareRequest& request, const Progress& progress) {
        prepare(request);
        Cast made;
        for (std::size_t i = 0; i < m_panes.size(); ++i) {
            Pane& pane = m_panes[i];
            const PaneRequest& asked = request.panes[i];
            if (pane.shown && *pane.shown == asked && pane.settings == request.settings) {
                made.allSampled = false;
                made.panes.push_back(pane.picture);
                continue;
            }
            const auto begin = std::chrono::steady_clock::now();
            pane.shown.reset();
            const auto picture =
                pane.caster->cast(asked.classification, request.settings, Progress{{}, progress.cancel});
            if (!picture) return std::nullopt;
            made.lightMilliseconds += pane.caster->lightMilliseconds();
            pane.picture = {imageOf(*picture), millisecondsSince(begin), pane.caster->sampleUse() != SampleUse::kept};
            made.allSampled = made.allSampled && pane.picture.sampled;
            pane.shown = asked;
            pane.settings = request.settings;
            made.panes.push_back(pane.picture);
        }
        return made;
    }

    void clear() { m_panes.clear(); }

private:
    struct Pane {
        std::optional<RayCaster> caster;
        std::optional<PaneRequest> shown;  ///< what `picture` is of
        RayCastSettings settings;
        PanePicture picture;
    };

    /// Every pane gets a caster of its volume; those of one scan share its packed voxels.
    void prepare(const CompareRequest& request) {
        m_panes.resize(request.panes.size());
        for (std::size_t i = 0; i < m_panes.size(); ++i) {
            Pane& pane = m_panes[i];
            const auto& volume = request.panes[i].volume;
            if (pane.caster && !volume->isSameScanAs(*pane.caster->volume())) pane = Pane{};
        }
        for (std::size_t i = 0; i < m_panes.size(); ++i) {
            Pane& pane = m_panes[i];
            const auto& volume = request.panes[i].volume;
            for (std::size_t k = 0; k < m_panes.size() && !pane.caster; ++k)
                if (m_panes[k].caster && volume->isSameScanAs(*m_panes[k].caster->volume()))
                    pane.caster.emplace(m_panes[k].caster->sharing());
            if (!pane.caster) pane.caster.emplace(volume);
            if (pane.caster->volume() != volume) pane.caster->setCut(volume);
        }
    }

    std::vector<Pane> m_panes;
};

CompareCaster::CompareCaster(QObject* parent)
    : QObject(parent),
      m_casters(std::make_shared<Casters>()),
      m_quality(frameMilliseconds),
      m_thread("comparison caster") {
    connect(&m_thread, &NewestWinsThread::busyChanged, this, &CompareCaster::busyChanged);
    m_rest.setSingleShot(true);
    connect(&m_rest, &QTimer::timeout, this, &CompareCaster::refine);
}

CompareCaster::~CompareCaster() = default;

void CompareCaster::request(const CompareRequest& request) {
    if (m_newest && *m_newest == request) return;
    m_inStream = m_sinceRequest.isValid() && m_sinceRequest.elapsed() < streamMilliseconds;
    m_sinceRequest.start();
    m_rest.stop();
    // Pictures of other voxels than these are no step of this movement.
    if (m_newest && !ofSameVolumes(*m_newest, request)) m_thread.cancel();
    const std::size_t quality =
        m_inStream ? m_quality.qualityInMotion(request.settings) : m_quality.qualityAlone(request.settings);
    m_newest = std::make_shared<const CompareRequest>(request);
    m_newestIsThere = false;
    start(quality, NewestWinsThread::WhenSuperseded::finish);
}

void CompareCaster::clear() {
    if (!m_newest) return;
    m_newest.reset();
    m_rest.stop();
    m_sinceRequest.invalidate();
    m_thread.cancel();
    m_thread.submit(
        [casters = m_casters](const Progress&) -> NewestWinsThread::Deliver {
            casters->clear();
            return {};
        },
        NewestWinsThread::WhenSuperseded::finish);
    emit busyChanged();
}

void CompareCaster::refine() {
    m_inStream = false;
    if (m_startedQuality == convergedQuality) return;
    start(nextAtRest(m_startedQuality), NewestWinsThread::WhenSuperseded::cancel);
}

void CompareCaster::start(std::size_t quality, NewestWinsThread::WhenSuperseded whenSuperseded) {
    m_startedQuality = quality;
    const bool followsHand = whenSuperseded == NewestWinsThread::WhenSuperseded::finish;
    auto make = [this, quality, followsHand, casters = m_casters,
                 asked = m_newest](const Progress& progress) -> NewestWinsThread::Deliver {
        const auto begin = std::chrono::steady_clock::now();
        const CompareRequest atQuality{asked->panes, settingsAt(quality, asked->settings), asked->places};
        auto cast = casters->cast(atQuality, progress);
        if (!cast) return {};
        auto frame = std::make_shared<const CompareFrame>(
            CompareFrame{*asked, quality, atQuality.settings, std::move(cast->panes), millisecondsSince(begin)});
        const Lesson lesson{cast->allSampled, cast->lightMilliseconds, followsHand};
        return [this, frame, lesson] { deliver(frame, lesson); };
    };
    auto job = [this, casters = m_casters, make](const Progress& progress) -> NewestWinsThread::Deliver {
        try {
            return make(progress);
        } catch (const std::bad_alloc&) {
            casters->clear();  // a caster that was interrupted is not used again
            return [this] { emit failed(); };
        }
    };
    m_thread.submit(std::move(job), whenSuperseded);
}

void CompareCaster::deliver(const std::shared_ptr<const CompareFrame>& frame, const Lesson& lesson) {
    if (lesson.allSampled) {
        if (lesson.followsHand) m_quality.lit(frame->settings, lesson.lightMilliseconds);
        m_quality.sampled(frame->settings, frame->milliseconds - lesson.lightMilliseconds);
    }
    if (!m_newest) return;
    const bool newest = *m_newest == frame->request;
    if (newest) m_newestIsThere = true;
    if (newest && !frame->converged()) m_inStream ? m_rest.start(restMilliseconds) : refine();
    // A frame of other panes than those that are there now is not shown.
    if (newest || frame->request.places == m_newest->places) emit delivered(frame);
}

}  // namespace echolucent
