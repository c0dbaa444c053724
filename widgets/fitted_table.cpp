#include "widgets/fitted_table.h"

#include <QEvent>
#include <QHeaderView>
#include <QScrollBar>

#include "widgets/larger_letters.h"

namespace echolucent {

FittedTable::FittedTable(const QStringList& headings, int rowHeight, QWidget* parent)
    : QTableWidget(0, static_cast<int>(headings.size()), parent),
      m_rowHeight(rowHeight > 0 ? rowHeight : verticalHeader()->defaultSectionSize()) {
    setHorizontalHeaderLabels(headings);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setTabKeyNavigation(false);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    horizontalHeader()->installEventFilter(this);
    fit();
}

void FittedTable::fit() {
    verticalHeader()->setDefaultSectionSize(inLettersOf(*this, m_rowHeight));
    int high = horizontalHeader()->sizeHint().height() + 2 * frameWidth();
    if (horizontalScrollBarPolicy() != Qt::ScrollBarAlwaysOff) high += horizontalScrollBar()->sizeHint().height();
    for (int row = 0; row < rowCount(); ++row) high += rowHeight(row);
    setFixedHeight(high);
}

void FittedTable::changeEvent(QEvent* event) {
    QTableWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) fit();
}

/// The headings get their letters after the table.
bool FittedTable::eventFilter(QObject* watched, QEvent* event) {
    if (watched == horizontalHeader() && event->type() == QEvent::FontChange)
        QMetaObject::invokeMethod(this, &FittedTable::fit, Qt::QueuedConnection);
    return QTableWidget::eventFilter(watched, event);
}

}  // namespace echolucent
