#include "widgets/planes/plane_resampler.h"

#include <new>
#include <utility>
#include <vector>

namespace echolucent {

PlaneGrid gridOf(const PlaneRequest& request) {
    const double step = request.view.heightMm / request.rows;
    PlaneGrid grid;
    grid.columns = request.columns;
    grid.rows = request.rows;
    grid.perColumnMm = request.view.frame.right * step;
    grid.perRowMm = request.view.frame.down * step;
    grid.firstMm = request.view.centreMm - grid.perColumnMm * (0.5 * (request.columns - 1)) -
                   grid.perRowMm * (0.5 * (request.rows - 1));
    return grid;
}

PlaneResampler::PlaneResampler(Works& works, QObject* parent)
    : QObject(parent), m_thread(works, QStringLiteral("planes")) {}

void PlaneResampler::want(const std::array<std::optional<PlaneRequest>, 3>& requests) {
    if (requests == m_wanted) return;
    m_wanted = requests;
    start();
}

void PlaneResampler::start() {
    using Made = std::pair<PlaneName, std::shared_ptr<const PlaneSamples>>;
    std::vector<PlaneName> open;
    for (const PlaneName plane : allPlaneNames)
        if (m_wanted[indexOf(plane)] && m_wanted[indexOf(plane)] != m_made[indexOf(plane)]) open.push_back(plane);
    // If the same planes are being made already, wait for them.
    if (open.empty() || (m_thread.busy() && m_asked == m_wanted)) return;
    m_asked = m_wanted;
    // A drag shows planes even if newer requests come faster than planes are made.
    m_thread.submit(
        [this, open, requests = m_wanted](const Progress&) -> NewestWinsThread::Deliver {
            std::vector<Made> made;
            try {
                for (const PlaneName plane : open) {
                    const PlaneRequest& request = *requests[indexOf(plane)];
                    made.emplace_back(
                        plane, std::make_shared<const PlaneSamples>(sampledPlane(*request.volume, gridOf(request))));
                }
            } catch (const std::bad_alloc&) {
                return {};  // the planes stay the same, and every change tries again
            }
            return [this, made = std::move(made), requests] {
                for (const auto& [plane, samples] : made) {
                    const auto &request = requests[indexOf(plane)], &wanted = m_wanted[indexOf(plane)];
                    // Too late: the plane is now hidden, or its volume is no longer shown.
                    if (!wanted || wanted->volume != request->volume) continue;
                    m_made[indexOf(plane)] = request;
                    emit resampled(plane, samples, *request);
                }
                start();  // another request may have come since
            };
        },
        NewestWinsThread::WhenSuperseded::finish);
}

}  // namespace echolucent
