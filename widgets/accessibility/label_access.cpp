#include "widgets/accessibility/label_access.h"

#include <QLabel>
#include <QTextDocumentFragment>

namespace echolucent {

LabelAccess::LabelAccess(QLabel& label) : QAccessibleWidget(&label, QAccessible::StaticText), m_label(label) {}

QAccessible::Role LabelAccess::role() const {
    return m_label.pixmap().isNull() ? QAccessible::StaticText : QAccessible::Graphic;
}

QString LabelAccess::text(QAccessible::Text kind) const {
    if (kind != QAccessible::Name) return QAccessibleWidget::text(kind);
    const bool isRich = m_label.textFormat() == Qt::RichText ||
                        (m_label.textFormat() == Qt::AutoText && Qt::mightBeRichText(m_label.text()));
    QString says = isRich ? QTextDocumentFragment::fromHtml(m_label.text()).toPlainText() : m_label.text();
    if (m_label.buddy() != nullptr) says.remove(u'&');  // it marks a key
    const QString name = m_label.accessibleName();
    if (name.isEmpty() || says.isEmpty()) return name + says;
    return name + QStringLiteral(": ") + says;
}

QList<QPair<QAccessibleInterface*, QAccessible::Relation>> LabelAccess::relations(QAccessible::Relation match) const {
    auto relations = QAccessibleWidget::relations(match);
    if (match.testFlag(QAccessible::Labelled) && m_label.buddy() != nullptr)
        relations.append({QAccessible::queryAccessibleInterface(m_label.buddy()), QAccessible::Labelled});
    return relations;
}

QAccessible::State LabelAccess::state() const {
    QAccessible::State state = QAccessibleWidget::state();
    state.readOnly = true;
    return state;
}

}  // namespace echolucent
