// Makes pictures of one to four panes outside the GUI thread: quick ones first. Better ones follow if nothing newer
// waits.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <atomic>
#include <memory>
#include <optional>

#include "processing/picture/picture_request.h"
#include "widgets/casting/card_makers.h"
#include "widgets/casting/cast_picture.h"
#include "widgets/casting/preview_quality.h"
#include "widgets/casting/ray_casters.h"
#include "widgets/threads/newest_wins_thread.h"

namespace echolucent {

class KeptFrames;

/// PreviewQuality chooses the quality of each picture while requests follow each other. Such a picture is finished and
/// delivered even if a newer request of the same volume waits, so that a drag always shows something. The next picture
/// is cast while this one is drawn. At rest, better pictures follow up to the converged one. Any newer request cancels
/// them within a tile. In a stream of requests they wait until the hand rests, so that they take no time from the next
/// quick one. A request equal to the newest one does nothing. The pictures of all panes are delivered together or not
/// at all.
///
/// Edits of curve and colour map keep one quality, because the ray caster keeps its samples. They wait longer before
/// the picture is refined.
///
/// A graphics card may draw instead of the casting thread. Then this thread prepares what the card draws
/// (makeForCard()), at qualityForCard or coarser while requests follow each other and converged at rest, and delivers
/// that like a picture.
///
/// While a motion plays, frames are also cast in high quality and kept (see KeptFrames). If a high-quality frame takes
/// longer than a frame may, only every third one is kept, so that the motion goes on; a quicker picture of it is
/// delivered first. Turn by turn more of a loop comes from memory. Once the motion has stopped, the next request for
/// another picture drops all kept frames.
class ProgressiveCaster : public QObject {
    Q_OBJECT

public:
    explicit ProgressiveCaster(Works& works, const PreviewQuality& quality = PreviewQuality{},
                               Cast cast = castThroughRayCasters(), Cast cardCast = makeForCard());
    ~ProgressiveCaster() override;

    /// Asks for the pictures of a request. Its settings are as settingsAt() takes them. `byCard`: for what a card draws
    /// the first pane from.
    void request(const PictureRequest& request, bool byCard = false);
    /// Whether the requests from now on are frames of a motion that plays.
    void setPlaying(bool playing);
    /// Frames of the motion that are kept in high quality.
    [[nodiscard]] int keptFrames() const;
    [[nodiscard]] std::size_t keptFrameBytes() const;
    /// Forgets the newest request, cancels what runs and delivers nothing of it. What was kept of its volume is freed.
    /// While a motion plays, the running picture ends first, so that its frame is kept.
    void clear();
    /// True from a request until its converged picture was delivered, its picture has failed, or the request was
    /// cleared.
    [[nodiscard]] bool busy() const { return m_newest && (m_thread.busy() || m_rest.isActive()); }
    /// True while the quick picture of the newest request is on its way.
    [[nodiscard]] bool quickPictureComes() const { return m_newest && m_thread.busy() && m_startedQuick; }
    /// Takes the time to bring a picture to the screen, without casting.
    void drawn(double milliseconds) { m_quality.drawn(milliseconds); }
    /// Takes the time in which a card drew a picture of these settings. If a card is too slow, it draws fewer pixels
    /// while requests follow each other.
    void drawnByCard(const RayCastSettings& settings, double milliseconds);

signals:
    void delivered(const std::shared_ptr<const echolucent::CastPicture>& picture);
    /// A picture needs more memory than there is. Nothing better follows before the next request.
    void failed();

private:
    [[nodiscard]] std::size_t qualityFor(const PictureRequest& request, bool edited);
    void refine();
    void waitForRest(int milliseconds);
    bool forgetNewest();
    bool deliverKept(const PictureRequest& request);
    void start(std::size_t quality, NewestWinsThread::WhenSuperseded whenSuperseded);
    void fail();
    void learn(const CastPicture& picture, const CastResult& result);
    void deliver(const std::shared_ptr<const CastPicture>& picture);

    Cast m_cast, m_cardCast;
    bool m_byCard = false;  // whether a card draws the newest request
    // Whether the newest job was for a card. For jobs alone, which run one after the other.
    std::shared_ptr<std::atomic<bool>> m_lastByCard = std::make_shared<std::atomic<bool>>(false);
    PreviewQuality m_quality;
    std::optional<PreviewQuality> m_cardQuality;  // of a card that has drawn
    std::shared_ptr<const PictureRequest> m_newest;
    QElapsedTimer m_sinceRequest;
    bool m_inStream = false;                          // the newest request came soon after another
    bool m_editing = false;                           // the newest request is one of a series of edits
    std::size_t m_startedQuality = convergedQuality;  // of the picture begun last
    bool m_startedQuick = false;                      // whether that picture follows the hand
    std::optional<std::size_t> m_keptQuality;  // of the newest picture of this view that was made of kept samples
    bool m_playing = false;
    int m_passed = 0;  // frames of the motion since one was cast in high quality
    std::unique_ptr<KeptFrames> m_frames;
    QTimer m_rest;
    Works::UnderWay m_waits;  ///< for the hand to rest
    // Last member: its thread ends before anything above is destroyed.
    NewestWinsThread m_thread;
};

}  // namespace echolucent
