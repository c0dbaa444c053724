#include "widgets/panels/curve_sliders.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "widgets/panels/panel_controls.h"
#include "widgets/panels/value_slider.h"

namespace echolucent {

CurveSliders::CurveSliders(DocumentModel& document, QWidget* parent) : QWidget(parent) {
    setObjectName("curveSliders");
    setAccessibleName(tr("Curve"));
    auto* threshold = new ValueSlider("view.threshold", tr("Threshold"), 0.01, 2);
    threshold->setRange(-largestThreshold, largestThreshold);
    threshold->setToolTip(tr("To the right only brighter echoes show; moves the rise of the curve that is rendered"));
    auto* transparency = new ValueSlider("view.transparency", tr("Transparency"), 0.01, 2);
    transparency->setRange(-largestTransparency, largestTransparency);
    transparency->setToolTip(tr("To the right you see deeper; black fluid stays clear either way"));
    auto* reset = named(new QPushButton(tr("Reset curve")), "view.resetCurve", tr("Reset curve"),
                        tr("The curve without these sliders, and as it was before it was edited (C)"));
    const auto bind = [&document](ValueSlider* slider, const QString& what, double CurveAdjustment::*member) {
        connect(slider, &ValueSlider::valueChanged, &document, [&document, what, member](double value) {
            document.change(what, [&](Document& next) { next.curves.adjustment.*member = value; });
        });
        document.bind(&DocumentModel::curvesChanged, slider,
                      [slider, member](const Document& shown) { slider->setValue(shown.curves.adjustment.*member); });
    };
    bind(threshold, tr("threshold"), &CurveAdjustment::threshold);
    bind(transparency, tr("transparency"), &CurveAdjustment::transparency);
    connect(reset, &QPushButton::clicked, this, &CurveSliders::resetRequested);
    auto* grid = new QGridLayout(this);
    grid->addWidget(labelFor(threshold, tr("Threshold")), 0, 0);
    grid->addWidget(threshold, 0, 1);
    grid->addWidget(labelFor(transparency, tr("Transparency")), 1, 0);
    grid->addWidget(transparency, 1, 1);
    grid->addWidget(reset, 2, 1, Qt::AlignRight);
    grid->setContentsMargins(9, 9, 9, 0);
}

}  // namespace echolucent
