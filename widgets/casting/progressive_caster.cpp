#include "widgets/casting/progressive_caster.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <utility>

#include "widgets/casting/kept_frames.h"

namespace echolucent {

namespace {
constexpr int editRestMilliseconds = 150;  // longer than restMilliseconds: a hand that shapes a curve halts more often
constexpr int passedFrames = 2;            // of a motion, before one is cast in high quality; so the motion goes on
}  // namespace

ProgressiveCaster::ProgressiveCaster(Works& works, const PreviewQuality& quality, Cast cast, Cast cardCast)
    : m_cast(std::move(cast)),
      m_cardCast(std::move(cardCast)),
      m_quality(quality),
      m_frames(std::make_unique<KeptFrames>()),
      m_waits(works, {}),
      m_thread(works, "ray caster") {
    m_rest.setSingleShot(true);
    connect(&m_rest, &QTimer::timeout, this, [this] {
        refine();
        m_waits.end();
    });
}

ProgressiveCaster::~ProgressiveCaster() = default;

void ProgressiveCaster::setPlaying(bool playing) {
    if (std::exchange(m_playing, playing) == playing) return;
    m_passed = passedFrames;  // the first frame is kept at once
    if (!playing && m_newest && !busy() && m_startedQuality != convergedQuality) refine();
}

int ProgressiveCaster::keptFrames() const { return m_frames->count(); }

std::size_t ProgressiveCaster::keptFrameBytes() const { return m_frames->bytes(); }

/// Delivers a kept frame after the request has returned, as if it had been cast. False if no motion plays or no such
/// frame is kept.
bool ProgressiveCaster::deliverKept(const PictureRequest& request) {
    const auto frame = m_playing ? m_frames->find(request) : nullptr;
    if (!frame) return false;
    m_newest = std::make_shared<const PictureRequest>(request);
    m_startedQuality = frame->quality;
    if (!frame->converged()) waitForRest(editRestMilliseconds);
    QMetaObject::invokeMethod(
        this,
        [this, frame] {
            if (m_newest && samePicture(*m_newest, frame->request)) emit delivered(frame);
        },
        Qt::QueuedConnection);
    return true;
}

void ProgressiveCaster::request(const PictureRequest& request, bool byCard) {
    if (m_newest && m_byCard == byCard && samePicture(*m_newest, request)) return;
    if (m_byCard != byCard && forgetNewest()) m_waits.end();
    m_byCard = byCard;
    if (!byCard && deliverKept(request)) return;
    if (!m_playing) m_frames->clear();
    // If another volume is asked for, the picture that is being cast is no quick picture of it. In a motion that
    // picture is a frame to keep.
    if (!m_playing && m_newest && !sameVolumes(*m_newest, request)) m_thread.cancel();
    const bool edited = m_newest && sameSamples(*m_newest, request);
    m_inStream = m_sinceRequest.isValid() && m_sinceRequest.elapsed() < streamMilliseconds;
    m_sinceRequest.start();
    m_rest.stop();
    const std::size_t quality = qualityFor(request, edited);
    m_newest = std::make_shared<const PictureRequest>(request);
    start(quality, NewestWinsThread::WhenSuperseded::finish);
    m_waits.end();
}

std::size_t ProgressiveCaster::qualityFor(const PictureRequest& request, bool edited) {
    if (m_byCard)
        return m_cardQuality ? std::max(qualityForCard, m_cardQuality->qualityInMotion(request.settings))
                             : qualityForCard;
    // In a motion no hand waits: a frame is as fine as its time allows.
    if (m_playing) return m_quality.qualityAlone(request.settings);
    if (edited) {
        const std::size_t quality = m_quality.qualityForEdits(request.settings, m_editing && m_inStream);
        // The first edit of a series finds no kept samples. It is shown as quickly as a new view.
        m_editing = m_inStream || quality == m_startedQuality || quality == m_keptQuality;
        if (m_editing) return quality;
    } else {
        m_keptQuality.reset();
    }
    m_editing = false;
    return m_inStream ? m_quality.qualityInMotion(request.settings) : m_quality.qualityAlone(request.settings);
}

bool ProgressiveCaster::forgetNewest() {
    if (!m_playing) m_frames->clear();
    if (!m_newest) return false;
    m_newest.reset();
    m_rest.stop();
    m_sinceRequest.invalidate();
    // In a motion another phase comes next. The frame that is being cast must be kept, so its ray caster is freed only
    // by the next frame.
    if (!m_playing) m_thread.cancel();
    return true;
}

void ProgressiveCaster::clear() {
    if (!forgetNewest()) return;
    if (!m_playing)
        m_thread.submit(
            [cast = m_cast, cardCast = m_cardCast](const Progress& progress) -> NewestWinsThread::Deliver {
                cast({}, progress);
                cardCast({}, progress);
                return {};
            },
            NewestWinsThread::WhenSuperseded::finish);
    m_waits.end();
}

void ProgressiveCaster::waitForRest(int milliseconds) {
    m_rest.start(milliseconds);
    m_waits.begin();
}

void ProgressiveCaster::refine() {
    m_inStream = false;
    if (m_startedQuality == convergedQuality) return;
    start(m_byCard ? convergedQuality : nextAtRest(m_startedQuality), NewestWinsThread::WhenSuperseded::cancel);
}

void ProgressiveCaster::start(std::size_t quality, NewestWinsThread::WhenSuperseded whenSuperseded) {
    m_startedQuality = quality;
    const bool followsHand = whenSuperseded == NewestWinsThread::WhenSuperseded::finish;
    m_startedQuick = followsHand;
    const Cast cast = m_byCard ? m_cardCast : m_cast, other = m_byCard ? m_cast : m_cardCast;
    auto make = [=, this, byCard = m_byCard, asked = m_newest](const Progress& progress) -> NewestWinsThread::Deliver {
        const auto begin = std::chrono::steady_clock::now();
        const PictureRequest atQuality{asked->panes, settingsAt(quality, asked->settings)};
        const CastResult result = cast(atQuality, progress);
        if (result.panes.empty()) return {};
        const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
        auto finished = std::make_shared<const CastPicture>(
            CastPicture{*asked, quality, atQuality.settings, result.panes, taken.count(), followsHand, byCard});
        return [this, finished, result] {
            learn(*finished, result);
            deliver(finished);
        };
    };
    auto job = [=, this, byCard = m_byCard,
                last = m_lastByCard](const Progress& progress) -> NewestWinsThread::Deliver {
        // Not both keep what they make of a volume.
        if (last->exchange(byCard) != byCard) other({}, progress);
        try {
            return make(progress);
        } catch (const std::bad_alloc&) {
            cast({}, progress);  // frees the interrupted caster
            return [this] { fail(); };
        }
    };
    m_thread.submit(std::move(job), whenSuperseded);
}

void ProgressiveCaster::drawnByCard(const RayCastSettings& settings, double milliseconds) {
    if (!m_cardQuality) m_cardQuality.emplace();
    m_cardQuality->sampled(settings, milliseconds);
}

void ProgressiveCaster::fail() {
    m_keptQuality.reset();
    emit failed();
}

void ProgressiveCaster::learn(const CastPicture& picture, const CastResult& result) {
    if (!result.samples) return;
    const double casting = picture.milliseconds - result.lightMilliseconds;
    if (picture.followsHand) m_quality.lit(picture.settings, result.lightMilliseconds);
    if (result.samples == SampleUse::kept) {
        if (m_newest && sameSamples(*m_newest, picture.request)) m_keptQuality = picture.quality;
        m_quality.reclassified(picture.settings, casting);
    } else {
        m_quality.sampled(picture.settings, casting, result.castShare);
    }
    if (result.samples == SampleUse::notKept) m_quality.couldNotKeep(picture.settings);
}

void ProgressiveCaster::deliver(const std::shared_ptr<const CastPicture>& picture) {
    const bool newest = m_newest && m_byCard == picture->byCard && samePicture(*m_newest, picture->request);
    if (picture->byCard && !newest) return;
    if (m_playing && !picture->byCard) {
        if (picture->quality <= highQuality) {
            m_frames->keep(*picture);
            m_passed = 0;
        }
        if (!newest) return;
        if (picture->quality > highQuality && ++m_passed > passedFrames) {
            start(highQuality, NewestWinsThread::WhenSuperseded::finish);
        } else if (!picture->converged()) {
            waitForRest(editRestMilliseconds);  // a frame that stays becomes as fine as at rest
        }
        emit delivered(picture);
        return;
    }
    if (newest && !picture->converged()) {
        if (m_inStream || m_playing) {
            waitForRest(m_editing || m_playing ? editRestMilliseconds : restMilliseconds);
        } else {
            refine();
        }
    }
    emit delivered(picture);
}

}  // namespace echolucent
