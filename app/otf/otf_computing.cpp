#include "app/otf/otf_computing.h"

namespace echolucent {

OtfComputing::OtfComputing(DocumentModel& model, OpenStudy& openStudy, QObject* parent)
    : QObject(parent), m_model(model), m_openStudy(openStudy) {
    begin();
    connect(&m_model, &DocumentModel::changed, this, &OtfComputing::follow);
}

void OtfComputing::begin() {
    m_openStudy.setReduction(m_model.document().scene.look.reduction);
    sayPhase();
    m_ofDocument = otfViewpointOf(m_model.document(), firstPane);
    m_asked = m_ofDocument;
    m_config = configOf(m_model.document(), firstPane);
}

void OtfComputing::sayPhase() {
    const MotionChoice& motion = m_model.document().motion;
    m_phase = motion.otf == MotionOtf::oneOtf ? std::optional(motion.otfPhase) : std::nullopt;
    m_openStudy.setOtfPhase(m_phase);
}

void OtfComputing::follow() {
    m_openStudy.setReduction(m_model.document().scene.look.reduction);
    const std::optional<int> before = m_phase;
    sayPhase();
    // Between one OTF and each frame's own, whoever shows the frames asks.
    const bool otherPhase = before && m_phase && before != m_phase;
    const Viewpoint ofDocument = otfViewpointOf(m_model.document(), firstPane);
    const AdaptiveOtfConfig config = configOf(m_model.document(), firstPane);
    if (ofDocument == m_ofDocument && config == m_config && !otherPhase) return;
    Viewpoint onlyCut = m_ofDocument;
    onlyCut.nearCutMm = ofDocument.nearCutMm;
    onlyCut.cutSurface = ofDocument.cutSurface;
    onlyCut.box = ofDocument.box;
    // A cut or a box alone leaves the direction of a frame of the motion as it is.
    if (ofDocument == onlyCut) {
        m_asked.nearCutMm = ofDocument.nearCutMm;
        m_asked.cutSurface = ofDocument.cutSurface;
        m_asked.box = ofDocument.box;
    } else {
        m_asked = ofDocument;
    }
    m_ofDocument = ofDocument;
    m_config = config;
    computeAgain();
}

void OtfComputing::computeFor(const Viewpoint& viewpoint) {
    m_asked = viewpoint;
    m_openStudy.requestOtf(viewpoint, configOf(m_model.document(), firstPane));
}

void OtfComputing::computeForThisView() {
    if (!m_openStudy.volume()) return;
    const Viewpoint shown = viewpointOf(m_model.document());
    Document next = m_model.document();
    next.scene.side = directionOf(shown);
    next.motion.otfPhase = phaseOf(next, firstPane);
    m_model.edit(next, tr("compute for this view"));
    computeFor(shown);
}

}  // namespace echolucent
