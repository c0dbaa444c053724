#include "widgets/compare/compare_table.h"

#include <QApplication>
#include <QClipboard>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/controls/panel_controls.h"
#include "widgets/fitted_table.h"

namespace echolucent {

CompareTable::CompareTable(QWidget* parent) : QGroupBox(tr("Measured"), parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->addWidget(m_table = makeTable());
    column->addWidget(m_note = secondaryLabel({}));
    m_note->setObjectName("compare.note");
    m_note->setAccessibleName(tr("Note on the measures"));
    m_note->setWordWrap(true);
    column->addLayout(makeButtons());
    sayWhichSurfaces();
}

FittedTable* CompareTable::makeTable() {
    const QStringList columns = compareColumns().mid(1), tips = compareTips().mid(1);
    auto* table = named(new FittedTable(columns), "compare.table", tr("Table of the comparison"),
                        tr("Rows are panes. Each heading says what its column asks."));
    for (int i = 0; i < columns.size(); ++i) {
        // The unit stands in a line of its own: the column of docks is narrow.
        auto* heading = new QTableWidgetItem(QString(columns[i]).replace(QLatin1Char(' '), QLatin1Char('\n')));
        heading->setToolTip(tips[i]);
        table->setHorizontalHeaderItem(i, heading);
    }
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setMinimumSectionSize(20);
    table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    table->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    table->fit();
    return table;
}

QLayout* CompareTable::makeButtons() {
    m_flicker = named(new QPushButton(tr("Measure flicker")), "compare.measureFlicker", tr("Measure flicker"),
                      flickerSentences());
    auto* text = named(new QPushButton(tr("Copy as text")), "compare.copyText", tr("Copy the table as text"));
    auto* csv = named(new QPushButton(tr("Copy as CSV")), "compare.copyCsv", tr("Copy the table as CSV"));
    auto* page = named(new QPushButton(tr("Save page…")), "compare.savePage", tr("Save the comparison as a page"),
                       tr("One HTML file that opens without a network"));
    connect(m_flicker, &QPushButton::clicked, this, [this] {
        m_flickerAskedFor = true;
        emit flickerRequested();
    });
    connect(text, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(compareText(m_rows)); });
    connect(csv, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(compareCsv(m_rows)); });
    connect(page, &QPushButton::clicked, this, &CompareTable::pageRequested);
    auto* buttons = new QGridLayout;
    buttons->addWidget(m_flicker, 0, 0);
    buttons->addWidget(page, 0, 1);
    buttons->addWidget(text, 1, 0);
    buttons->addWidget(csv, 1, 1);
    return buttons;
}

void CompareTable::setMeasuringFlicker(bool measuring, bool anyPane) {
    enableOrSayWhy(*m_flicker, !measuring && anyPane,
                   measuring ? tr("It is being measured.") : tr("Nothing is compared."));
    if (!measuring) showFlickerAskedFor();  // the same numbers again bring no new rows
}

/// Scrolls to the column, which a narrow panel hides.
void CompareTable::showFlickerAskedFor() {
    if (!m_flickerAskedFor ||
        std::ranges::none_of(m_rows, [](const CompareRow& row) { return row.flicker.has_value(); }))
        return;
    m_flickerAskedFor = false;
    m_table->scrollTo(m_table->model()->index(0, flickerColumn - 1));
}

void CompareTable::setRows(const std::vector<CompareRow>& rows) {
    if (rows == m_rows && m_table->rowCount() == static_cast<int>(rows.size())) return;
    m_rows = rows;
    m_table->setRowCount(static_cast<int>(rows.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const QStringList cells = cellsOf(rows[static_cast<std::size_t>(row)]);
        for (int column = 0; column + 1 < cells.size(); ++column) {
            auto* item = new QTableWidgetItem(cells[column + 1]);
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            item->setToolTip(cells[0]);
            m_table->setItem(row, column, item);
        }
    }
    m_table->fit();
    sayWhichSurfaces();
    showFlickerAskedFor();
}

void CompareTable::sayWhichSurfaces() {
    m_note->setText((tr("Rows are panes. ") + surfacesSentence(m_rows)).trimmed());
}

}  // namespace echolucent
