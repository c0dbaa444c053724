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
    connect(&m_parts.model.steps(), &DocumentSteps::changed, this, &NearCutFinder::nameWayBack);
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
                tell(MessageKind::error, tr("Looking for the front needs more memory than this machine has."), {});
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
        tell(MessageKind::warning, cuts(before) ? tr("The front stays as it is. %1").arg(said) : said, {});
        return;
    }
    // In tenths of mm, as people set it.
    const Front front = frontAcross(directionOf(m_looksFrom), std::round(10 * finding.nearCutMm) / 10);
    // Without a front no direction is needed: an OTF computed for another view stays.
    setFront(front, cuts(front) ? directionOf(m_looksFrom) : m_parts.model.document().scene.side);
    WaysOn ways{.bowed = finding.surface};
    if (front != before) {
        ways.before = before;
        ways.step = newestStep();
    }
    tell(MessageKind::info, said, std::move(ways));
}

void NearCutFinder::tellOpening(const NearCutFinding& finding) {
    if (m_parts.model.document().scene.front.source != FrontSource::found) return;
    // A message about the file comes first. The picture's caption also tells of the cut.
    if (!m_parts.messages.text().isEmpty()) return;
    m_looksFrom = viewpointOf(m_parts.model.document());
    tell(MessageKind::info, QString::fromStdString(messageOfFront(finding)),
         {.bowed = finding.surface, .before = Front{}});
}

QList<MessageAction> NearCutFinder::actions() {
    QList<MessageAction> actions;
    if (m_ways.bowed && !m_parts.model.document().scene.front.surface)
        actions << MessageAction{
            tr("Bow it"), [this, surface = m_ways.bowed] { setFront({.surface = surface}, directionOf(m_looksFrom)); }};
    if (m_ways.before)
        actions << MessageAction{m_undoes               ? tr("Undo")
                                 : cuts(*m_ways.before) ? tr("The front before")
                                                        : tr("No front"),
                                 [this] { goBack(); }};
    return actions;
}

bool NearCutFinder::goesBackByUndo() const { return m_ways.step && *m_ways.step == newestStep(); }

void NearCutFinder::goBack() {
    if (goesBackByUndo()) return m_parts.model.steps().undo();
    setFront(*m_ways.before, m_parts.model.document().scene.side);
}

int NearCutFinder::newestStep() const {
    const DocumentSteps& steps = m_parts.model.steps();
    return steps.dropped() + steps.index();
}

void NearCutFinder::tell(MessageKind kind, const QString& text, WaysOn ways) {
    m_told = true;
    m_toldKind = kind;
    m_toldText = text;
    m_ways = std::move(ways);
    m_toldPicture = presentPicture();
    showTold();
}

void NearCutFinder::showTold() {
    m_undoes = goesBackByUndo();
    m_parts.messages.showMessage(
        m_toldKind, m_toldText,
        m_toldKind == MessageKind::error ? MessageEnd::withStudy(frontTopic) : MessageEnd::soon(frontTopic), actions());
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

void NearCutFinder::nameWayBack() {
    if (m_told && m_ways.before && m_undoes != goesBackByUndo() && m_parts.messages.text().startsWith(m_toldText))
        showTold();
}

void NearCutFinder::setFront(const Front& front, const ViewDirection& side) {
    Document next = m_parts.model.document();
    next.scene.front = front;
    next.scene.side = side;
    m_parts.model.edit(next, tr("front"));
}

}  // namespace echolucent
