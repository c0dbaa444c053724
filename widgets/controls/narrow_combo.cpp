#include "widgets/controls/narrow_combo.h"

#include <QAbstractItemView>
#include <QScrollBar>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <algorithm>

#include "widgets/controls/panel_controls.h"

namespace echolucent {

namespace {

constexpr int leastCharacters = 8;
constexpr int besideWords = 2;  // pixels that styles leave on either side

QString wholeWords(const QString& text, const QFontMetrics& metrics, int room) {
    if (metrics.horizontalAdvance(text) <= room) return text;
    QString shown;
    for (qsizetype end = text.indexOf(QLatin1Char(' ')); end > 0; end = text.indexOf(QLatin1Char(' '), end + 1)) {
        const QString longer = text.left(end) + QChar(0x2026);
        if (metrics.horizontalAdvance(longer) > room) break;
        shown = longer;
    }
    return shown.isEmpty() ? metrics.elidedText(text, Qt::ElideRight, room) : shown;
}

}  // namespace

NarrowCombo::NarrowCombo(QWidget* parent) : QComboBox(parent) {
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(leastCharacters);
    wheelNeedsFocus(this);
}

QString NarrowCombo::shownText() const {
    QStyleOptionComboBox option;
    QComboBox::initStyleOption(&option);
    const QRect field = style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this);
    return wholeWords(currentText(), fontMetrics(), field.width() - 2 * besideWords);
}

void NarrowCombo::showPopup() {
    const int beside = view()->verticalScrollBar()->sizeHint().width() + 2 * view()->frameWidth();
    view()->setMinimumWidth(std::max(width(), view()->sizeHintForColumn(0) + beside));
    QComboBox::showPopup();
}

void NarrowCombo::initStyleOption(QStyleOptionComboBox* option) const {
    QComboBox::initStyleOption(option);
    option->currentText = shownText();
}

}  // namespace echolucent
