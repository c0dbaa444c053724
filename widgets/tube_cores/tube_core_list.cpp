#include "widgets/tube_cores/tube_core_list.h"

#include <QEvent>
#include <QHeaderView>
#include <QLocale>
#include <QPainter>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>
#include <algorithm>
#include <utility>

#include "widgets/controls/panel_controls.h"
#include "widgets/larger_letters.h"
#include "widgets/tube_cores/tube_core_map.h"
#include "widgets/tube_cores/tube_core_words.h"

namespace echolucent {

namespace {

/// Paints a state as its sign: the column is too narrow for the words.
class SignDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        QStyledItemDelegate::paint(painter, option, index);
        const double side = 13.0 * (option.widget != nullptr ? lettersOf(*option.widget) : 1.0);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        paintTubeCoreSign(*painter,
                          QRectF(QRectF(option.rect).center() - QPointF(side, side) / 2.0, QSizeF(side, side)),
                          static_cast<TubeState>(index.data(Qt::UserRole).toInt()),
                          index.data(TubeCoreListModel::shareRole).toDouble(), coloursOf(option.palette));
        painter->restore();
    }

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        option->text.clear();
    }
};

}  // namespace

void TubeCoreListModel::setRun(std::shared_ptr<const AdaptiveOtf> run) {
    beginResetModel();
    m_run = std::move(run);
    m_states = TubeCoreStates(m_run.get());
    endResetModel();
}

int TubeCoreListModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_states.states.size());
}

int TubeCoreListModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : columns; }

QVariant TubeCoreListModel::data(const QModelIndex& index, int role) const {
    if (role == Qt::TextAlignmentRole) return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
    const auto place = static_cast<std::size_t>(index.row());
    const TubeCore& tube = m_run->tubes.at(place);
    if (role == Qt::ToolTipRole && index.column() == state) return wordsOf(m_states.states[place]);
    if (role == shareRole) return m_states.shares[place];
    if (role != Qt::DisplayRole && role != Qt::UserRole) return {};
    const bool sorts = role == Qt::UserRole;
    // Without a value a tube core sorts as less than all others: first if they ascend, last if they descend.
    const auto shown = [sorts](const std::optional<double>& value, char format, int digits) -> QVariant {
        if (sorts) return value.value_or(-1.0);
        return value ? QLocale::c().toString(*value, format, digits) : QString();
    };
    switch (index.column()) {
        case number: return index.row();
        case column: return tube.column;
        case row: return tube.row;
        case state:
            return sorts ? QVariant(static_cast<int>(m_states.states[place]))
                         : QVariant(wordsOf(m_states.states[place]));
        case low: return shown(tube.lowIntensity, 'f', 3);
        case high: return shown(tube.highIntensity, 'f', 3);
        case weight: return shown(tube.d > 0.0 ? std::optional(tube.d) : std::nullopt, 'f', 4);
        default: return {};
    }
}

QVariant TubeCoreListModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::DisplayRole) {
        const QStringList words{tr("No."), tr("Col."), tr("Row"), tr("State"), "I_L", "I_H", "d"};
        return words.value(section);
    }
    if (role == Qt::ToolTipRole) {
        const QStringList words{tr("Number: row times columns plus column"),
                                tr("Column, counted from 0 at the left of the view"),
                                tr("Row, counted from 0 at the top of the view"),
                                tr("Whether it found a surface and has a weight"),
                                tr("Mean intensity before the surface"),
                                tr("Intensity at the surface"),
                                tr("Weight in the curve (eq. 11)")};
        return words.value(section);
    }
    return {};
}

TubeCoreList::TubeCoreList(QWidget* parent)
    : QTableView(parent), m_model(new TubeCoreListModel(this)), m_sorted(new QSortFilterProxyModel(this)) {
    named(this, "tubeCores.list", tr("List of tube cores"), tr("A click on a row explains its tube core"));
    m_sorted->setSourceModel(m_model);
    m_sorted->setSortRole(Qt::UserRole);
    setModel(m_sorted);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setTabKeyNavigation(false);  // Tab goes on to the next control
    setShowGrid(false);
    setAlternatingRowColors(true);
    setWordWrap(false);
    setItemDelegateForColumn(TubeCoreListModel::state, new SignDelegate(this));
    verticalHeader()->hide();
    verticalHeader()->setMinimumSectionSize(1);  // that of its letters, which it gets after the list, keeps rows high
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setMinimumSectionSize(20);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setSectionResizeMode(TubeCoreListModel::state, QHeaderView::Stretch);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    fit();
    setSortingEnabled(true);
    sortByColumn(TubeCoreListModel::number, Qt::AscendingOrder);
    connect(selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& now) {
        if (!m_following && now.isValid()) emit chosen(m_sorted->mapToSource(now).row());
    });
}

/// The columns are as wide as their words.
void TubeCoreList::fit() {
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 5);
    const QFontMetrics metrics = fontMetrics();
    const auto wide = [&](const QString& widest) { return metrics.horizontalAdvance(widest) + 11; };
    horizontalHeader()->resizeSection(TubeCoreListModel::number, wide("000"));
    horizontalHeader()->resizeSection(TubeCoreListModel::column, wide("Col."));
    horizontalHeader()->resizeSection(TubeCoreListModel::row, wide("Row"));
    horizontalHeader()->resizeSection(TubeCoreListModel::low, wide("0.000"));
    horizontalHeader()->resizeSection(TubeCoreListModel::high, wide("0.000"));
    horizontalHeader()->resizeSection(TubeCoreListModel::weight, wide("0.0000"));
    setMinimumWidth(inLettersOf(*this, 240));
    setFixedHeight(inLettersOf(*this, 190));
}

void TubeCoreList::changeEvent(QEvent* event) {
    QTableView::changeEvent(event);
    if (event->type() == QEvent::FontChange) fit();
}

void TubeCoreList::setRun(std::shared_ptr<const AdaptiveOtf> run) {
    m_following = true;
    m_model->setRun(std::move(run));
    m_following = false;
}

void TubeCoreList::setChosen(std::optional<int> number) {
    m_following = true;
    const QModelIndex index =
        number ? m_sorted->mapFromSource(m_model->index(*number, TubeCoreListModel::number)) : QModelIndex();
    if (index.isValid()) {
        if (index.row() != currentIndex().row()) setCurrentIndex(index);
        selectRow(index.row());
        scrollTo(index);
    } else {
        clearSelection();
        setCurrentIndex({});
    }
    m_following = false;
}

}  // namespace echolucent
