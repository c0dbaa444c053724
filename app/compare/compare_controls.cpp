#include "app/compare/compare_controls.h"

namespace echolucent {

CompareControls::CompareControls(DocumentModel& model, OpenStudy& openStudy, ComparePanel& panel, QObject* parent)
    : QObject(parent), m_model(model), m_openStudy(openStudy), m_panel(panel) {
    connect(&m_panel, &ComparePanel::countChosen, this, [this](int count) {
        m_model.edit(withPaneCount(m_model.document(), static_cast<std::size_t>(count)), tr("number of panes"));
    });
    connect(&m_panel, &ComparePanel::paneChosen, this, [this](int place, const Pane& choice) {
        m_model.edit(withPane(m_model.document(), static_cast<std::size_t>(place), choice),
                     tr("OTF of pane %1").arg(place + 1));
    });
    connect(&m_panel, &ComparePanel::comparisonChosen, this, [this](const Comparison& comparison, const QString& what) {
        Document next = m_model.document();
        next.comparison = comparison;
        m_model.edit(next, what);
    });
    connect(&m_model, &DocumentModel::changed, this, &CompareControls::show);
    connect(&m_openStudy, &OpenStudy::studyOpened, this, &CompareControls::show);
    show();
}

void CompareControls::begin() {
    if (!isCompared(m_model.document())) m_model.edit(withPaneCount(m_model.document(), mostPanes), tr("compare"));
}

void CompareControls::show() {
    const Document& document = m_model.document();
    const TubeGrid grid = configOf(document).grid;
    const Study* study = m_openStudy.study();
    m_panel.setLimits(study != nullptr ? static_cast<int>(study->phases.size()) : 1, grid.columns * grid.rows);
    m_panel.setComparison(document.comparison);
    m_panel.setPanes(isCompared(document) ? document.panes : std::vector<Pane>{});
}

}  // namespace echolucent
