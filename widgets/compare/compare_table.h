// The table of a comparison's measures, with what says and copies it.
#pragma once

#include <QGroupBox>
#include <vector>

#include "widgets/compare/compare_rows.h"

class QLabel;
class QPushButton;

namespace echolucent {

class FittedTable;

/// Objects: compare.table, compare.measureFlicker, compare.copyText, compare.copyCsv, compare.savePage, compare.note.
/// No setter emits a signal.
class CompareTable : public QGroupBox {
    Q_OBJECT

public:
    explicit CompareTable(QWidget* parent = nullptr);

    void setRows(const std::vector<CompareRow>& rows);
    [[nodiscard]] const std::vector<CompareRow>& rows() const { return m_rows; }
    /// Whether the flicker is being measured, and whether there are panes to measure.
    void setMeasuringFlicker(bool measuring, bool anyPane);

signals:
    void flickerRequested();
    void pageRequested();

private:
    [[nodiscard]] FittedTable* makeTable();
    [[nodiscard]] QLayout* makeButtons();
    void showFlickerAskedFor();
    void sayWhichSurfaces();

    std::vector<CompareRow> m_rows;
    FittedTable* m_table = nullptr;
    QLabel* m_note = nullptr;
    QPushButton* m_flicker = nullptr;
    bool m_flickerAskedFor = false;  ///< by the button, and not seen since
};

}  // namespace echolucent
