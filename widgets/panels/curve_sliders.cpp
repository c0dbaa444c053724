#include "widgets/panels/curve_sliders.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "widgets/panels/panel_controls.h"
#include "widgets/panels/value_slider.h"

namespace echolucent {

CurveSliders::CurveSliders(QWidget* parent) : QWidget(parent) {
    setObjectName("curveSliders");
    setAccessibleName(tr("Curve"));
    m_threshold = new ValueSlider("view.threshold", tr("Threshold"), 0.01, 2);
    m_threshold->setRange(-largestThreshold, largestThreshold);
    m_threshold->setToolTip(tr("To the right only brighter echoes show; moves the rise of the curve that is rendered"));
    m_transparency = new ValueSlider("view.transparency", tr("Transparency"), 0.01, 2);
    m_transparency->setRange(-largestTransparency, largestTransparency);
    m_transparency->setToolTip(tr("To the right you see deeper; black fluid stays clear either way"));
    auto* reset = named(new QPushButton(tr("Reset curve")), "view.resetCurve", tr("Reset curve"),
                        tr("The curve without these sliders, and as it was before it was edited (C)"));
    connect(m_threshold, &ValueSlider::valueChanged, this, [this](double value) {
        m_adjustment.threshold = value;
        emit adjustmentChanged(m_adjustment, tr("threshold"));
    });
    connect(m_transparency, &ValueSlider::valueChanged, this, [this](double value) {
        m_adjustment.transparency = value;
        emit adjustmentChanged(m_adjustment, tr("transparency"));
    });
    connect(reset, &QPushButton::clicked, this, &CurveSliders::resetRequested);
    auto* grid = new QGridLayout(this);
    grid->addWidget(labelFor(m_threshold, tr("Threshold")), 0, 0);
    grid->addWidget(m_threshold, 0, 1);
    grid->addWidget(labelFor(m_transparency, tr("Transparency")), 1, 0);
    grid->addWidget(m_transparency, 1, 1);
    grid->addWidget(reset, 2, 1, Qt::AlignRight);
    grid->setContentsMargins(9, 9, 9, 0);
}

void CurveSliders::setAdjustment(const CurveAdjustment& adjustment) {
    m_adjustment = adjustment;
    m_threshold->setValue(adjustment.threshold);
    m_transparency->setValue(adjustment.transparency);
}

}  // namespace echolucent
