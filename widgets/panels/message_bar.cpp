#include "widgets/panels/message_bar.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>

#include "widgets/panels/panel_controls.h"

namespace echolucent {
namespace {

constexpr int signWidth = 40;  // the coloured stripe and the sign beside it

struct Appearance {
    QColor colour;
    QString sign;  // so that the kind is not told by colour alone
    QString name;
};

Appearance appearanceOf(MessageKind kind) {
    switch (kind) {
        case MessageKind::info: return {QColor(0x4f, 0xb3, 0xbf), QStringLiteral("i"), MessageBar::tr("Information")};
        case MessageKind::warning: return {QColor(0xe8, 0xb0, 0x4b), QStringLiteral("!"), MessageBar::tr("Warning")};
        case MessageKind::error: return {QColor(0xe0, 0x7a, 0x72), QStringLiteral("×"), MessageBar::tr("Error")};
    }
    return {};
}

}  // namespace

MessageBar::MessageBar(QWidget* parent)
    : QWidget(parent),
      m_text(named(new QLabel, "message.text", tr("Message"))),
      m_actions(new QHBoxLayout),
      m_close(named(new QToolButton, "message.close", tr("Close this message"), tr("Close"))) {
    setObjectName("message");
    m_text->setTextFormat(Qt::PlainText);  // file names may hold anything
    m_text->setWordWrap(true);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_text->setMinimumWidth(160);
    m_close->setText(QStringLiteral("✕"));
    m_close->setAutoRaise(true);
    m_close->setFocusPolicy(Qt::StrongFocus);
    connect(m_close, &QToolButton::clicked, this, &MessageBar::closeByPerson);

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(signWidth, 6, 6, 6);
    layout->addWidget(m_text, 1);
    layout->addLayout(m_actions);
    layout->addWidget(m_close);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    hide();
}

void MessageBar::showMessage(MessageKind kind, const QString& text, const QList<MessageAction>& actions) {
    removeActions();
    m_messageKind = kind;
    m_message = text;
    for (int i = 0; i < actions.size(); ++i) {
        auto* button =
            named(new QPushButton(actions[i].text), QStringLiteral("message.action.%1").arg(i), actions[i].text);
        connect(button, &QPushButton::clicked, this, [this, run = actions[i].run] {
            const auto chosen = run;  // the button, and run with it, may be gone once the bar has closed
            closeByPerson();
            if (chosen) chosen();
        });
        m_actions->addWidget(button);
    }
    showText();
}

void MessageBar::setRemark(const QString& sentence) {
    if (sentence == m_remark) return;
    m_remark = sentence;
    m_remarkClosed = false;
    showText();
}

void MessageBar::showText() {
    QStringList sentences{m_message};
    if (!m_remarkClosed) sentences << m_remark;
    sentences.removeAll(QString());
    if (sentences.isEmpty()) {
        hide();
        m_text->clear();
        return;
    }
    const bool remarked = !m_remarkClosed && !m_remark.isEmpty();
    m_kind = remarked && m_messageKind == MessageKind::info ? MessageKind::warning : m_messageKind;
    const QString text = sentences.join(QLatin1Char(' '));
    m_text->setText(text);
    setAccessibleName(appearanceOf(m_kind).name);
    setAccessibleDescription(text);
    show();
    update();
    QAccessibleEvent alert(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

void MessageBar::takeBack(const QString& text) {
    if (m_message != text) return;
    m_message.clear();
    m_messageKind = MessageKind::info;
    removeActions();
    showText();
}

void MessageBar::dismiss() {
    hide();
    m_message.clear();
    m_messageKind = MessageKind::info;
    m_remark.clear();
    m_remarkClosed = false;
    m_text->clear();
    removeActions();
}

QString MessageBar::text() const { return m_text->text(); }

void MessageBar::removeActions() {
    while (QLayoutItem* item = m_actions->takeAt(0)) {
        QWidget* button = item->widget();
        button->hide();
        button->setParent(nullptr);  // not found by name any more, though it may be the one just pressed
        button->deleteLater();
        delete item;
    }
}

void MessageBar::closeByPerson() {
    const QString remark = m_remark;
    dismiss();
    m_remark = remark;
    m_remarkClosed = !remark.isEmpty();
    emit closed();
}

void MessageBar::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        closeByPerson();
    } else {
        QWidget::keyPressEvent(event);
    }
}

void MessageBar::paintEvent(QPaintEvent*) {
    const Appearance appearance = appearanceOf(m_kind);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().color(QPalette::Window));
    painter.fillRect(QRect(0, 0, 4, height()), appearance.colour);
    const QRectF disc(12, height() / 2.0 - 9, 18, 18);
    painter.setPen(Qt::NoPen);
    painter.setBrush(appearance.colour);
    painter.drawEllipse(disc);
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    painter.setPen(Qt::black);
    painter.drawText(disc, Qt::AlignCenter, appearance.sign);
}

}  // namespace echolucent
