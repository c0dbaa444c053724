#include "app/study/study_sides.h"

#include <new>
#include <utility>
#include <variant>

namespace echolucent {

StudySides::StudySides(const DocumentModel& model, const OpenStudy& openStudy, Works& works, QObject* parent)
    : QObject(parent),
      m_model(model),
      m_openStudy(openStudy),
      m_thread(works, QStringLiteral("sides"), {.countsForRest = false}) {
    connect(&m_openStudy, &OpenStudy::studyOpened, this, &StudySides::follow);
    connect(&m_model, &DocumentModel::beamChanged, this, &StudySides::follow);
}

void StudySides::follow() {
    const Study* study = m_openStudy.study();
    // A document that begins changes its beam before the study is told of.
    if (study == nullptr || m_openStudy.beginning()) return;
    const auto& first = study->phases.front();
    const Beam& beam = m_model.document().beam;
    if (m_volume == first && m_beam == beam) return;
    m_volume = first;
    m_beam = beam;
    m_thread.cancel();
    set(foundOnOpening());
    if (m_finding) return;
    const bool sure = beamIsSure(beam, m_openStudy);
    m_thread.submit([this, volume = m_volume, fromProbe = viewAlongBeam(beam),
                     sure](const Progress& progress) -> NewestWinsThread::Deliver {
        try {
            auto found = findSides(*volume, fromProbe, sure, CutShapes::flatAndCurved, progress);
            if (!found) return {};
            return [this, finding = std::make_shared<const SidesFinding>(std::move(*found))] { set(finding); };
        } catch (const std::bad_alloc&) {
            return {};  // there are no sides to choose from; the 3D view tells of missing memory
        }
    });
}

bool beamIsSure(const Beam& beam, const OpenStudy& openStudy) {
    return beam.source != BeamSource::assumed || openStudy.isSimulatedScan();
}

/// The sides found on opening, if they are of the document's beam; else null.
std::shared_ptr<const SidesFinding> StudySides::foundOnOpening() const {
    const auto& finds = m_openStudy.finds();
    if (!finds) return nullptr;
    Document asFound;
    asFound = withFinds(std::move(asFound), *finds);
    return asFound.beam == *m_beam ? finds->sides : nullptr;
}

void StudySides::set(std::shared_ptr<const SidesFinding> finding) {
    if (finding == m_finding) return;
    m_finding = std::move(finding);
    emit changed();
}

}  // namespace echolucent
