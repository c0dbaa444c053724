#include "app/study/cut_phases.h"

#include <algorithm>
#include <new>

#include "app/study/freed_elsewhere.h"

namespace echolucent {

CutPhases::CutPhases(Works& works, QObject* parent) : QObject(parent), m_thread(works, QStringLiteral("scalpel")) {
    connect(&m_thread, &NewestWinsThread::busyChanged, this, &CutPhases::busyChanged);
}

void CutPhases::begin(Phases scans) {
    m_thread.cancel();
    m_scans = std::move(scans);
    m_cut.assign(m_scans.size(), {});
    m_strokes.clear();
    m_cuts.reset();
    m_wanted = 0;
}

void CutPhases::want(int phase, const std::vector<ScalpelStroke>& strokes) {
    m_wanted = phase;
    if (strokes == m_strokes) {
        if (!busy()) makeNext();  // else what is wanted follows the phase that is being cut
        return;
    }
    m_thread.cancel();
    m_strokes = strokes;
    for (Cut& cut : m_cut) cut.current = false;
    if (m_strokes.empty())
        for (int each = 0; each < static_cast<int>(m_cut.size()); ++each) take(each, nullptr);
    makeNext();
}

std::shared_ptr<const Volume> CutPhases::of(int phase, const std::shared_ptr<const Volume>& voxels) {
    Cut& cut = m_cut.at(static_cast<std::size_t>(phase));
    if (!cut.mask || !voxels) return voxels;
    const auto found = std::ranges::find(cut.volumes, voxels, [](const auto& pair) { return pair.first; });
    if (found != cut.volumes.end()) return found->second;
    constexpr std::size_t kinds = 2;  // raw and quiet voxels
    if (cut.volumes.size() >= kinds) cut.volumes.pop_back();
    cut.volumes.insert(cut.volumes.begin(),
                       {voxels, freedElsewhere(std::make_shared<const Volume>(voxels->withCut(cut.mask)))});
    return cut.volumes.front().second;
}

/// The phase to cut now; -1 if all are cut.
int CutPhases::next() const {
    for (int ahead = 0; ahead < static_cast<int>(m_cut.size()); ++ahead) {
        const int phase = (m_wanted + ahead) % static_cast<int>(m_cut.size());
        if (!m_cut[static_cast<std::size_t>(phase)].current) return phase;
    }
    return -1;
}

void CutPhases::makeNext() {
    const int phase = next();
    if (phase < 0) return;
    const auto& scan = m_scans[static_cast<std::size_t>(phase)];
    // All phases of a study lie on one grid, so a stroke cuts the same places out of each.
    if (!m_cuts || m_cuts->geometry().size != scan->geometry().size)
        m_cuts = freedElsewhere(std::make_shared<ScalpelCuts>(scan->geometry()));
    m_thread.submit(
        [this, phase, scan, cuts = m_cuts, strokes = m_strokes](const Progress& progress) -> NewestWinsThread::Deliver {
            try {
                const auto cut = cuts->cut(*scan, strokes, progress);
                if (!cut) return {};
                return [this, phase, mask = freedElsewhere(cut->cut())] {
                    take(phase, mask);
                    makeNext();
                };
            } catch (const std::bad_alloc&) {
                *cuts = ScalpelCuts(scan->geometry());  // a stroke may be half done
                return [this] {
                    for (Cut& cut : m_cut) cut.current = true;  // it would fail again
                    emit failed(tr("Cutting with the scalpel needs more memory than this machine has."));
                };
            }
        });
}

void CutPhases::take(int phase, Volume::SharedMask mask) {
    Cut& cut = m_cut[static_cast<std::size_t>(phase)];
    cut.current = true;
    if (mask == cut.mask) return;
    cut.mask = std::move(mask);
    cut.volumes.clear();
    emit made(phase);
}

}  // namespace echolucent
