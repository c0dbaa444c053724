#include "widgets/volume_view/progressive_caster.h"

#include <chrono>
#include <utility>

namespace echolucent {

namespace {
constexpr int streamMilliseconds = 150;  // requests that follow each other within this belong to one movement
constexpr int restMilliseconds = 40;     // longer than between two moves of a mouse
}  // namespace

ProgressiveCaster::ProgressiveCaster(Cast cast, const PreviewQuality& quality)
    : m_cast(std::move(cast)), m_quality(quality), m_thread("ray caster") {
    connect(&m_thread, &NewestWinsThread::busyChanged, this, &ProgressiveCaster::busyChanged);
    m_rest.setSingleShot(true);
    m_rest.setInterval(restMilliseconds);
    connect(&m_rest, &QTimer::timeout, this, &ProgressiveCaster::startFine);
}

void ProgressiveCaster::request(const PictureRequest& request) {
    if (m_newest && samePicture(*m_newest, request)) return;
    // A picture of another volume is not a coarse preview of this one.
    if (m_newest && m_newest->volume != request.volume) m_thread.cancel();
    m_newest = std::make_shared<const PictureRequest>(request);
    m_inStream = m_sinceRequest.isValid() && m_sinceRequest.elapsed() < streamMilliseconds;
    m_sinceRequest.start();
    m_rest.stop();
    const RayCastSettings coarse = m_quality.coarse(request.settings);
    const bool isFine = coarse.width == request.settings.width && coarse.height == request.settings.height &&
                        coarse.step == request.settings.step;
    start(coarse, isFine, NewestWinsThread::WhenSuperseded::finish);
}

void ProgressiveCaster::clear() {
    m_newest.reset();
    m_thread.cancel();
    m_sinceRequest.invalidate();
    if (!m_rest.isActive()) return;
    m_rest.stop();
    emit busyChanged();
}

void ProgressiveCaster::startFine() { start(m_newest->settings, true, NewestWinsThread::WhenSuperseded::cancel); }

void ProgressiveCaster::start(const RayCastSettings& settings, bool fine,
                              NewestWinsThread::WhenSuperseded whenSuperseded) {
    auto job = [this, cast = m_cast, request = m_newest, settings, fine](const Progress& progress)
        -> NewestWinsThread::Deliver {
        const auto begin = std::chrono::steady_clock::now();
        std::optional<Picture> picture = cast(*request->volume, request->curve, settings, progress);
        if (!picture) return {};
        const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
        auto screen = std::make_shared<const ScreenPicture>(screenPicture(*picture));
        auto finished = std::make_shared<const CastPicture>(
            CastPicture{*request, std::make_shared<const Picture>(std::move(*picture)), std::move(screen), fine,
                        taken.count()});
        return [this, settings, finished] { deliver(finished, settings); };
    };
    m_thread.submit(std::move(job), whenSuperseded);
}

void ProgressiveCaster::deliver(const std::shared_ptr<const CastPicture>& picture, const RayCastSettings& settings) {
    m_quality.measured(settings, picture->milliseconds);
    const bool newest = m_newest && samePicture(*m_newest, picture->request);
    if (newest && !picture->fine) {
        if (m_inStream) {
            m_rest.start();
        } else {
            startFine();
        }
    }
    emit delivered(picture);
}

}  // namespace echolucent
