#include "widgets/controls/opening_label.h"

#include <QLabel>
#include <QPainter>
#include <QProgressBar>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/controls/panel_controls.h"
#include "widgets/controls/value_text.h"
#include "widgets/theme_colours.h"

namespace echolucent {

namespace {

constexpr int widestLabel = 420, gapBeside = 12;  // logical pixels

QLabel* createText(const QString& name, const QString& accessibleName) {
    auto* label = named(new QLabel, name, accessibleName);
    label->setTextFormat(Qt::PlainText);  // file names may hold anything
    label->setAlignment(Qt::AlignHCenter);
    return label;
}

}  // namespace

OpeningLabel::OpeningLabel(QWidget* parent)
    : OverPicture(parent),
      m_name(createText("opening.name", tr("Study that is being opened"))),
      m_activity(createText("opening.activity", tr("What is done to open it"))),
      m_progress(named(new QProgressBar, "opening.progress", tr("Progress of the opening"))) {
    setObjectName("opening");
    setAccessibleName(tr("Opening of a study"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    QFont bold = font();
    bold.setBold(true);
    m_name->setFont(bold);
    m_progress->setTextVisible(false);
    m_progress->setMaximumHeight(8);
    m_progress->setRange(0, 0);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 12, 16, 12);
    column->setSpacing(6);
    column->addWidget(m_name);
    column->addWidget(m_activity);
    column->addWidget(m_progress);
    hide();
}

void OpeningLabel::setName(const QString& name) {
    m_whole = name;
    setAccessibleDescription(name);
    m_name->setText(m_name->fontMetrics().elidedText(name, Qt::ElideMiddle, widestLabel - 2 * 16));
    place();
}

void OpeningLabel::setActivity(const QString& words) {
    if (words == m_activity->text()) return;
    m_activity->setText(words);
    m_progress->setRange(0, 0);  // until the share is known
}

void OpeningLabel::setShare(double share) { showShare(m_progress, share); }

QRect OpeningLabel::placeOver(const QRect& picture) const {
    const int width = std::min(widestLabel, picture.width() - 2 * gapBeside);
    const int height = sizeHint().height();
    return {picture.left() + (picture.width() - width) / 2, picture.top() + (picture.height() - height) / 2, width,
            height};
}

void OpeningLabel::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Window));
    painter.fillRect(0, 0, width(), 2, coloursOf(palette()).accent);
}

}  // namespace echolucent
