// Asks which of several series to open.
#pragma once

#include <QDialog>
#include <QImage>
#include <QList>
#include <QString>

class QLabel;
class QListWidget;
class QPushButton;

namespace echolucent {

struct SeriesRow {
    QString title;        ///< the scanner's name for the series, or "series 3"
    QString facts;        ///< "DICOM ultrasound, 256 x 256, 66 slices"
    QString hindrance{};  ///< a sentence that says why the series cannot be opened as a volume; empty if it can
    bool openable = true;
};

/// Objects: series (this), series.list (a row each; the first one that can be opened is selected), series.why (why the
/// selected series cannot be opened), series.open, series.cancel. A double click or Enter opens. A person can select a
/// row that cannot be opened, but Open is disabled for it.
class SeriesDialog : public QDialog {
    Q_OBJECT

public:
    /// Longest edge of a picture, pixels.
    static constexpr int pictureEdge = 96;

    /// `source` is the name of the folder; `rows` is not empty.
    SeriesDialog(const QString& source, const QList<SeriesRow>& rows, QWidget* parent = nullptr);

    [[nodiscard]] int selected() const;
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
