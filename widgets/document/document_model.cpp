#include "widgets/document/document_model.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "widgets/document/kept_bytes.h"

namespace echolucent {

DocumentModel::DocumentModel(QObject* parent, std::size_t mostBytes)
    : QObject(parent),
      m_steps([this](const Document& document, bool withFrame) { restore(document, withFrame); }, mostBytes) {}

void DocumentModel::edit(const Document& wanted, const QString& what, Gesture gesture) {
    makeStep(wanted, what, gesture, false);
}

void DocumentModel::editWithFrame(const Document& wanted, const QString& what) {
    makeStep(wanted, what, noGesture, true);
}

void DocumentModel::makeStep(const Document& wanted, const QString& what, Gesture gesture, bool setsFrame) {
    const Document kept = keptOf(wanted);
    const Document before =
        keepingChecksum(withShown(std::exchange(m_beforePreview, std::nullopt).value_or(m_document), m_document));
    const Document ownBefore = withoutLook(before);
    // A whole document, of a snapshot for example, has panes of its own, even if they are those that are looked at.
    const bool endsLook = setsFrame && kept.panes.size() != 1 && withoutLook(kept).panes.size() == 1;
    if (endsLook) m_look.reset();
    const Document next = withLook(kept);
    if (!endsLook && withShown(next, before) == before) return set(next);
    m_steps.push(ownBefore, withoutLook(next), what, gesture, setsFrame);
    set(next);
    if (endsLook) emit changed();  // what is shown may be the same
    emit m_steps.changed();
}

void DocumentModel::preview(const Document& wanted, const QString& what) {
    const Document next = withLook(keptOf(wanted));
    if (next == m_document) return;
    if (!m_beforePreview) m_beforePreview = m_document;
    m_previewed = what;
    set(next);
}

void DocumentModel::commitPreview() {
    if (m_beforePreview) edit(m_document, m_previewed, noGesture);
}

void DocumentModel::cancelPreview() {
    if (!m_beforePreview) return;
    Document before = *std::exchange(m_beforePreview, std::nullopt);
    before.scene.phase = m_document.scene.phase;
    // If the drag moved the camera, it stopped the motion, so the motion's angle returns with the pose. During other
    // drags the motion goes on and keeps its present angle.
    if (before.scene.pose == m_document.scene.pose) before.scene.motionAngle = m_document.scene.motionAngle;
    set(keepingChecksum(before));
}

void DocumentModel::take(const Document& wanted, const QString& what, bool dragging) {
    dragging ? preview(wanted, what) : edit(wanted, what);
}

void DocumentModel::moveCamera(const Pose& moved, bool dragging) {
    const Pose shown = shownPose(m_document);
    Document next = m_document;
    next.scene.pose = moved;
    next.scene.motionAngle = 0.0;
    take(next,
         moved.direction != shown.direction           ? tr("turn view")
         : moved.magnification != shown.magnification ? tr("zoom")
                                                      : tr("move view"),
         dragging);
}

void DocumentModel::showPhase(int phase) {
    Document next = m_document;
    next.scene.phase = phase;
    set(next);
}

void DocumentModel::showFrame(double degrees, int phase) {
    Document next = m_document;
    next.scene.motionAngle = degrees;
    next.scene.phase = phase;
    set(next);
}

Document DocumentModel::keepingChecksum(Document document) const {
    if (nameTheSame(document.study, m_document.study)) document.study = m_document.study;
    return document;
}

Document DocumentModel::keptOf(Document document) const {
    return sharing(keepingChecksum(std::move(document)), m_beforePreview ? *m_beforePreview : m_document);
}

void DocumentModel::noteChecksum(const StudyReference& study) {
    if (!nameTheSame(study, m_document.study))
        throw std::invalid_argument("DocumentModel::noteChecksum: the document is of another study");
    if (study == m_document.study) return;
    m_document.study = study;
    emit changed();
}

void DocumentModel::lookAtPanes(const std::vector<Pane>& added) {
    if (m_document.panes.size() != 1)
        throw std::invalid_argument("DocumentModel::lookAtPanes: the document has several panes");
    cancelPreview();
    m_look = LookedAt{added, m_document.comparison};
    set(withLook(m_document));
}

void DocumentModel::endLookAtPanes() {
    if (!m_look) return;
    cancelPreview();
    Document own = ownDocument();
    m_look.reset();
    set(std::move(own));
}

Document DocumentModel::withoutLook(Document document) const {
    const bool looked = m_look && document.panes.size() == m_look->added.size() + 1 &&
                        std::equal(m_look->added.begin(), m_look->added.end(), document.panes.begin() + 1) &&
                        document.comparison == m_look->comparison;
    if (looked) document.panes.resize(1);
    return document;
}

Document DocumentModel::withLook(Document document) {
    if (!m_look || document.panes.size() != 1) return document;
    m_look->comparison = document.comparison;
    document.panes.insert(document.panes.end(), m_look->added.begin(), m_look->added.end());
    return document;
}

void DocumentModel::begin(const Document& document) {
    m_beforePreview.reset();
    // A document with panes of its own is looked at as it is.
    if (document.panes.size() != 1) m_look.reset();
    m_steps.begin(document);
    set(withLook(document));
    emit m_steps.changed();
}

void DocumentModel::comeBack(const Kept& kept) {
    m_beforePreview.reset();
    if (kept.document.panes.size() != 1) m_look.reset();
    m_steps.comeBack(*kept.steps);
    set(withLook(kept.document));
    emit m_steps.changed();
}

void DocumentModel::restore(const Document& document, bool withFrame) {
    // Drop a preview that goes on. `document` is the state to show instead.
    m_beforePreview.reset();
    const bool endsLook = document.panes.size() != 1 && withoutLook(document).panes.size() == 1;
    if (endsLook) m_look.reset();  // as in makeStep()
    set(withLook(keepingChecksum(withFrame ? document : withShown(document, m_document))));
    if (endsLook) emit changed();
}

void DocumentModel::set(Document next) {
    const Document before = std::exchange(m_document, std::move(next));
    // A slot may change the document again. Announce this change all the same: each slot reads the newest document.
    const Document after = m_document;
    if (after.study != before.study) emit studyChanged();
    if (after.beam != before.beam) emit beamChanged();
    if (after.panes != before.panes) emit panesChanged();
    if (after.scene.phase != before.scene.phase) emit phaseChanged();
    if (after.scene.front != before.scene.front) emit frontChanged();
    if (after.scene.box != before.scene.box) emit boxChanged();
    if (after.scene.strokes != before.scene.strokes) emit strokesChanged();
    if (after.measurements != before.measurements) emit measurementsChanged();
    if (after.scene.pose != before.scene.pose) emit poseChanged();
    if (after.scene.planes != before.scene.planes) emit planesChanged();
    if (after.motion != before.motion) emit motionChanged();
    if (after.scene.motionAngle != before.scene.motionAngle) emit motionAngleChanged();
    if (after.scene.look != before.scene.look || after.scene.exposure != before.scene.exposure) emit lookChanged();
    if (after.curves != before.curves) emit curvesChanged();
    if (after.scene.side != before.scene.side) emit sideChanged();
    if (after.method != before.method) emit methodChanged();
    if (after != before) emit changed();
}

}  // namespace echolucent
