#include "app/window/long_works.h"

#include <utility>

#include "widgets/panels/run_status.h"

namespace echolucent {

LongWorks::LongWorks(RunStatus& status, QObject* parent) : QObject(parent), m_status(status) {
    connect(&m_status, &RunStatus::cancelRequested, this, [this] {
        if (const auto work = shown()) m_works[*work].cancel();
    });
}

std::size_t LongWorks::add(Work work) {
    m_works.push_back(std::move(work));
    return m_works.size() - 1;
}

// It is asked anew which one runs, so that the end of one does not hide another.
void LongWorks::follow() {
    if (const auto work = shown())
        m_status.beginProgress(m_works[*work].words());
    else
        m_status.endProgress();
}

void LongWorks::setProgress(std::size_t work, double share) {
    if (shown() == work) m_status.setProgress(share);
}

std::optional<std::size_t> LongWorks::shown() const {
    for (std::size_t work = 0; work < m_works.size(); ++work)
        if (m_works[work].busy()) return work;
    return std::nullopt;
}

}  // namespace echolucent
