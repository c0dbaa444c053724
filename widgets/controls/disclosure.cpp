#include "widgets/controls/disclosure.h"

#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/controls/panel_controls.h"

namespace echolucent {

Disclosure::Disclosure(const QString& objectName, const QString& text, const QString& toolTip, QWidget* content,
                       QWidget* parent)
    : QWidget(parent), m_button(named(new QToolButton, objectName, text, toolTip)) {
    m_button->setText(text);
    m_button->setCheckable(true);
    m_button->setAutoRaise(true);
    m_button->setFocusPolicy(Qt::StrongFocus);
    m_button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_button->setArrowType(Qt::RightArrow);
    content->hide();
    connect(m_button, &QToolButton::toggled, this, [this, content](bool open) {
        m_button->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
        content->setVisible(open);
        emit opened(open);
    });
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_button, 0, Qt::AlignLeft);
    column->addWidget(content);
}

bool Disclosure::isOpen() const { return m_button->isChecked(); }

}  // namespace echolucent
