// Resamples planes outside the GUI thread.
#pragma once

#include <QObject>
#include <array>
#include <memory>
#include <optional>

#include "processing/sampling/plane_sampling.h"
#include "processing/scene/planes.h"
#include "widgets/threads/newest_wins_thread.h"

namespace echolucent {

/// A picture of a plane that is wanted, or was made.
struct PlaneRequest {
    std::shared_ptr<const Volume> volume;
    PlaneView view;
    int columns = 0, rows = 0;
    friend bool operator==(const PlaneRequest&, const PlaneRequest&) = default;
};

/// The places of a picture's pixels. Its centre is the view's, and rows are as far apart as columns.
[[nodiscard]] PlaneGrid gridOf(const PlaneRequest& request);

/// Resamples the wanted planes in one thread. The newest request wins. A plane that was made last is not made again. If
/// all wanted planes are just being made, nothing is started. Only values cross the threads.
class PlaneResampler : public QObject {
    Q_OBJECT

public:
    explicit PlaneResampler(Works& works, QObject* parent = nullptr);

    /// The planes that are wanted from now on. A plane without a value is not wanted.
    void want(const std::array<std::optional<PlaneRequest>, 3>& requests);

signals:
    void resampled(echolucent::PlaneName plane, const std::shared_ptr<const echolucent::PlaneSamples>& samples,
                   const echolucent::PlaneRequest& request);

private:
    void start();

    using Requests = std::array<std::optional<PlaneRequest>, 3>;
    Requests m_wanted, m_made;
    Requests m_asked;  ///< of the newest job
    // Last, so that its thread ends before the members above are destroyed.
    NewestWinsThread m_thread;
};

}  // namespace echolucent
