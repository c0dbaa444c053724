#include "widgets/controls/message_bar.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWindow>
#include <algorithm>
#include <utility>

#include "widgets/controls/panel_controls.h"
#include "widgets/theme_colours.h"

namespace echolucent {
namespace {

constexpr int signWidth = 40;    // the coloured stripe and the sign beside it
constexpr int gapToPicture = 8;  // pixels of picture that stay free below the bar and, at least, beside it
constexpr int leastTextWidth = 160;
constexpr int leastWidth = 480;   // the bar may be so wide even over the picture's corners
constexpr int cornerWidth = 142;  // of the orientation marker and scale bar, beside which the bar stays if it can

QLabel* createLine(const QString& name, const QString& accessibleName) {
    auto* label = named(new QLabel, name, accessibleName);
    label->setTextFormat(Qt::PlainText);  // file names may hold anything
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setMinimumWidth(leastTextWidth);
    label->setMinimumHeight(20);  // the height of the sign
    return label;
}

struct Appearance {
    QColor colour;
    QString sign;  // colour alone must not tell the kind
    QString name;
};

Appearance appearanceOf(MessageKind kind, const ThemeColours& colours) {
    switch (kind) {
        case MessageKind::info: return {colours.accent, QStringLiteral("i"), MessageBar::tr("Information")};
        case MessageKind::warning: return {colours.warning, QStringLiteral("!"), MessageBar::tr("Warning")};
        case MessageKind::error: return {colours.error, QStringLiteral("×"), MessageBar::tr("Error")};
    }
    return {};
}

}  // namespace

MessageBar::MessageBar(QWidget* parent)
    : QWidget(parent),
      m_text(createLine("message.text", tr("Message"))),
      m_remarkText(createLine("message.remark", tr("Remark on the picture"))),
      m_actions(new QHBoxLayout),
      m_close(named(new QToolButton, "message.close", tr("Close this message"), tr("Close"))) {
    setObjectName("message");
    m_close->setText(QStringLiteral("✕"));
    m_close->setAutoRaise(true);
    m_close->setFocusPolicy(Qt::StrongFocus);
    connect(m_close, &QToolButton::clicked, this, &MessageBar::closeByPerson);

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(signWidth, 6, 6, 6);
    auto* lines = new QVBoxLayout;
    lines->setSpacing(4);
    lines->addWidget(m_text);
    lines->addWidget(m_remarkText);
    layout->addLayout(lines, 1);
    layout->addLayout(m_actions);
    layout->addWidget(m_close);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    hide();
}

void MessageBar::lieOver(QWidget& picture, Qt::Edge edge) {
    m_picture = &picture;
    m_edge = edge;
    // An OpenGL window covers what Qt draws into its window, but not another native window above it.
    setAttribute(Qt::WA_DontCreateNativeAncestors);
    setAttribute(Qt::WA_NativeWindow);
    for (QWidget* around = &picture; around != nullptr; around = around->parentWidget())
        around->installEventFilter(this);
    place();
}

bool MessageBar::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    if (watched == m_picture && (type == QEvent::Resize || type == QEvent::Move)) place();
    // The picture gets a window of its own only after it is shown, and a click on a dock's tab raises that window. Both
    // would cover the bar, so raise the bar again.
    if (m_picture != nullptr && (type == QEvent::Show || type == QEvent::ZOrderChange))
        QMetaObject::invokeMethod(this, &MessageBar::place, Qt::QueuedConnection);
    return QWidget::eventFilter(watched, event);
}

bool MessageBar::event(QEvent* event) {
    const bool taken = QWidget::event(event);
    if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::StyleChange) place();
    return taken;
}

void MessageBar::place() {
    if (m_picture == nullptr || isHidden()) return;
    const QRect picture(m_picture->mapTo(parentWidget(), QPoint(0, 0)), m_picture->size());
    const int between = picture.width() - 2 * cornerWidth;
    const int widest = std::max(between, std::min(leastWidth, picture.width() - 2 * gapToPicture));
    const int width = std::min(widthOfWords(), widest);
    const int height = layout()->totalHeightForWidth(width);
    const int top = m_edge == Qt::TopEdge ? picture.top() + gapToPicture : picture.bottom() + 1 - gapToPicture - height;
    setGeometry(picture.left() + (picture.width() - width) / 2, top, width, height);
    raise();
    // The widget may already be in front while its window is not.
    if (QWindow* own = windowHandle()) own->raise();
}

/// The width of the bar if each sentence stands on one line.
int MessageBar::widthOfWords() const {
    int words = 0;
    for (const QLabel* line : {m_text, m_remarkText})
        if (!line->isHidden()) words = std::max(words, line->fontMetrics().horizontalAdvance(line->text()) + 4);
    const QMargins margins = layout()->contentsMargins();
    const int buttons = m_actions->sizeHint().width() + m_close->sizeHint().width();
    return margins.left() + words + 2 * layout()->spacing() + buttons + margins.right();
}

void MessageBar::setReading(Reading reading, Reading ofShown) {
    m_reading = std::move(reading);
    m_messageReading = m_remarkReading = std::move(ofShown);
    if (!isHidden()) showText();
}

void MessageBar::showMessage(MessageKind kind, const QString& text, const QList<MessageAction>& actions) {
    removeActions();
    m_kind = kind;
    m_message = text;
    m_messageReading = m_reading;
    for (int i = 0; i < actions.size(); ++i) {
        auto* button =
            named(new QPushButton(actions[i].text), QStringLiteral("message.action.%1").arg(i), actions[i].text);
        connect(button, &QPushButton::clicked, this, [this, run = actions[i].run] {
            const auto chosen = run;  // a copy: closing the bar may delete the button, and `run` with it
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
    m_remarkReading = m_reading;
    m_remarkClosed = false;
    showText();
}

void MessageBar::showText() {
    const auto read = [](const Reading& reading, const QString& sentence) {
        return reading ? reading(sentence) : sentence;
    };
    m_text->setText(read(m_messageReading, m_message));
    m_text->setVisible(!m_message.isEmpty());
    m_remarkText->setText(remarks() ? read(m_remarkReading, m_remark) : QString());
    m_remarkText->setVisible(remarks());
    setAccessibleDescription(text());
    if (text().isEmpty()) {
        hide();
        return;
    }
    setAccessibleName(appearanceOf(kind(), coloursOf(palette())).name);
    show();
    place();
    update();
    QAccessibleEvent alert(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

void MessageBar::takeBack(const QString& text) {
    if (m_message != text) return;
    m_message.clear();
    m_kind = MessageKind::info;
    removeActions();
    showText();
}

void MessageBar::dismiss() {
    hide();
    m_message.clear();
    m_kind = MessageKind::info;
    m_remark.clear();
    m_remarkClosed = false;
    m_text->clear();
    m_remarkText->clear();
    setAccessibleDescription({});
    removeActions();
}

QString MessageBar::text() const {
    QStringList sentences{m_text->text(), m_remarkText->text()};
    sentences.removeAll(QString());
    return sentences.join(QLatin1Char(' '));
}

MessageKind MessageBar::kind() const { return m_message.isEmpty() && remarks() ? MessageKind::warning : m_kind; }

void MessageBar::removeActions() {
    while (QLayoutItem* item = m_actions->takeAt(0)) {
        QWidget* button = item->widget();
        button->hide();
        button->setParent(nullptr);  // so that nobody finds it by name, though it may be the pressed one
        button->deleteLater();
        delete item;
    }
}

void MessageBar::closeByPerson() {
    const QString remark = m_remark;
    dismiss();
    m_remark = remark;
    m_remarkClosed = !remark.isEmpty();
}

void MessageBar::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        closeByPerson();
    } else {
        QWidget::keyPressEvent(event);
    }
}

void MessageBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().color(QPalette::Window));
    const ThemeColours& colours = coloursOf(palette());
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    const auto paintSign = [&](const QLabel* line, MessageKind kind, int top, int bottom) {
        const Appearance appearance = appearanceOf(kind, colours);
        painter.fillRect(QRect(0, top, 4, bottom - top), appearance.colour);
        const QRectF disc(12, line->geometry().center().y() - 8.5, 18, 18);
        painter.setPen(Qt::NoPen);
        painter.setBrush(appearance.colour);
        painter.drawEllipse(disc);
        painter.setPen(colours.onSign);
        painter.drawText(disc, Qt::AlignCenter, appearance.sign);
    };
    const bool message = !m_text->isHidden();
    const int border = message ? m_text->geometry().bottom() + 3 : 0;
    if (message) paintSign(m_text, m_kind, 0, remarks() ? border : height());
    if (remarks()) paintSign(m_remarkText, MessageKind::warning, border, height());
}

}  // namespace echolucent
