#include "widgets/dialogs/series_dialog.h"

#include <QDialogButtonBox>
#include <QIcon>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/controls/panel_controls.h"
#include "widgets/controls/secondary_items.h"

namespace echolucent {

namespace {

/// Puts a picture in the middle of a dark square, so that all rows look alike.
QIcon onSquare(const QImage& picture) {
    QPixmap square(SeriesDialog::pictureEdge, SeriesDialog::pictureEdge);
    square.fill(Qt::black);
    if (!picture.isNull()) {
        const QImage fitted = picture.scaled(square.size(), Qt::KeepAspectRatio, Qt::SmoothTransformation);
        QPainter(&square).drawImage((square.width() - fitted.width()) / 2, (square.height() - fitted.height()) / 2,
                                    fitted);
    }
    QIcon icon(square);
    icon.addPixmap(square, QIcon::Selected);  // else Qt would tint it in the selected row
    return icon;
}

}  // namespace

SeriesDialog::SeriesDialog(const QString& source, const QList<SeriesRow>& rows, QWidget* parent)
    : QDialog(parent),
      m_rows(rows),
      m_list(named(new QListWidget, "series.list", tr("Series"))),
      m_why(named(new QLabel, "series.why", tr("What stands against opening the series"))) {
    setObjectName("series");
    setAccessibleName(tr("Choice of a series"));
    setWindowTitle(tr("Several series"));
    auto* head =
        new QLabel(tr("%1 holds %2 series. Which one is to be opened?").arg(source, QString::number(rows.size())));
    head->setTextFormat(Qt::PlainText);  // folder names may hold anything
    head->setWordWrap(true);
    m_list->setIconSize({pictureEdge, pictureEdge});
    m_list->setItemDelegate(new SecondaryItemDelegate(m_list));
    m_list->setWordWrap(true);
    m_list->setSpacing(2);
    for (const SeriesRow& row : rows) {
        auto* item = new QListWidgetItem(onSquare({}), row.title + '\n' + row.facts, m_list);
        item->setToolTip(literalToolTip(row.hindrance.isEmpty() ? row.title : row.hindrance));
        item->setData(secondaryRole, !row.openable);
    }
    m_why->setTextFormat(Qt::PlainText);
    m_why->setWordWrap(true);
    // Keep two lines for the reason, so that the list does not jump.
    m_why->setMinimumHeight(2 * m_why->fontMetrics().lineSpacing());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
    m_open = named(buttons->button(QDialogButtonBox::Open), "series.open", tr("Open the series"));
    named(buttons->button(QDialogButtonBox::Cancel), "series.cancel", tr("Cancel"));
    for (QAbstractButton* button : buttons->buttons()) button->setIcon({});

    auto* layout = new QVBoxLayout(this);
    layout->addWidget(head);
    layout->addWidget(m_list, 1);
    layout->addWidget(m_why);
    layout->addWidget(buttons);
    resize(560, 480);
    connect(m_list, &QListWidget::currentRowChanged, this, &SeriesDialog::showSelected);
    connect(m_list, &QListWidget::itemDoubleClicked, this, &SeriesDialog::openSelected);
    connect(m_open, &QPushButton::clicked, this, &SeriesDialog::openSelected);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    const auto first = std::find_if(m_rows.begin(), m_rows.end(), [](const SeriesRow& row) { return row.openable; });
    m_list->setCurrentRow(first == m_rows.end() ? 0 : static_cast<int>(first - m_rows.begin()));
    m_list->setFocus();
}

int SeriesDialog::selected() const { return m_list->currentRow(); }

void SeriesDialog::setPicture(int row, const QImage& picture) { m_list->item(row)->setIcon(onSquare(picture)); }

void SeriesDialog::showSelected() {
    const SeriesRow& row = m_rows.at(selected());
    m_why->setText(row.hindrance);
    m_open->setEnabled(row.openable);
}

void SeriesDialog::openSelected() {
    if (m_open->isEnabled()) accept();
}

}  // namespace echolucent
