// MethodPanel's choices of reading, form and interface function, and what follows from them.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSpinBox>
#include <QStandardItemModel>

#include "widgets/panels/chosen_reading.h"
#include "widgets/panels/method_panel.h"
#include "widgets/panels/panel_controls.h"
#include "widgets/panels/value_slider.h"

namespace echolucent {
namespace {

/// The entry of the choice of readings that nobody can choose: a parameter was changed.
constexpr int changedReading = -1;

}  // namespace

void MethodPanel::createMethodChoices() {
    const auto choice = [](const QString& name, const QString& accessibleName, const QString& toolTip) {
        auto* comboBox = named(new QComboBox, "adaptive." + name, accessibleName, toolTip);
        wheelNeedsFocus(comboBox);
        return comboBox;
    };
    m_form =
        choice("form", tr("Form of the curve"),
               tr("What the found surfaces make of the curve. Ramp: clear up to the fluid, full from the surface on, "
                  "averaged over the tube cores. Product: the initial function times one basis function for each tube "
                  "core, as published"));
    m_form->addItem(tr("Ramp"), static_cast<int>(CurveForm::ramp));
    m_form->addItem(tr("Product of basis functions"), static_cast<int>(CurveForm::product));

    m_reading =
        choice("reading", tr("Reading"),
               tr("How the method is understood, all parameters at once. As published: the paper's words taken "
                  "literally. Settled: its open points decided as the notes on the method say. Default: what this "
                  "program takes"));
    m_reading->addItem(tr("As published"), static_cast<int>(MethodReading::asPublished));
    m_reading->addItem(tr("Settled"), static_cast<int>(MethodReading::settled));
    m_reading->addItem(tr("Default"), static_cast<int>(MethodReading::standard));
    m_reading->addItem(tr("Changed"), changedReading);
    qobject_cast<QStandardItemModel*>(m_reading->model())->item(m_reading->count() - 1)->setEnabled(false);

    m_interfaceFunction =
        choice("interfaceFunction", tr("Interface function"),
               tr("What tells tissue from fluid along a tube core. Ratio of means: how much brighter it is behind than "
                  "before, which speckle does not disturb. Variance in scale space: where intensities vary most, as "
                  "published"));
    m_interfaceFunction->addItem(tr("Ratio of means"), static_cast<int>(InterfaceFunction::ratio));
    m_interfaceFunction->addItem(tr("Variance in scale space"), static_cast<int>(InterfaceFunction::variance));
}

void MethodPanel::changed() {
    showReading();
    emit configChanged(config());
}

void MethodPanel::takeReading() {
    const int reading = m_reading->currentData().toInt();
    if (reading == changedReading) return;
    AdaptiveOtfConfig config = configOf(static_cast<MethodReading>(reading));
    config.initial = m_config.initial;
    setConfig(config);
    emit configChanged(this->config());
}

void MethodPanel::showReading() {
    const auto reading = readingOf(m_config);
    selectData(m_reading, reading ? static_cast<int>(*reading) : changedReading);
    const bool ramp = m_config.form == CurveForm::ramp;
    for (QWidget* ofProduct : {static_cast<QWidget*>(m_strengthLabel), static_cast<QWidget*>(m_strength)})
        ofProduct->setVisible(!ramp);
    for (QWidget* ofRamp : {static_cast<QWidget*>(m_rampOpacityLabel), static_cast<QWidget*>(m_rampOpacity)})
        ofRamp->setVisible(ramp);
    // The ratio looks at means as they are; only the variance is followed through scales.
    const bool ratio = m_config.interfaceFunction == InterfaceFunction::ratio;
    for (QWidget* ofScales : {static_cast<QWidget*>(m_coarsestScale), static_cast<QWidget*>(m_finestScale),
                              static_cast<QWidget*>(m_significance)})
        ofScales->setEnabled(!ratio);
    m_falseAlarm->setEnabled(ratio);
}

}  // namespace echolucent
