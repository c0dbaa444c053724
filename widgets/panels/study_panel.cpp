#include "widgets/panels/study_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

#include "widgets/panels/panel_controls.h"

namespace echolucent {

StudyPanel::StudyPanel(QWidget* parent)
    : QWidget(parent),
      m_facts(named(new QTableWidget(0, 3), "study.facts", tr("What is known of the study"))),
      m_warnings(named(new QLabel, "study.warnings", tr("What to know before trusting the picture"))) {
    setObjectName("study");
    setAccessibleName(tr("Study"));
    m_warnings->setWordWrap(true);
    m_warnings->setTextFormat(Qt::PlainText);  // file names may hold anything
    m_warnings->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_warnings->hide();

    m_facts->setHorizontalHeaderLabels({tr("Fact"), tr("Value"), tr("Source")});
    m_facts->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_facts->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    m_facts->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
    m_facts->horizontalHeader()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    m_facts->verticalHeader()->hide();
    m_facts->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_facts->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_facts->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_facts->setTabKeyNavigation(false);  // Tab goes on to the next panel
    m_facts->setShowGrid(false);
    m_facts->setWordWrap(true);

    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_warnings);
    layout->addWidget(m_facts, 1);
}

void StudyPanel::setStudy(const QList<StudyFactRow>& facts, const QStringList& warnings) {
    m_facts->setRowCount(static_cast<int>(facts.size()));
    for (int row = 0; row < m_facts->rowCount(); ++row) {
        const StudyFactRow& fact = facts[row];
        const QStringList texts{fact.name, fact.value, fact.source};
        for (int column = 0; column < texts.size(); ++column) {
            auto* item = new QTableWidgetItem(texts[column]);
            item->setToolTip(texts[column].toHtmlEscaped());
            m_facts->setItem(row, column, item);
        }
    }
    QStringList lines;
    for (const QString& warning : warnings) lines << QStringLiteral("⚠ ") + warning;
    m_warnings->setText(lines.join('\n'));
    m_warnings->setVisible(!warnings.isEmpty());
}

}  // namespace echolucent
