#include "app/study/quiet_phases.h"

#include <algorithm>
#include <new>
#include <utility>

#include "app/study/freed_elsewhere.h"

namespace echolucent {

namespace {

std::size_t bytesOfVoxels(const Volume& volume) {
    return std::visit([](const auto& voxels) { return voxels.size() * sizeof(voxels[0]); }, volume.voxels());
}

}  // namespace

QuietPhases::QuietPhases(Works& works, QObject* parent)
    : QObject(parent),
      m_reduce(&quietVolume),
      m_thread(works, QStringLiteral("speckle reduction"),
               {.words = tr("smoothing"), .urgency = Urgency::quietening, .cancel = [this] { cancel(); }}) {
    connect(&m_thread, &NewestWinsThread::busyChanged, this, &QuietPhases::busyChanged);
}

void QuietPhases::begin(Phases raw) {
    cancel();
    m_raw = std::move(raw);
    m_quiet.assign(m_raw.size(), {});
    m_order.clear();
    m_wanted = 0;
    m_another = 0;
    m_failed = false;
}

void QuietPhases::cancel() {
    m_making = -1;
    m_thread.cancel();
}

void QuietPhases::want(int phase, SpeckleReduction reduction, int another) {
    if (std::exchange(m_reduction, reduction) != reduction) {
        cancel();
        m_quiet.assign(m_raw.size(), {});
        m_order.clear();
        m_failed = false;
    }
    m_wanted = phase;
    m_another = another;
    makeNext();
}

std::shared_ptr<const Volume> QuietPhases::of(int phase) const {
    if (phase < 0 || phase >= phaseCount()) return nullptr;
    const auto index = static_cast<std::size_t>(phase);
    return m_reduction == SpeckleReduction::off ? m_raw[index] : m_quiet[index].voxels;
}

std::shared_ptr<const IntensityHistogram> QuietPhases::histogramOf(int phase) const {
    if (phase < 0 || phase >= phaseCount()) return nullptr;
    return m_quiet[static_cast<std::size_t>(phase)].histogram;
}

int QuietPhases::madeCount() const { return static_cast<int>(m_order.size()); }

std::size_t QuietPhases::bytes() const {
    std::size_t bytes = 0;
    for (const int phase : m_order) bytes += bytesOfVoxels(*m_quiet[static_cast<std::size_t>(phase)].voxels);
    return bytes;
}

int QuietPhases::keptAtMost() const {
    if (m_raw.empty()) return 0;
    const std::size_t fit = keptBytesLimit / std::max<std::size_t>(1, bytesOfVoxels(*m_raw.front()));
    return static_cast<int>(std::clamp<std::size_t>(fit, m_another == m_wanted ? 1 : 2, m_raw.size()));
}

/// The phase to make now; -1 if all that may be kept are made. The wanted phases are made in any case.
int QuietPhases::next() const {
    if (m_reduction == SpeckleReduction::off || m_raw.empty() || m_failed) return -1;
    if (!of(m_wanted)) return m_wanted;
    if (!of(m_another)) return m_another;
    if (madeCount() >= keptAtMost()) return -1;
    for (int ahead = 1; ahead < phaseCount(); ++ahead)
        if (const int phase = (m_wanted + ahead) % phaseCount(); !of(phase)) return phase;
    return -1;
}

void QuietPhases::makeNext() {
    const int phase = next();
    if (phase < 0 || phase == m_making) return;
    m_making = phase;
    const int kept = keptAtMost(), before = std::min(madeCount(), kept - 1);
    // A phase that is begun runs to its end. A motion wants another phase all the time, so none would be made.
    m_thread.submit(
        [this, phase, kept, before, reduce = m_reduce, raw = m_raw[static_cast<std::size_t>(phase)],
         reduction = m_reduction](const Progress& progress) -> NewestWinsThread::Deliver {
            try {
                auto quiet = reduce(*raw, reduction, partOf(progress, 1.0 * before / kept, (before + 1.0) / kept));
                if (!quiet) return {};
                Quiet made{freedElsewhere(std::make_shared<const Volume>(quiet->withDataBox(raw->dataBox()))),
                           std::make_shared<const IntensityHistogram>(intensityHistogram(*quiet))};
                return [this, phase, raw, reduction, made = std::move(made)] {
                    const bool current = reduction == m_reduction && phase < phaseCount() &&
                                         m_raw[static_cast<std::size_t>(phase)] == raw;
                    if (current) take(phase, made);
                };
            } catch (const std::bad_alloc&) {
                return [this, phase] {
                    m_making = -1;
                    m_failed = true;  // it would fail again with every phase of a motion
                    emit failed(phase, tr("Reducing the speckle needs more memory than this machine has."));
                };
            }
        },
        NewestWinsThread::WhenSuperseded::finish);
}

void QuietPhases::take(int phase, Quiet quiet) {
    if (m_making == phase) m_making = -1;
    if (!m_quiet[static_cast<std::size_t>(phase)].voxels) m_order.push_back(phase);
    m_quiet[static_cast<std::size_t>(phase)] = std::move(quiet);
    if (madeCount() > keptAtMost()) {
        // The wanted phases stay. If only they and this one are kept, this one goes.
        const auto spare = std::find_if(m_order.begin(), m_order.end(), [&](int made) {
            return made != phase && made != m_wanted && made != m_another;
        });
        const auto dropped = spare != m_order.end() ? spare : std::find(m_order.begin(), m_order.end(), phase);
        m_quiet[static_cast<std::size_t>(*dropped)] = {};
        m_order.erase(dropped);
    }
    emit made(phase);
    makeNext();
}

}  // namespace echolucent
