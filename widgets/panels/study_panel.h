// The facts known of the open study, and where each was learnt.
#pragma once

#include <QList>
#include <QString>
#include <QStringList>
#include <QWidget>

class QLabel;
class QTableWidget;

namespace echolucent {

/// One line of the import report.
struct StudyFactRow {
    QString name;    ///< "spacing"
    QString value;   ///< "0.30 x 0.30 x 0.30 mm"
    QString source;  ///< "ElementSpacing", "assumed"
};

/// A read-only table of facts (study.facts) below the warnings (study.warnings, hidden if there are none).
class StudyPanel : public QWidget {
    Q_OBJECT

public:
    explicit StudyPanel(QWidget* parent = nullptr);

    /// Replaces all that is shown. Warnings are sentences.
    void setStudy(const QList<StudyFactRow>& facts, const QStringList& warnings);

private:
    QTableWidget* m_facts;
    QLabel* m_warnings;
};

}  // namespace echolucent
