#include "app/otf/near_cut_finder.h"

#include <cmath>
#include <new>
#include <utility>

namespace echolucent {

namespace {
constexpr const char* frontTopic = "front";
}  // namespace

NearCutFinder::NearCutFinder(const Parts& parts, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_search(&findNearCut),
      m_thread(parts.works, QStringLiteral("near cut"),
               {.words = tr("looking for the front"), .urgency = Urgency::nearCut}) {
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
    m_frontBefore = m_parts.model.document().scene.front;
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
                tell(MessageKind::error, tr("Looking for the front needs more memory than this machine has."));
            };
        }
    });
}

void NearCutFinder::fromHere() {
    const Document& document = m_parts.model.document();
    const std::shared_ptr<const Volume> volume = m_parts.openStudy.volume();
    if (!volume) return;
    const Front& front = document.scene.front;
    if (!cuts(front)) return find();
    cancel();
    const Pose pose = shownPose(document);
    const Vec3 middle = volume->dataBox().centreMm() + pose.offsetMm;
    setFront(acrossView(front, viewpointOf(document.beam.axis, pose.direction), middle, volume->geometry()),
             document.scene.side);
}

void NearCutFinder::takeAway() {
    cancel();
    if (cuts(m_parts.model.document().scene.front)) setFront({}, m_parts.model.document().scene.side);
}

void NearCutFinder::take(const NearCutFinding& finding) {
    const Front before = m_parts.model.document().scene.front;
    if (before != m_frontBefore) return;  // a person has chosen another one meanwhile
    const QString said = QString::fromStdString(finding.message);
    if (finding.answer == NearCutAnswer::noFluid) {
        tell(MessageKind::warning, cuts(before) ? tr("The front stays as it is. %1").arg(said) : said);
        return;
    }
    // In tenths of mm, as people set it.
    const Front front = frontAcross(directionOf(m_looksFrom), std::round(10 * finding.nearCutMm) / 10);
    // Without a front no direction is needed: an OTF computed for another view stays.
    setFront(front, cuts(front) ? directionOf(m_looksFrom) : m_parts.model.document().scene.side);
    tell(MessageKind::info, said, waysOn(finding, front == before ? std::nullopt : std::optional(before)));
}

void NearCutFinder::tellOpening(const NearCutFinding& finding) {
    if (m_parts.model.document().scene.front.source != FrontSource::found) return;
    // A message about the file comes first. The picture's caption also tells of the cut.
    if (!m_parts.messages.text().isEmpty()) return;
    m_looksFrom = viewpointOf(m_parts.model.document());
    tell(MessageKind::info, QString::fromStdString(messageOfFront(finding)), waysOn(finding, Front{}));
}

/// Offers the bowed front if there is one, and the way back if `back` has a value.
QList<MessageAction> NearCutFinder::waysOn(const NearCutFinding& finding, const std::optional<Front>& back) {
    QList<MessageAction> actions;
    if (finding.surface && !m_parts.model.document().scene.front.surface)
        actions << MessageAction{tr("Bow it"), [this, surface = finding.surface] {
                                     setFront({.surface = surface}, directionOf(m_looksFrom));
                                 }};
    if (back)
        actions << MessageAction{tr("Undo"), [this, back] { setFront(*back, m_parts.model.document().scene.side); }};
    return actions;
}

void NearCutFinder::tell(MessageKind kind, const QString& text, const QList<MessageAction>& actions) {
    m_told = true;
    m_toldPicture = presentPicture();
    m_parts.messages.showMessage(
        kind, text, kind == MessageKind::error ? MessageEnd::withStudy(frontTopic) : MessageEnd::soon(frontTopic),
        actions);
}

NearCutFinder::CutPicture NearCutFinder::presentPicture() const {
    const Document& document = m_parts.model.document();
    return {document.study, phaseOf(document, firstPane), document.scene.front};
}

void NearCutFinder::takeBackWhatIsNoLongerTrue() {
    if (!m_told || presentPicture() == m_toldPicture) return;
    m_told = false;
    m_parts.messages.takeBack(frontTopic);
}

void NearCutFinder::setFront(const Front& front, const ViewDirection& side) {
    Document next = m_parts.model.document();
    next.scene.front = front;
    next.scene.side = side;
    m_parts.model.edit(next, tr("front"));
}

}  // namespace echolucent
