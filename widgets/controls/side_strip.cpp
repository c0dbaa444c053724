#include "widgets/controls/side_strip.h"

#include <QBoxLayout>
#include <QPainter>
#include <QPixmap>
#include <QToolButton>
#include <algorithm>

#include "widgets/controls/panel_controls.h"

namespace echolucent {

namespace {

// Logical pixels.
constexpr int pictureWidth = 104, mostPictureHeight = 68, leastPictureHeight = 24, leastPictureWidth = 40;
constexpr int levelPictureHeight = 46;

}  // namespace

SideStrip::SideStrip(QWidget* parent) : QWidget(parent) {
    named(this, QStringLiteral("sides"), tr("Sides of the scan"));
    auto* buttons = new QBoxLayout(QBoxLayout::TopToBottom, this);
    buttons->setContentsMargins(2, 2, 2, 2);
    buttons->setSpacing(2);
    for (std::size_t i = 0; i < count; ++i) {
        auto* button = new QToolButton;
        button->setObjectName(QStringLiteral("sides.picture%1").arg(i + 1));
        button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        m_buttons[i] = button;
        setPicture(i, {});
        buttons->addWidget(button);
    }
    buttons->addStretch(1);
    setOrientation(Qt::Vertical);
}

QBoxLayout& SideStrip::row() { return *static_cast<QBoxLayout*>(layout()); }

void SideStrip::setOrientation(Qt::Orientation orientation) {
    m_orientation = orientation;
    const bool upright = orientation == Qt::Vertical;
    row().setDirection(upright ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    upright ? setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Ignored)
            : setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    // Its width is the same whatever its labels say, so that the picture beside it stays in place.
    const int text = fontMetrics().horizontalAdvance(tr("3 Onto scan plane"));
    constexpr int frames = 14;
    const int width = std::max(pictureWidth, text) + frames;
    setMinimumWidth(upright ? width : 0);
    setMaximumWidth(upright ? width : QWIDGETSIZE_MAX);
    fit();
}

void SideStrip::setActions(const std::array<QAction*, count>& actions) {
    for (std::size_t i = 0; i < count; ++i) {
        QToolButton* button = m_buttons[i];
        const QAction* action = actions[i];
        connect(button, &QToolButton::clicked, actions[i], &QAction::trigger);
        const auto follow = [button, action] {
            button->setText(action->iconText());
            button->setToolTip(action->toolTip());
            button->setAccessibleName(action->text().remove(QLatin1Char('&')));
            button->setEnabled(action->isEnabled());
            button->setCheckable(action->isCheckable());
            button->setChecked(action->isChecked());
        };
        connect(action, &QAction::changed, button, follow);
        // A click on the side that is taken already leaves it taken.
        connect(button, &QToolButton::clicked, button, follow);
        follow();
    }
}

void SideStrip::setPicture(std::size_t side, const QImage& picture) {
    QPixmap pixmap = QPixmap::fromImage(picture);
    if (pixmap.isNull()) {
        pixmap = QPixmap(2 * pictureWidth, 2 * mostPictureHeight);
        pixmap.fill(Qt::black);
    }
    QIcon icon(pixmap);
    // A picture of the study that is left is dimmed like the 3D view, not made grey.
    QPainter(&pixmap).fillRect(pixmap.rect(), QColor(0, 0, 0, 160));
    icon.addPixmap(pixmap, QIcon::Disabled);
    m_buttons.at(side)->setIcon(icon);
}

/// Makes the pictures as large as six of them fit.
void SideStrip::fit() {
    const QToolButton* first = m_buttons.front();
    const QSize around = first->sizeHint() - first->iconSize();
    const int margins = 2 * row().contentsMargins().top(), spacing = row().spacing();
    QSize size(pictureWidth, levelPictureHeight);
    if (m_orientation == Qt::Vertical) {
        const int each = (height() - margins) / static_cast<int>(count) - around.height() - spacing;
        size.setHeight(std::clamp(each, leastPictureHeight, mostPictureHeight));
    } else {
        constexpr int frames = 12;  // a longer label may be wider than its picture
        const int each = (width() - margins) / static_cast<int>(count) - frames - spacing;
        size.setWidth(std::clamp(each, leastPictureWidth, pictureWidth));
    }
    for (QToolButton* button : m_buttons) button->setIconSize(size);
}

void SideStrip::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fit();
}

void SideStrip::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    emit seenChanged(true);
}

void SideStrip::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    emit seenChanged(false);
}

}  // namespace echolucent
