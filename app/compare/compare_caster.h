// Pictures of all panes of a comparison for one camera, cast in one thread and shown together.
#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QObject>
#include <QTimer>
#include <memory>
#include <vector>

#include "processing/classification.h"
#include "processing/picture/ray_cast_settings.h"
#include "processing/volume/volume.h"
#include "widgets/newest_wins_thread.h"
#include "widgets/volume_view/preview_quality.h"

namespace echolucent {

/// What one pane is cast through.
struct PaneRequest {
    std::shared_ptr<const Volume> volume;
    Classification classification = ManualCurve{};
    friend bool operator==(const PaneRequest&, const PaneRequest&) = default;
};

/// All panes, which have one camera: the settings, at the panes' full size and the look's own step.
struct CompareRequest {
    std::vector<PaneRequest> panes{};
    RayCastSettings settings{};
    std::vector<std::size_t> places{};  ///< of these panes in the comparison, for whoever shows them
    friend bool operator==(const CompareRequest&, const CompareRequest&) = default;
};

/// The picture of one pane.
struct PanePicture {
    QImage image;               ///< over black, at the quality's size
    double milliseconds = 0.0;  ///< that it took in the casting thread, its light included
    bool sampled = true;        ///< not made of samples that were kept, which takes less
};

/// The pictures of all panes of one request.
struct CompareFrame {
    CompareRequest request;    ///< as it was asked for
    std::size_t quality = 0;   ///< of qualities
    RayCastSettings settings;  ///< those of the quality, with which every pane was cast
    std::vector<PanePicture> panes;
    double milliseconds = 0.0;  ///< of all
    [[nodiscard]] bool converged() const { return quality == 0; }
};

/// As ProgressiveCaster: while requests follow each other, frames at the finest quality within a frame's time run to
/// their end; at rest, better ones follow up to the converged one, and any newer request cancels them. The panes of a
/// frame are delivered together or not at all. A pane for which nothing changed is not cast again.
class CompareCaster : public QObject {
    Q_OBJECT

public:
    explicit CompareCaster(QObject* parent = nullptr);
    ~CompareCaster() override;

    /// A request equal to the newest one does nothing.
    void request(const CompareRequest& request);
    /// Forgets the newest request, cancels what runs, and lets go what is kept of volumes.
    void clear();
    /// True from a request until its converged frame was delivered, it failed or was cleared.
    [[nodiscard]] bool busy() const { return m_newest && (m_thread.busy() || m_rest.isActive()); }
    /// Whether a frame of the newest request, of whichever quality, was delivered; true where there is no request.
    [[nodiscard]] bool newestIsThere() const { return !m_newest || m_newestIsThere; }
    /// Tells what bringing a frame to the screen took, beside the casting.
    void drawn(double milliseconds) { m_quality.drawn(milliseconds); }

signals:
    void delivered(const std::shared_ptr<const echolucent::CompareFrame>& frame);
    /// A frame needs more memory than there is.
    void failed();
    void busyChanged();

private:
    class Casters;
    /// What a frame taught of the machine, as PreviewQuality learns it.
    struct Lesson {
        bool allSampled = false;
        double lightMilliseconds = 0.0;
        bool followsHand = false;
    };
    void start(std::size_t quality, NewestWinsThread::WhenSuperseded whenSuperseded);
    void refine();
    void deliver(const std::shared_ptr<const CompareFrame>& frame, const Lesson& lesson);

    std::shared_ptr<Casters> m_casters;  ///< for the casting thread alone
    PreviewQuality m_quality;
    std::shared_ptr<const CompareRequest> m_newest;
    QElapsedTimer m_sinceRequest;
    bool m_inStream = false;
    bool m_newestIsThere = false;
    std::size_t m_startedQuality = 0;
    QTimer m_rest;
    // Last, so that its thread has ended before anything above is destroyed.
    NewestWinsThread m_thread;
};

}  // namespace echolucent
