#include "widgets/panels/curve_sliders.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "widgets/controls/panel_controls.h"
#include "widgets/controls/value_text.h"

namespace echolucent {

CurveSliders::CurveSliders(DocumentModel& document, QWidget* parent)
    : QWidget(parent),
      m_controls(adjustmentParameters(), "view", NumberControl::slider,
                 [&document](const CurveAdjustment& adjustment, const AnyParameter& row) {
                     document.change(textOf(row.label).toLower(),
                                     [&](Document& next) { next.curves.adjustment = adjustment; });
                 }) {
    setObjectName("curveSliders");
    setAccessibleName(tr("Curve"));
    m_meaning = m_controls.of("threshold").widget->toolTip();
    document.bind(&DocumentModel::curvesChanged, this, [this](const Document& shown) {
        m_controls.setValues(shown.curves.adjustment);
        showThreshold();
    });
    auto* reset = named(new QPushButton(tr("Reset curve")), "view.resetCurve", tr("Reset curve"),
                        tr("The curve without these sliders, and as it was before it was edited (C)"));
    connect(reset, &QPushButton::clicked, this, &CurveSliders::resetRequested);
    auto* grid = new QGridLayout(this);
    for (const AnyParameter& row : adjustmentParameters()) {
        const int line = grid->count() / 2;
        grid->addWidget(m_controls.of(row.name).label, line, 0);
        grid->addWidget(m_controls.of(row.name).widget, line, 1);
    }
    grid->setColumnMinimumWidth(0, 92);  // in line with the panel below
    grid->addWidget(reset, grid->count() / 2, 1, Qt::AlignRight);
    grid->setContentsMargins(9, 9, 9, 0);
}

void CurveSliders::setValueWindow(const ValueWindow& window) {
    m_values = window;
    showThreshold();
}

void CurveSliders::showThreshold() {
    const double moved = m_controls.values().threshold;
    QString tip = m_meaning;
    if (moved != 0.0 && !m_values.isNormalised()) {
        const double by = m_values.valueAt(moved) - m_values.black;
        tip += "\n" + tr("%1 moves it by %2 in the file's values")
                          .arg(moved, 0, 'f', 2)
                          .arg(valueText(by, {0.0, m_values.white - m_values.black}));
    }
    m_controls.of("threshold").widget->setToolTip(tip);
}

}  // namespace echolucent
