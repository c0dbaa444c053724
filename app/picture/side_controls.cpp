#include "app/picture/side_controls.h"

#include "processing/document/side_taking.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/key_table.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

namespace {

QString whyFirst(FirstSideReason reason) {
    switch (reason) {
        case FirstSideReason::nothingShows:
            return SideControls::tr("It comes first: no side surely shows anything behind fluid.");
        case FirstSideReason::tooLittleOpenElsewhere:
            return SideControls::tr(
                "It comes first: what other sides show behind fluid fills too little of their pictures.");
        case FirstSideReason::noneClearlyMore:
            return SideControls::tr("It comes first: no other side shows clearly more.");
        case FirstSideReason::showsMost: return SideControls::tr("It comes first: it shows the most.");
        case FirstSideReason::firstInTheCoarsePicture: break;
    }
    return SideControls::tr("It comes first: so it did in the coarse picture, which comes before all is read.");
}

}  // namespace

QString tipOfSide(const SidesFinding& finding, std::size_t place, const QString& key) {
    const Side& side = finding.sides[place].side;
    const QString meaning = SideControls::tr("%1 (%2). %3").arg(textOf(side.name), key, textOf(side.meaning));
    return place == finding.best ? meaning + QLatin1Char(' ') + whyFirst(finding.reason) : meaning;
}

SideControls::SideControls(const Parts& parts, QObject* parent)
    : QObject(parent), m_parts(parts), m_pictures(parts.model, parts.sides, parts.picture, parts.works) {
    for (std::size_t i = 0; i < m_actions.size(); ++i) {
        auto* action = new QAction(&m_parts.strip);  // in the window, where scripts look for it
        action->setObjectName(QStringLiteral("room.lookInFrom%1").arg(i + 1));
        action->setShortcut(keyOf(action->objectName()));
        action->setCheckable(true);
        connect(action, &QAction::triggered, this, [this, i] { take(i); });
        m_actions[i] = action;
    }
    nameActions();
    m_parts.strip.setActions(m_actions);
    connect(&m_parts.sides, &StudySides::changed, this, &SideControls::nameActions);
    for (const auto part : {&DocumentModel::sideChanged, &DocumentModel::beamChanged})
        connect(&m_parts.model, part, this, &SideControls::showTaken);
    connect(&m_parts.openStudy, &OpenStudy::loadingBegun, this, [this] {
        remember();
        m_pictures.stop();
    });
    // The sides of a study that is left are no choice any more.
    connect(&m_parts.openStudy, &OpenStudy::loadingChanged, this, &SideControls::nameActions);
    connect(&m_parts.openStudy, &OpenStudy::studyReplaced, this, [this] { m_took = false; });
    connect(&m_parts.strip, &SideStrip::seenChanged, &m_pictures, &SidePictures::setSeen);
    m_pictures.setSeen(m_parts.strip.isVisible());
    connect(&m_pictures, &SidePictures::changed, this, [this] {
        for (std::size_t i = 0; i < m_actions.size(); ++i) m_parts.strip.setPicture(i, m_pictures.images()[i]);
    });
}

void SideControls::nameActions() {
    const auto& finding = m_parts.sides.finding();
    const QString whyNot = m_parts.openStudy.loading() ? tr("Another study is being opened.")
                           : finding                   ? QString()
                                                       : tr("The sides of the scan are not found yet.");
    for (std::size_t i = 0; i < m_actions.size(); ++i) {
        QAction* action = m_actions[i];
        const auto number = static_cast<int>(i) + 1;
        if (!finding) {
            action->setText(tr("&%1 Side %1").arg(number));
            action->setIconText(QString::number(number));
            action->setToolTip(tr("Looks into the scan from one of its sides"));
            enableOrSayWhy(*action, false, whyNot);
            continue;
        }
        const Side& side = finding->sides[i].side;
        action->setText(QStringLiteral("&%1 %2").arg(number).arg(textOf(side.name)));
        action->setIconText(textOf(side.label));
        action->setToolTip(tipOfSide(*finding, i, action->shortcut().toString(QKeySequence::NativeText)));
        enableOrSayWhy(*action, whyNot.isEmpty(), whyNot);
    }
    showTaken();
}

/// The side along which the tube cores look, if they look along one.
std::optional<std::size_t> SideControls::taken() const {
    const auto& finding = m_parts.sides.finding();
    if (!finding) return std::nullopt;
    const Document& document = m_parts.model.document();
    return sideAlong(*finding, document.beam.axis, document.scene.side);
}

void SideControls::showTaken() {
    const auto place = taken();
    for (std::size_t i = 0; i < m_actions.size(); ++i) m_actions[i]->setChecked(place == i);
}

void SideControls::take(std::size_t place) {
    showTaken();  // a click toggles the action, which says what is taken
    const auto& finding = m_parts.sides.finding();
    const std::shared_ptr<const Volume> volume = m_parts.openStudy.volume();
    if (!finding || !volume) return;
    emit taking();
    const JudgedSide& judged = finding->sides[place];
    Document next = withSideTaken(m_parts.model.document(), judged, volume->dataBox(), m_parts.picture.aspect());
    m_parts.model.edit(next, tr("side: %1").arg(textOf(judged.side.name)));
    m_took = true;
}

void SideControls::remember() {
    const auto place = taken();
    if (!m_took || !place || m_parts.openStudy.isSimulatedScan() || m_parts.openStudy.study() == nullptr) return;
    const SidesFinding& finding = *m_parts.sides.finding();
    const QString kind = QString::fromStdString(kindOfScan(*m_parts.openStudy.study()));
    m_parts.settings.setSideTaken(kind, *place == finding.best ? QString() : textOf(finding.sides[*place].side.word));
}

/// The side along which the tube cores look, or, if they were turned, the one whose front cuts.
std::optional<std::size_t> SideControls::takenOrCut() const {
    if (const auto place = taken()) return place;
    const auto& finding = m_parts.sides.finding();
    const Front& front = m_parts.model.document().scene.front;
    if (!finding || !cuts(front)) return std::nullopt;
    for (std::size_t i = 0; i < finding->sides.size(); ++i)
        if (frontOf(finding->sides[i].side.view, finding->sides[i].front) == front) return i;
    return std::nullopt;
}

ViewDirection SideControls::directionOfSide(const Document& opened) const {
    if (const auto place = takenOrCut()) return directionOf(m_parts.sides.finding()->sides[*place].side.view);
    const Beam& beam = m_parts.model.document().beam;
    return beam == opened.beam ? opened.scene.side : beam.lean;
}

Front SideControls::frontOfSide(const Document& opened) const {
    if (const auto place = takenOrCut()) {
        const JudgedSide& judged = m_parts.sides.finding()->sides[*place];
        return frontOf(judged.side.view, judged.front);
    }
    return m_parts.model.document().beam == opened.beam ? opened.scene.front : Front{};
}

}  // namespace echolucent
