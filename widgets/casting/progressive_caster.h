// Pictures of one to four panes, made outside the GUI thread: first quick ones, then, if nothing newer waits, better
// ones.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "processing/picture/picture_request.h"
#include "widgets/casting/cast_picture.h"
#include "widgets/casting/preview_quality.h"
#include "widgets/casting/ray_casters.h"
#include "widgets/threads/newest_wins_thread.h"

namespace echolucent {

class KeptFrames;

/// While requests follow each other, each picture has the quality that PreviewQuality chooses. It runs to its end and
/// is delivered also if a newer request waits, so that a drag always shows something. The next one is cast while this
/// one is drawn. At rest, better pictures follow up to the converged one; any newer request cancels them within a tile.
/// In a stream of requests they wait until the hand rests, so that they take no time from the next quick one. A request
/// equal to the newest one does nothing. The pictures of all panes are delivered together or not at all.
///
/// Edits of curve and colour map keep one quality, for which the ray caster keeps the samples, and wait longer before
/// the picture is refined.
///
/// While a motion plays, frames are also cast in high quality and kept (see KeptFrames): each one if that takes no
/// longer than a frame may, else every third, so that the motion goes on; a quicker picture of the frame is delivered
/// before it. Turn by turn more of a loop comes from memory. A request that is none of its frames drops what was kept
/// once it plays no more.
class ProgressiveCaster : public QObject {
    Q_OBJECT

public:
    explicit ProgressiveCaster(Works& works, const PreviewQuality& quality = PreviewQuality{},
                               Cast cast = castThroughRayCasters());
    ~ProgressiveCaster() override;

    /// Asks for the pictures of a request, whose settings are those that settingsAt() takes.
    void request(const PictureRequest& request);
    /// Whether the requests from now on are frames of a motion that plays.
    void setPlaying(bool playing);
    /// Frames of the motion that are kept in high quality.
    [[nodiscard]] int keptFrames() const;
    [[nodiscard]] std::size_t keptFrameBytes() const;
    /// Forgets the newest request and cancels what runs; nothing of it is delivered. What was kept of its volume is let
    /// go. While a motion plays, what runs ends first, so that its frame is kept.
    void clear();
    /// True from a request until its converged picture was delivered or it was cleared.
    [[nodiscard]] bool busy() const { return m_newest && (m_thread.busy() || m_rest.isActive()); }
    /// True while the quick picture of the newest request is on its way.
    [[nodiscard]] bool quickPictureComes() const { return m_newest && m_thread.busy() && m_startedQuick; }
    /// Tells what bringing a picture to the screen took, beside the casting.
    void drawn(double milliseconds) { m_quality.drawn(milliseconds); }

signals:
    void delivered(const std::shared_ptr<const echolucent::CastPicture>& picture);
    /// A picture needs more memory than there is. Nothing better follows before another request.
    void failed();
    void busyChanged();

private:
    [[nodiscard]] std::size_t qualityFor(const PictureRequest& request, bool edited);
    void refine();
    void waitForRest(int milliseconds);
    bool deliverKept(const PictureRequest& request);
    void start(std::size_t quality, NewestWinsThread::WhenSuperseded whenSuperseded);
    void fail();
    void learn(const CastPicture& picture, const CastResult& result);
    void deliver(const std::shared_ptr<const CastPicture>& picture);

    Cast m_cast;
    PreviewQuality m_quality;
    std::shared_ptr<const PictureRequest> m_newest;
    QElapsedTimer m_sinceRequest;
    bool m_inStream = false;                          // the newest request came soon after another
    bool m_editing = false;                           // the newest request is one of a series of edits
    std::size_t m_startedQuality = convergedQuality;  // of the newest picture begun
    bool m_startedQuick = false;                      // whether that follows the hand
    std::optional<std::size_t> m_keptQuality;         // of the newest picture made of kept samples, of this view
    bool m_playing = false;
    int m_passed = 0;  // frames of the motion that were not cast in high quality since one was
    std::unique_ptr<KeptFrames> m_frames;
    QTimer m_rest;
    Works::UnderWay m_waits;  ///< for the hand to rest
    // Last, so that its thread has ended before anything above is destroyed.
    NewestWinsThread m_thread;
};

}  // namespace echolucent
