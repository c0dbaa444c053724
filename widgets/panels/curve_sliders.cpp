#include "widgets/panels/curve_sliders.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <variant>

#include "processing/adaptive/method_parameters.h"
#include "processing/document/curve_adjustment.h"
#include "processing/document/panes.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/controls/value_slider.h"
#include "widgets/controls/value_text.h"

namespace echolucent {

namespace {

/// Why nobody can set the aim; empty if a person can.
QString whyNoAim(const Document& shown, bool comparing) {
    if (shown.scene.look.mode != RenderMode::direct)
        return CurveSliders::tr("There is a curve in the mode Direct rendering only (More).");
    const bool adaptive =
        comparing ? std::ranges::any_of(shown.panes, isAdaptive) : isAdaptive(shown.panes.at(firstPane));
    if (!adaptive) return CurveSliders::tr("It moves the computed curve only. Choose the preset Standard.");
    if (!std::holds_alternative<RampRule>(shown.method.config.curve))
        return CurveSliders::tr(
            "A product of basis functions cannot be told which surfaces to show: the form ramp can.");
    return {};
}

const Parameter<AdaptiveOtfConfig>& aimRow() { return *parameterNamed(methodParameters(), "aim"); }

}  // namespace

void CurveSliders::addAim(QGridLayout& grid) {
    const Parameter<AdaptiveOtfConfig>& row = aimRow();
    const QString label = tr("Surfaces");
    m_aim = new ValueSlider("view.aim", tr("Surfaces: bright … every wall"), 1.0, 1, nullptr, ValueSlider::Zeros::none);
    m_aim->setRange(100.0 * row.range.least, 100.0 * row.range.largest);
    m_aim->setSuffix(tr(" %"));
    m_aim->setStandard(100.0 * RampRule{}.aim);
    m_aim->setToolTip(
        tr("Which surfaces the computed curve shows where they stand. 0 %: bright surfaces only. 100 %: every wall, "
           "with some haze before bright surfaces."));
    grid.addWidget(labelFor(m_aim, label), 0, 0);
    grid.addWidget(m_aim, 0, 1);
    grid.addWidget(secondaryLabel(tr("0 %: bright · 100 %: every wall")), 1, 1);
    connect(m_aim, &ValueSlider::valueChanged, this, [this, &row](double percent) {
        m_document.change(tr("surfaces"), [&](Document& next) { row.set(next.method.config, percent / 100.0); });
    });
    m_document.bind(&DocumentModel::changed, m_aim, [this](const Document&) { showAim(); });
}

void CurveSliders::showAim() {
    const Document& shown = m_document.document();
    const QString whyNot = whyNoAim(shown, m_comparing);
    enableOrSayWhy(*m_aim, whyNot.isEmpty(), whyNot);
    if (const auto aim = aimRow().get(shown.method.config)) m_aim->setValue(100.0 * numberOf(*aim).value());
}

void CurveSliders::setComparing(bool comparing) {
    m_comparing = comparing;
    showAim();
}

CurveSliders::CurveSliders(DocumentModel& document, QWidget* parent) : QWidget(parent), m_document(document) {
    setObjectName("curveSliders");
    setAccessibleName(tr("Curve"));
    auto* grid = new QGridLayout(this);
    addAim(*grid);
    for (const Parameter<CurveAdjustment>& row : adjustmentParameters()) {
        const QString label = textOf(row.label);
        auto* slider = new ValueSlider(QStringLiteral("view.") + textOf(row.name), label, 1.0, 1, nullptr,
                                       ValueSlider::Zeros::none);
        const ParameterRange range = row.offeredRange();
        slider->setRange(100.0 * range.least, 100.0 * range.largest);
        slider->setSuffix(tr(" %"));
        slider->setToolTip(tr("%1. At 0 % this slider changes nothing").arg(textOf(row.meaning)));
        const int line = grid->rowCount();
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
                        tr("The curve says which brightness is seen through and which is solid. Resets threshold, "
                           "transparency and all edits of the curve (C)"));
    connect(reset, &QPushButton::clicked, this, &CurveSliders::resetRequested);
    grid->setColumnMinimumWidth(0, 92);  // in line with the panel below
    grid->addWidget(reset, grid->rowCount(), 1, Qt::AlignRight);
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
