#include "app/picture/side_controls.h"

#include "processing/document/side_taking.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/key_table.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

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
    // The sides of a study that is left are no choice any more.
    connect(&m_parts.openStudy, &OpenStudy::loadingChanged, this, &SideControls::nameActions);
    connect(&m_parts.strip, &SideStrip::seenChanged, &m_pictures, &SidePictures::setSeen);
    m_pictures.setSeen(m_parts.strip.isSeen());
    connect(&m_pictures, &SidePictures::changed, this, [this] {
        for (std::size_t i = 0; i < m_actions.size(); ++i) m_parts.strip.setPicture(i, m_pictures.images()[i]);
    });
}

void SideControls::nameActions() {
    const auto& finding = m_parts.sides.finding();
    const bool canTake = finding != nullptr && !m_parts.openStudy.loading();
    for (std::size_t i = 0; i < m_actions.size(); ++i) {
        QAction* action = m_actions[i];
        const auto number = static_cast<int>(i) + 1;
        action->setEnabled(canTake);
        if (!finding) {
            action->setText(tr("&%1 Side %1").arg(number));
            action->setIconText(QString::number(number));
            action->setToolTip(tr("The sides of the scan are not found yet"));
            continue;
        }
        const Side& side = finding->sides[i].side;
        const QString name = textOf(side.name), key = action->shortcut().toString(QKeySequence::NativeText);
        action->setText(QStringLiteral("&%1 %2").arg(number).arg(name));
        action->setIconText(textOf(side.label));
        action->setToolTip(i == finding->best ? tr("%1 (%2). %3").arg(name, key, textOf(finding->sentence))
                                              : tr("%1 (%2)").arg(name, key));
    }
    showTaken();
}

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
    remember(place);
}

void SideControls::remember(std::size_t place) {
    const auto& finding = m_parts.sides.finding();
    if (m_parts.openStudy.isSimulatedScan() || m_parts.openStudy.study() == nullptr) return;
    const QString kind = QString::fromStdString(kindOfScan(*m_parts.openStudy.study()));
    m_parts.settings.setSideTaken(kind, place == finding->best ? QString() : textOf(finding->sides[place].side.word));
}

ViewDirection SideControls::directionOfSide(const Document& opened) const {
    const auto place = taken();
    return place ? directionOf(m_parts.sides.finding()->sides[*place].side.view) : opened.scene.side;
}

Front SideControls::frontOfSide(const Document& opened) const {
    const auto place = taken();
    if (!place) return opened.scene.front;
    const JudgedSide& judged = m_parts.sides.finding()->sides[*place];
    return frontOf(judged.side.view, judged.front);
}

}  // namespace echolucent
