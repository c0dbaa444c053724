// The tube cores of a run as a table that can be sorted.
#pragma once

#include <QAbstractTableModel>
#include <QTableView>
#include <memory>
#include <optional>
#include <vector>

#include "processing/explanation/tube_explanation.h"
#include "widgets/tube_cores/tube_core_words.h"

class QSortFilterProxyModel;

namespace echolucent {

/// Number, column, row, state, I_L, I_H and d of each tube core. Qt::UserRole gives the values to sort by. The state
/// has words, and shareRole its share of the largest weight.
class TubeCoreListModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { number, column, row, state, low, high, weight, columns };
    static constexpr int shareRole = Qt::UserRole + 1;
    using QAbstractTableModel::QAbstractTableModel;

    void setRun(std::shared_ptr<const AdaptiveOtf> run);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::shared_ptr<const AdaptiveOtf> m_run;
    TubeCoreStates m_states;
};

/// Object tubeCores.list. A click on a row, or the arrow keys, choose its tube core; a click on a heading sorts.
/// The state is shown as its sign in the map; its words are the tool tip.
class TubeCoreList : public QTableView {
    Q_OBJECT

public:
    explicit TubeCoreList(QWidget* parent = nullptr);

    void setRun(std::shared_ptr<const AdaptiveOtf> run);
    void setChosen(std::optional<int> number);

signals:
    void chosen(int number);

protected:
    void changeEvent(QEvent* event) override;

private:
    void fit();

    TubeCoreListModel* m_model;
    QSortFilterProxyModel* m_sorted;
    bool m_following = false;  ///< while setChosen() selects a row
};

}  // namespace echolucent
