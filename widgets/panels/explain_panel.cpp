#include "widgets/panels/explain_panel.h"

#include <QLabel>
#include <QVBoxLayout>
#include <utility>

#include "widgets/controls/panel_controls.h"
#include "widgets/key_table.h"

namespace echolucent {

namespace {

/// The gestures and keys of each place; keys stand before their meanings.
QString keysText() {
    QString text;
    for (const KeyPlace place : allKeyPlaces) {
        text += QStringLiteral("<p><b>%1</b></p><table cellspacing='0' cellpadding='2'>").arg(titleOf(place));
        for (const KeyRow& row : keyTable())
            if (row.place == place)
                text += QStringLiteral("<tr><td width='112'>%1</td><td>%2</td></tr>")
                            .arg(row.keys.toHtmlEscaped(), row.meaning.toHtmlEscaped());
        text += QStringLiteral("</table>");
    }
    return text;
}

QLabel* createText(const QString& name, const QString& accessibleName, Qt::TextFormat format) {
    auto* label = named(new QLabel, name, accessibleName);
    label->setTextFormat(format);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    return label;
}

}  // namespace

ExplainPanel::ExplainPanel(QWidget* parent)
    : QWidget(parent), m_picture(createText("explain.picture", tr("What the picture shows, and why"), Qt::PlainText)) {
    setObjectName("explain");
    setAccessibleName(tr("Explain"));
    auto* keys = createText("explain.keys", tr("Gestures and keys"), Qt::RichText);
    keys->setText(keysText());
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(12);
    layout->addWidget(m_picture);
    layout->addWidget(keys);
    layout->addStretch(1);
}

void ExplainPanel::setSource(std::function<QString()> explanation) {
    m_explanation = std::move(explanation);
    follow();
}

void ExplainPanel::follow() {
    if (isVisible() && m_explanation) m_words.tell();
}

void ExplainPanel::tell() {
    if (m_explanation) m_picture->setText(m_explanation());
}

void ExplainPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    m_words.tellNow();
}

}  // namespace echolucent
