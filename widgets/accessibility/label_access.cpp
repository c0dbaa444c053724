#include "widgets/accessibility/label_access.h"

#include <QLabel>
#include <QTextDocumentFragment>

namespace echolucent {

LabelAccess::LabelAccess(QLabel& label) : QAccessibleWidget(&label, QAccessible::StaticText), m_label(label) {}

QString LabelAccess::text(QAccessible::Text kind) const {
    if (kind != QAccessible::Name) return QAccessibleWidget::text(kind);
    const bool isRich = m_label.textFormat() == Qt::RichText ||
                        (m_label.textFormat() == Qt::AutoText && Qt::mightBeRichText(m_label.text()));
    const QString says = isRich ? QTextDocumentFragment::fromHtml(m_label.text()).toPlainText() : m_label.text();
    const QString name = m_label.accessibleName();
    if (name.isEmpty() || says.isEmpty()) return name + says;
    return name + QStringLiteral(": ") + says;
}

QAccessible::State LabelAccess::state() const {
    QAccessible::State state = QAccessibleWidget::state();
    state.readOnly = true;
    return state;
}

}  // namespace echolucent
