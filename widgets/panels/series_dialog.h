// Asks which of several series is to be opened.
#pragma once

#include <QDialog>
#include <QImage>
#include <QList>
#include <QString>

class QLabel;
class QListWidget;
class QPushButton;

namespace echolucent {

/// A series as it is offered.
struct SeriesRow {
    QString title;        ///< what the scanner calls it, or "series 3"
    QString facts;        ///< "DICOM ultrasound, 256 x 256, 66 slices"
    QString hindrance{};  ///< why it cannot be opened as a volume, a sentence; empty where nothing is against it
    bool openable = true;
};

/// Objects: series (this), series.list (a row each, the first that can be opened is selected), series.why (what stands
/// against the selected one), series.open, series.cancel. A double click or Enter opens. Rows that cannot be opened can
/// be looked at, and Open is disabled for them.
class SeriesDialog : public QDialog {
    Q_OBJECT

public:
    /// Pixels of a picture's longest edge.
    static constexpr int pictureEdge = 96;

    /// `source` is the name of the folder; `rows` is not empty.
    SeriesDialog(const QString& source, const QList<SeriesRow>& rows, QWidget* parent = nullptr);

    /// The row that is selected.
    [[nodiscard]] int selected() const;
    /// Shows the small picture of a row.
    void setPicture(int row, const QImage& picture);

private:
    void showSelected();
    void openSelected();

    QList<SeriesRow> m_rows;
    QListWidget* m_list;
    QLabel* m_why;
    QPushButton* m_open = nullptr;
};

}  // namespace echolucent
