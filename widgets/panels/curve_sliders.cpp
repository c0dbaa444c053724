#include "widgets/panels/curve_sliders.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "processing/document/curve_adjustment.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/controls/value_slider.h"
#include "widgets/controls/value_text.h"

namespace echolucent {

CurveSliders::CurveSliders(DocumentModel& document, QWidget* parent) : QWidget(parent) {
    setObjectName("curveSliders");
    setAccessibleName(tr("Curve"));
    auto* grid = new QGridLayout(this);
    for (const Parameter<CurveAdjustment>& row : adjustmentParameters()) {
        const QString label = textOf(row.label);
        auto* slider = new ValueSlider(QStringLiteral("view.") + textOf(row.name), label, 1.0, 1, nullptr,
                                       ValueSlider::Zeros::none);
        const ParameterRange range = row.offeredRange();
        slider->setRange(100.0 * range.least, 100.0 * range.largest);
        slider->setSuffix(tr(" %"));
        slider->setToolTip(tr("%1. At 0 % this slider changes nothing").arg(textOf(row.meaning)));
        const int line = grid->count() / 2;
        grid->addWidget(labelFor(slider, label), line, 0);
        grid->addWidget(slider, line, 1);
        connect(slider, &ValueSlider::valueChanged, this, [&document, &row](double percent) {
            document.change(textOf(row.label).toLower(),
                            [&](Document& next) { row.set(next.curves.adjustment, percent / 100.0); });
        });
        document.bind(&DocumentModel::curvesChanged, slider, [slider, &row](const Document& shown) {
            slider->setValue(100.0 * numberOf(*row.get(shown.curves.adjustment)).value());
        });
        if (row.name == "threshold") m_threshold = slider;
    }
    m_meaning = tr("%1. In percent of the grey scale").arg(m_threshold->toolTip());
    document.bind(&DocumentModel::curvesChanged, this, [this](const Document& shown) {
        m_shownThreshold = shown.curves.adjustment.threshold;
        showThreshold();
    });
    auto* reset = named(new QPushButton(tr("Reset curve")), "view.resetCurve", tr("Reset curve"),
                        tr("The curve says which brightness is seen through and which is solid. Resets both sliders "
                           "and all edits of the curve (C)"));
    connect(reset, &QPushButton::clicked, this, &CurveSliders::resetRequested);
    grid->setColumnMinimumWidth(0, 92);  // in line with the panel below
    grid->addWidget(reset, grid->count() / 2, 1, Qt::AlignRight);
    grid->setContentsMargins(9, 9, 9, 0);
}

void CurveSliders::setValueWindow(const ValueWindow& window) {
    m_values = window;
    showThreshold();
}

void CurveSliders::showThreshold() {
    QString tip = m_meaning;
    if (m_shownThreshold != 0.0 && !m_values.isNormalised()) {
        const double by = m_values.valueAt(m_shownThreshold) - m_values.black;
        tip += "\n" + tr("%1 % moves the curve's rise by %2 in the file's values")
                          .arg(100.0 * m_shownThreshold, 0, 'g', 4)
                          .arg(valueText(by, {0.0, m_values.white - m_values.black}));
    }
    m_threshold->setToolTip(tip);
}

}  // namespace echolucent
