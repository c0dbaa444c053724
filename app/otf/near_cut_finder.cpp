#include "app/otf/near_cut_finder.h"

#include <QLocale>
#include <cmath>
#include <utility>

#include "widgets/panels/run_status.h"

namespace echolucent {

NearCutFinder::NearCutFinder(const Parts& parts, QObject* parent) : QObject(parent), m_parts(parts) {
    connect(&m_parts.session, &Session::nearCutSuggested, this, &NearCutFinder::take);
    connect(&m_parts.session, &Session::computingOtfChanged, this, [this](bool computing) {
        if (!computing) endProgress();
    });
    connect(&m_parts.session, &Session::otfFailed, this, [this] {
        if (!m_looking) return;
        endProgress();
        m_parts.computing.computeAgain();  // it may have been under way when the search took its place
    });
    connect(&m_parts.model, &DocumentModel::cutsChanged, this, &NearCutFinder::takeBackWhatIsNoLongerTrue);
}

void NearCutFinder::find() {
    if (!m_parts.session.volume()) return;
    const Document& document = m_parts.model.document();
    m_looksFrom = viewpointOf(document, m_parts.view);
    m_looking = true;
    m_parts.status.beginProgress(tr("looking for the near cut"));
    m_parts.session.requestNearCut(m_looksFrom, configOf(document));
}

void NearCutFinder::endProgress() {
    if (std::exchange(m_looking, false) && !m_parts.session.loading()) m_parts.status.endProgress();
}

void NearCutFinder::take(const NearCutSuggestion& suggestion) {
    const QLocale locale;
    const double before = cutOf(m_parts.model.document(), m_parts.view).nearCutMm;
    const QString old = locale.toString(before, 'f', 1);
    endProgress();
    if (!suggestion.message.empty()) {
        tell(MessageKind::warning,
             tr("The near cut stays at %1 mm. %2").arg(old).arg(QString::fromStdString(suggestion.message)));
        m_parts.computing.computeAgain();  // it may have been under way when the search took its place
        return;
    }
    const double cut = std::round(10 * suggestion.nearCutMm) / 10;  // as people set it
    // No cut has no direction: what was computed for another view stays.
    cutAt(cut, cut > 0 ? directionOf(m_looksFrom) : m_parts.model.document().method.direction);
    const QString said = cut > 0 ? tr("Near cut at %1 mm: %2 of %3 tube cores are in fluid there.")
                                       .arg(locale.toString(cut, 'f', 1))
                                       .arg(suggestion.tubesInFluid)
                                       .arg(suggestion.tubesWithWeight)
                                 : tr("Nothing stands in front of the fluid: no near cut is needed.");
    if (cut == before) return tell(MessageKind::info, said);
    tell(
        MessageKind::info, said + QLatin1Char(' ') + tr("It was %1 mm before.").arg(old),
        {{tr("Back to %1 mm").arg(old), [this, before] { cutAt(before, m_parts.model.document().method.direction); }}});
}

void NearCutFinder::tell(MessageKind kind, const QString& text, const QList<MessageAction>& actions) {
    m_told = text;
    m_toldCutMm = cutOf(m_parts.model.document(), m_parts.view).nearCutMm;
    m_parts.messages.showMessage(kind, text, actions);
}

void NearCutFinder::takeBackWhatIsNoLongerTrue() {
    if (m_told.isEmpty() || cutOf(m_parts.model.document(), m_parts.view).nearCutMm == m_toldCutMm) return;
    m_parts.messages.takeBack(std::exchange(m_told, {}));
}

void NearCutFinder::cutAt(double mm, const ViewDirection& direction) {
    Document next = m_parts.model.document();
    cutOf(next, m_parts.view).nearCutMm = mm;
    next.method.direction = direction;
    m_parts.model.edit(next, tr("near cut"));
    // The search has taken the place of the OTF that was computed, also where the document stays as it is.
    m_parts.computing.computeAgain();
}

}  // namespace echolucent
