#include "app/sessions/left_unsaved.h"

#include <QAction>
#include <QFileInfo>
#include <QLocale>
#include <QMenu>
#include <algorithm>
#include <utility>

#include "app/sessions/autosave.h"
#include "app/settings/settings.h"
#include "app/study/open_study.h"
#include "app/study/study_names.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/panel_controls.h"

namespace echolucent {

namespace {
constexpr const char *leftTopic = "left unsaved", *damagedTopic = "damaged session";
}  // namespace

LeftUnsaved::LeftUnsaved(const Parts& parts, QObject* parent)
    : QObject(parent), m_parts(parts), m_taking(parts.works, QStringLiteral("left sessions")) {
    connect(&m_parts.messages, &MessageBar::putAway, this, &LeftUnsaved::putAway);
    m_taking.submit([this, folder = m_parts.settings.autosaveFolder()](const Progress&) -> NewestWinsThread::Deliver {
        auto found = takeLeftovers(folder);
        return [this, folder, left = std::move(found)] {
            for (const Leftover& each : left)
                each.damaged.isEmpty() ? m_list.push_back(each) : m_damaged.push_back(each.damaged);
            QStringList put = m_parts.settings.leftSessionsPutAway();
            for (const QString& name : std::as_const(put)) m_told << folder + QLatin1Char('/') + name;
            // Files that are gone need not be remembered.
            if (put.removeIf([&](const QString& name) { return !QFileInfo::exists(folder + QLatin1Char('/') + name); }))
                m_parts.settings.setLeftSessionsPutAway(put);
            emit listChanged();
            if (m_parts.openStudy.study() != nullptr) offer();
        };
    });
}

void LeftUnsaved::add(Leftover left) {
    m_list.push_back(std::move(left));
    emit listChanged();
}

std::optional<Leftover> LeftUnsaved::take(const QString& file) {
    const auto found = std::ranges::find(m_list, file, &Leftover::file);
    if (found == m_list.end()) return std::nullopt;
    Leftover taken = std::move(*found);
    m_list.erase(found);
    emit listChanged();
    return taken;
}

void LeftUnsaved::open(const QString& file) {
    m_opening = file;
    const auto found = std::ranges::find(m_list, file, &Leftover::file);
    if (found != m_list.end()) m_parts.openStudy.openSaved(file, {}, found->study);
}

void LeftUnsaved::discard(const QString& file) {
    // While its study loads, it is no longer left.
    if (m_parts.openStudy.loading() && file == m_opening) return;
    if (const auto left = take(file)) m_parts.autosave.discard({left->file, left->lock});
}

void LeftUnsaved::offer() {
    tellDamaged();
    m_offered.clear();
    for (const Leftover& left : m_list)
        if (!m_told.contains(left.file)) m_offered << left.file;
    if (m_offered.isEmpty()) return;
    m_told << m_offered;
    if (m_offered.size() > 1)
        return m_parts.messages.showMessage(
            MessageKind::info,
            tr("%1 sessions were left unsaved. They stand in File > Left unsaved.").arg(m_offered.size()),
            MessageEnd::soon(leftTopic));
    const QString file = m_offered.front();
    const Leftover& left = *std::ranges::find(m_list, file, &Leftover::file);
    m_parts.messages.showMessage(
        MessageKind::info, tr("A session of %1 was left unsaved (%2).").arg(nameOf(left), timeOf(left)),
        MessageEnd::soon(leftTopic),
        {{tr("Open it"), [this, file] { open(file); }}, {tr("Discard it"), [this, file] { discard(file); }}});
}

void LeftUnsaved::tellDamaged() {
    if (m_damaged.isEmpty()) return;
    const QString sentences = std::exchange(m_damaged, {}).join(QLatin1Char(' '));
    m_parts.messages.showMessage(MessageKind::warning,
                                 tr("What was kept of an unsaved session is damaged and was put aside. %1")
                                     .arg(m_parts.names.shownOfFile(sentences)),
                                 MessageEnd::withStudy(damagedTopic));
}

/// What a person has put away with its message is not offered again, neither now nor at the next start.
void LeftUnsaved::putAway(const QString& topic) {
    if (topic != QLatin1String(leftTopic)) return;
    QStringList put = m_parts.settings.leftSessionsPutAway();
    for (const QString& file : std::as_const(m_offered)) put << QFileInfo(file).fileName();
    put.removeDuplicates();
    m_parts.settings.setLeftSessionsPutAway(put);
}

QString LeftUnsaved::nameOf(const Leftover& left) const {
    return left.study.isEmpty() ? tr("the simulated scan") : m_parts.names.nameOf(left.study);
}

QString LeftUnsaved::timeOf(const Leftover& left) {
    return QLocale::c().toString(left.time, QStringLiteral("d MMM, HH:mm"));
}

void LeftUnsaved::fillMenu(QMenu& menu) {
    for (QMenu* each : menu.findChildren<QMenu*>(Qt::FindDirectChildrenOnly)) delete each;
    menu.clear();
    int place = 0;
    for (const Leftover& left : m_list) {
        ++place;
        QMenu* of = menu.addMenu(literalMenuText(QStringLiteral("%1, %2").arg(nameOf(left), timeOf(left))));
        of->setObjectName(QStringLiteral("file.leftUnsaved.%1").arg(place));
        QAction* open = of->addAction(tr("&Open"));
        open->setObjectName(of->objectName() + QStringLiteral(".open"));
        QAction* discard = of->addAction(tr("&Discard"));
        discard->setObjectName(of->objectName() + QStringLiteral(".discard"));
        connect(open, &QAction::triggered, this, [this, file = left.file] { this->open(file); });
        connect(discard, &QAction::triggered, this, [this, file = left.file] { this->discard(file); });
    }
}

}  // namespace echolucent
