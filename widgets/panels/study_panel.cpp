#include "widgets/panels/study_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/controls/panel_controls.h"
#include "widgets/controls/secondary_items.h"

namespace echolucent {

namespace {
constexpr int cellMargins = 14;
constexpr int narrowestNames = 60;
constexpr int widestNames = 120;
}  // namespace

StudyPanel::StudyPanel(QWidget* parent)
    : QWidget(parent),
      m_facts(named(new QTableWidget(0, 2), "study.facts", tr("What is known of the study"))),
      m_warnings(named(new QLabel, "study.warnings", tr("What to know before trusting the picture"))) {
    setObjectName("study");
    setAccessibleName(tr("Study"));
    m_warnings->setWordWrap(true);
    m_warnings->setTextFormat(Qt::PlainText);  // file names may hold anything
    m_warnings->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_warnings->hide();

    m_facts->setHorizontalHeaderLabels({tr("Fact"), tr("Value, and where it is from")});
    m_facts->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_facts->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Fixed);
    m_facts->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
    m_facts->verticalHeader()->hide();
    m_facts->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_facts->setItemDelegate(new SecondaryItemDelegate(m_facts));
    m_facts->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_facts->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_facts->setTabKeyNavigation(false);  // Tab goes on to the next panel
    m_facts->setShowGrid(false);
    m_facts->setWordWrap(true);
    m_facts->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);  // both columns share the width, and words wrap

    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_warnings);
    layout->addWidget(m_facts, 1);
}

void StudyPanel::setStudy(const QList<StudyFactRow>& facts, const QStringList& warnings) {
    m_facts->setRowCount(0);
    const auto put = [this](int row, int column, const QString& text) {
        auto* item = new QTableWidgetItem(text);
        item->setToolTip(literalToolTip(text));
        m_facts->setItem(row, column, item);
        return item;
    };
    int nameWidth = 0;
    for (const StudyFactRow& fact : facts) {
        int row = m_facts->rowCount();
        m_facts->insertRow(row);
        put(row, 0, fact.name);
        put(row, 1, fact.value);
        nameWidth = std::max(nameWidth, m_facts->fontMetrics().horizontalAdvance(fact.name) + cellMargins);
        if (fact.source.isEmpty()) continue;
        // The source gets its own line: three columns are too many for a narrow panel.
        m_facts->insertRow(++row);
        put(row, 0, {});
        put(row, 1, fact.source)->setData(secondaryRole, true);
    }
    m_facts->horizontalHeader()->resizeSection(0, std::clamp(nameWidth, narrowestNames, widestNames));
    QStringList lines;
    for (const QString& warning : warnings) lines << QStringLiteral("⚠ ") + warning;
    m_warnings->setText(lines.join('\n'));
    m_warnings->setVisible(!warnings.isEmpty());
}

}  // namespace echolucent
