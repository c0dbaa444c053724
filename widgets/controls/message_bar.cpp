#include "widgets/controls/message_bar.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
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
        case MessageKind::error: return {colours.warning, QStringLiteral("×"), MessageBar::tr("Error")};
    }
    return {};
}

}  // namespace

MessageBar::MessageBar(QWidget* parent)
    : OverPicture(parent),
      m_text(createLine("message.text", tr("Message"))),
      m_remarkText(createLine("message.remark", tr("Remark on the picture"))),
      m_actions(new QHBoxLayout),
      m_close(named(new QToolButton, "message.close", tr("Close this message"), tr("Close"))) {
    setObjectName("message");
    m_close->setText(QStringLiteral("✕"));
    m_close->setAutoRaise(true);
    m_close->setFocusPolicy(Qt::StrongFocus);
    connect(m_close, &QToolButton::clicked, this, &MessageBar::closeByPerson);
    m_leaves.setSingleShot(true);
    connect(&m_leaves, &QTimer::timeout, this, [this] {
        if (isHeld()) return countDown();
        removeIf([](const Message& message) { return message.end.when == MessageEnd::When::soon; });
    });

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
    m_edge = edge;
    setPicture(picture);
}

QRect MessageBar::placeOver(const QRect& picture) const {
    const int between = picture.width() - 2 * cornerWidth;
    const int widest = std::max(between, std::min(leastWidth, picture.width() - 2 * gapToPicture));
    const int width = std::min(widthOfWords(), widest);
    const int height = layout()->totalHeightForWidth(width);
    const int top = m_edge == Qt::TopEdge ? picture.top() + gapToPicture : picture.bottom() + 1 - gapToPicture - height;
    return {picture.left() + (picture.width() - width) / 2, top, width, height};
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
    for (Message& message : m_messages) message.reading = ofShown;
    m_remarkReading = std::move(ofShown);
    if (!isHidden()) showText();
}

void MessageBar::showMessage(MessageKind kind, const QString& text, const MessageEnd& end,
                             const QList<MessageAction>& actions) {
    std::erase_if(m_messages, [&](const Message& before) {
        return before.end.when == MessageEnd::When::soon || (!end.topic.isEmpty() && before.end.topic == end.topic);
    });
    m_messages.push_back({kind, text, end, actions, m_reading});
    showNewest();
}

/// Removes messages. If the one that is shown is among them, the one below it is seen.
template <typename Condition>
void MessageBar::removeIf(Condition condition) {
    const bool seen = shown() != nullptr && condition(*shown());
    std::erase_if(m_messages, condition);
    if (seen) showNewest();
}

void MessageBar::showNewest() {
    removeActions();
    makeActions();
    countDown();
    showText();
}

void MessageBar::makeActions() {
    if (shown() == nullptr) return;
    const QList<MessageAction>& actions = shown()->actions;
    for (int i = 0; i < actions.size(); ++i) {
        auto* button =
            named(new QPushButton(actions[i].text), QStringLiteral("message.action.%1").arg(i), actions[i].text);
        connect(button, &QPushButton::clicked, this, [this, run = actions[i].run] {
            const auto chosen = run;  // a copy: the button, and `run` with it, may be deleted
            m_messages.pop_back();    // the shown one, which this answers
            showNewest();
            if (chosen) chosen();
        });
        m_actions->addWidget(button);
    }
}

void MessageBar::countDown() {
    m_leaves.stop();
    if (shown() != nullptr && shown()->end.when == MessageEnd::When::soon)
        m_leaves.start(shown()->actions.isEmpty() ? m_confirmation : 2 * m_confirmation);
}

/// Whether a person reads the message or is about to act on it.
bool MessageBar::isHeld() const {
    const QWidget* focused = focusWidget();
    return underMouse() || (focused != nullptr && focused->hasFocus());
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
    const Message* message = shown();
    m_text->setText(message != nullptr ? read(message->reading, message->text) : QString());
    m_text->setVisible(message != nullptr);
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

void MessageBar::takeBack(const QString& topic) {
    removeIf([&](const Message& message) { return !topic.isEmpty() && message.end.topic == topic; });
}

void MessageBar::endStudy() {
    removeIf([](const Message& message) { return message.end.when == MessageEnd::When::withStudy; });
}

void MessageBar::dismiss() {
    hide();
    m_messages.clear();
    m_leaves.stop();
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

MessageKind MessageBar::kind() const {
    if (shown() != nullptr) return shown()->kind;
    return remarks() ? MessageKind::warning : MessageKind::info;
}

void MessageBar::removeActions() {
    while (QLayoutItem* item = m_actions->takeAt(0)) {
        QWidget* button = item->widget();
        button->hide();
        button->setParent(nullptr);  // so that nobody finds it by name, though it may be the pressed one
        button->deleteLater();
        delete item;
    }
}

/// Good news that lies over trouble goes alone: nobody has read the trouble. Else all that is there is put away,
/// because nobody wants to close one thing twice.
void MessageBar::closeByPerson() {
    const auto isSoon = [](const Message& message) { return message.end.when == MessageEnd::When::soon; };
    if (shown() != nullptr && isSoon(*shown()) && !std::ranges::all_of(m_messages, isSoon)) {
        const QString closed = shown()->end.topic;
        removeIf(isSoon);
        emit putAway(closed);
        return;
    }
    const QString remark = m_remark;
    const QString topic = shown() != nullptr ? shown()->end.topic : QString();
    dismiss();
    m_remark = remark;
    m_remarkClosed = !remark.isEmpty();
    emit putAway(topic);
}

void MessageBar::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        closeByPerson();
    } else {
        OverPicture::keyPressEvent(event);
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
    if (message) paintSign(m_text, kind(), 0, remarks() ? border : height());
    if (remarks()) paintSign(m_remarkText, MessageKind::warning, border, height());
}

}  // namespace echolucent
