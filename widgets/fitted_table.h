// A table that does not scroll up and down: the panel around it does.
#pragma once

#include <QTableWidget>

namespace echolucent {

/// As high as its headings and its rows, in letters of any size. Nobody edits it, and Tab goes on to the next control.
class FittedTable : public QTableWidget {
    Q_OBJECT

public:
    /// `rowHeight` suits the letters of the application, pixels; 0: that of the style.
    explicit FittedTable(const QStringList& headings, int rowHeight = 0, QWidget* parent = nullptr);

    /// Call this if there are more rows or fewer.
    void fit();

    bool eventFilter(QObject* watched, QEvent* event) override;

protected:
    void changeEvent(QEvent* event) override;

private:
    int m_rowHeight;
};

}  // namespace echolucent
