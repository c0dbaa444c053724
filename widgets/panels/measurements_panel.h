// The tools that measure, and the list of what was measured.
#pragma once

#include <QString>
#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "processing/scene/measurement.h"

class QAbstractButton;
class QListWidget;

namespace echolucent {

struct MeasurementRow {
    int id = 1;    ///< of the measurement, not of the row
    QString text;  ///< "1. 12.3 mm, in a plane"
    friend bool operator==(const MeasurementRow&, const MeasurementRow&) = default;
};

/// Objects: measurements (this), measurements.distance, .angle, .list, .remove, .removeAll. An empty list is hidden
/// with its buttons. No setter emits a signal.
class MeasurementsPanel : public QWidget {
    Q_OBJECT

public:
    explicit MeasurementsPanel(QWidget* parent = nullptr);

    void setRows(const std::vector<MeasurementRow>& rows);
    /// Shows which tool is in the hand; no value if none is.
    void setTool(std::optional<MeasurementKind> tool);

signals:
    /// No value: the person put the tool away.
    void toolChosen(std::optional<echolucent::MeasurementKind> tool);
    /// A row was clicked, or Enter pressed on it.
    void chosen(int id);
    void removed(int id);
    void allRemoved();

private:
    QWidget* createList();
    [[nodiscard]] int selectedId() const;

    std::vector<MeasurementRow> m_rows;
    std::array<QAbstractButton*, 2> m_tools{};
    QWidget* m_listed = nullptr;  ///< list and buttons
    QListWidget* m_list = nullptr;
};

}  // namespace echolucent
