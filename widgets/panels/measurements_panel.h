// The tools that measure, and the list of what was measured.
#pragma once

#include <QString>
#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "processing/scene/measurement.h"

class QAbstractButton;
class QComboBox;
class QKeyEvent;
class QListWidget;
class QPlainTextEdit;
class QPushButton;

namespace echolucent {

struct MeasurementRow {
    int id = 1;    ///< of the measurement, not of the row
    QString text;  ///< "1. BPD 12.3 mm, in a plane"
    QString name{}, comment{};
    friend bool operator==(const MeasurementRow&, const MeasurementRow&) = default;
};

/// Objects: measurements (this), measurements.distance, .angle, .list, .name, .comment (of the measurement selected in
/// the list), .remove, .removeAll. An empty list is hidden with its fields and buttons. In the list, Delete removes,
/// F2 or a double click goes to the name, and a letter becomes the name's first. Tab goes from the name to the comment,
/// the list and the buttons that remove. setRows() emits typingEnded(); no other setter emits a signal.
class MeasurementsPanel : public QWidget {
    Q_OBJECT

public:
    explicit MeasurementsPanel(QWidget* parent = nullptr);

    void setRows(const std::vector<MeasurementRow>& rows);
    /// Shows which tool is in the hand; no value if none is.
    void setTool(std::optional<MeasurementKind> tool);
    /// Puts the cursor into the name of the selected measurement, with its text selected.
    void goToName();
    /// goToName() after a measurement that nobody may want to name: until something is typed or the field is clicked,
    /// Escape is the window's. Letters are the name's: "MV" begins with the key of a tool.
    void askForName();

signals:
    /// No value: the person put the tool away.
    void toolChosen(std::optional<echolucent::MeasurementKind> tool);
    /// A row was clicked, or Enter pressed on it.
    void chosen(int id);
    /// A person types the name or the comment of a measurement: emitted at each letter.
    void nameTyped(int id, const QString& name);
    void commentTyped(int id, const QString& comment);
    /// The field was left, or another measurement was selected: what is typed from now on is a change of its own.
    void typingEnded();
    /// Enter in the name, a usual name chosen, or Escape in the list or a field: the keys belong to the picture again.
    void done();
    void removed(int id);
    void allRemoved();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* createList();
    void orderTabs();
    [[nodiscard]] bool asks() const;
    bool takeKeyOfList(QKeyEvent& key);
    void createName();
    void createComment();
    [[nodiscard]] int selectedId() const;
    void showTexts();
    void removeSelected();

    std::vector<MeasurementRow> m_rows;
    std::array<QAbstractButton*, 2> m_tools{};
    QWidget* m_listed = nullptr;  ///< list, fields and buttons
    QListWidget* m_list = nullptr;
    QComboBox* m_name = nullptr;
    QPlainTextEdit* m_comment = nullptr;
    QPushButton* m_remove = nullptr;
    QPushButton* m_removeAll = nullptr;
    bool m_asks = false;  ///< askForName() was called, and nobody has clicked or left the name since
};

}  // namespace echolucent
