#include "app/otf/near_cut_finder.h"

#include <cmath>
#include <new>
#include <utility>

namespace echolucent {

NearCutFinder::NearCutFinder(const Parts& parts, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_search(&findNearCut),
      m_thread(parts.works, QStringLiteral("near cut"),
               {.words = tr("looking for the near cut"), .urgency = Urgency::nearCut}) {
    connect(&m_parts.openStudy, &OpenStudy::volumeChanged, this, &NearCutFinder::cancel);
    // If a search runs, searches the cut volume instead.
    connect(&m_parts.openStudy, &OpenStudy::volumeCut, this, [this] {
        if (busy() && m_searched != m_parts.openStudy.volume()) look();
    });
    connect(&m_parts.model, &DocumentModel::changed, this, &NearCutFinder::takeBackWhatIsNoLongerTrue);
}

void NearCutFinder::find() {
    if (!m_parts.openStudy.volume()) return;
    m_looksFrom = viewpointOf(m_parts.model.document());
    look();
}

void NearCutFinder::look() {
    m_searched = m_parts.openStudy.volume();
    m_thread.submit([this, search = m_search, volume = m_searched,
                     view = m_looksFrom](const Progress& progress) -> NewestWinsThread::Deliver {
        try {
            const auto finding = search(*volume, view, progress);
            if (!finding) return {};
            return [this, finding = *finding] { take(finding); };
        } catch (const std::bad_alloc&) {
            return [this] {
                m_parts.messages.showMessage(MessageKind::error,
                                             tr("Looking for the near cut needs more memory than this machine has."));
            };
        }
    });
}

void NearCutFinder::toggle() {
    const Document& document = m_parts.model.document();
    if (document.scene.front == Front{}) return find();
    cutAlong({}, document.scene.side);
}

void NearCutFinder::take(const NearCutFinding& finding) {
    const Front before = m_parts.model.document().scene.front;
    const QString said = QString::fromStdString(finding.message);
    if (finding.answer == NearCutAnswer::noFluid) {
        tell(MessageKind::warning, tr("The near cut stays as it is. %1").arg(said));
        return;
    }
    const Front cut{.depthMm = std::round(10 * finding.nearCutMm) / 10};  // in tenths of mm, as people set it
    // Without a cut no direction is needed: an OTF computed for another view stays.
    cutAlong(cut, cut.depthMm > 0 ? directionOf(m_looksFrom) : m_parts.model.document().scene.side);
    tell(MessageKind::info, said, waysOn(finding, cut == before ? std::nullopt : std::optional(before)));
}

void NearCutFinder::tellOpening(const NearCutFinding& finding) {
    if (m_parts.model.document().scene.front.source != FrontSource::found) return;
    // A message about the file comes first. The picture's caption also tells of the cut.
    if (!m_parts.messages.text().isEmpty()) return;
    m_looksFrom = viewpointOf(m_parts.model.document());
    tell(MessageKind::info, QString::fromStdString(finding.message), waysOn(finding, Front{}));
}

/// Offers the curved cut if there is one, and the way back if `back` has a value.
QList<MessageAction> NearCutFinder::waysOn(const NearCutFinding& finding, const std::optional<Front>& back) {
    QList<MessageAction> actions;
    if (finding.surface)
        actions << MessageAction{tr("Curved cut"), [this, surface = finding.surface] {
                                     cutAlong({.surface = surface}, directionOf(m_looksFrom));
                                 }};
    if (back)
        actions << MessageAction{tr("Take it back"),
                                 [this, back] { cutAlong(*back, m_parts.model.document().scene.side); }};
    return actions;
}

void NearCutFinder::tell(MessageKind kind, const QString& text, const QList<MessageAction>& actions) {
    m_told = text;
    m_toldPicture = presentPicture();
    m_parts.messages.showMessage(kind, text, actions);
}

NearCutFinder::CutPicture NearCutFinder::presentPicture() const {
    const Document& document = m_parts.model.document();
    return {document.study, phaseOf(document, firstPane), document.scene.front, viewpointOf(document)};
}

void NearCutFinder::takeBackWhatIsNoLongerTrue() {
    if (m_told.isEmpty() || presentPicture() == m_toldPicture) return;
    m_parts.messages.takeBack(std::exchange(m_told, {}));
}

void NearCutFinder::cutAlong(const Front& cut, const ViewDirection& direction) {
    Document next = m_parts.model.document();
    next.scene.front = cut;
    next.scene.side = direction;
    m_parts.model.edit(next, tr("near cut"));
}

}  // namespace echolucent
