// Pictures made away from the person's thread: first a coarse one, then, when nothing newer waits, the fine one.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "widgets/newest_wins_thread.h"
#include "widgets/volume_view/preview_quality.h"
#include "widgets/volume_view/scene/picture_request.h"

namespace echolucent {

/// A finished picture with what it was made from.
struct CastPicture {
    PictureRequest request;  ///< with the settings of the fine picture, also where this is the coarse one
    std::shared_ptr<const Picture> picture;
    std::shared_ptr<const ScreenPicture> screen;
    bool fine = false;
    double milliseconds = 0.0;  ///< wall time of the casting
};

/// Coarse pictures run to their end and are delivered also when a newer request waits, so that a drag always shows
/// something; fine ones are cancelled by any newer request. In a stream of requests the fine one waits until the hand
/// rests, so that it takes no time from the next coarse one. A request equal to the newest one does nothing.
class ProgressiveCaster : public QObject {
    Q_OBJECT

public:
    /// castRays(), or what a test puts in its place. Runs in another thread.
    using Cast = std::function<std::optional<Picture>(const Volume&, const OpacityCurve&, const RayCastSettings&,
                                                      const Progress&)>;

    explicit ProgressiveCaster(Cast cast = castRays, const PreviewQuality& quality = PreviewQuality{});

    void request(const PictureRequest& request);
    /// Forgets the newest request and cancels what runs; nothing of it is delivered.
    void clear();
    /// True from a request until its fine picture was delivered or it was cleared.
    [[nodiscard]] bool busy() const { return m_thread.busy() || m_rest.isActive(); }

signals:
    void delivered(const std::shared_ptr<const echolucent::CastPicture>& picture);
    void busyChanged();

private:
    void startFine();
    void start(const RayCastSettings& settings, bool fine, NewestWinsThread::WhenSuperseded whenSuperseded);
    void deliver(const std::shared_ptr<const CastPicture>& picture, const RayCastSettings& settings);

    Cast m_cast;
    PreviewQuality m_quality;
    std::shared_ptr<const PictureRequest> m_newest;
    QElapsedTimer m_sinceRequest;
    bool m_inStream = false;  // the newest request came soon after another
    QTimer m_rest;
    // Last, so that its thread has ended before anything above is destroyed.
    NewestWinsThread m_thread;
};

}  // namespace echolucent
