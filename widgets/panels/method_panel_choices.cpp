// MethodPanel's choices of reading, form and interface function, and what follows from them.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSpinBox>
#include <QStandardItemModel>

#include "processing/adaptive/method_parameters.h"
#include "processing/adaptive/method_reading.h"
#include "widgets/panels/method_panel.h"
#include "widgets/panels/panel_controls.h"
#include "widgets/panels/value_slider.h"

namespace echolucent {
namespace {

/// The entry of the choice of readings that nobody can choose: a parameter was changed.
constexpr int changedReading = -1;

}  // namespace

QComboBox* MethodPanel::createChoice(const char* parameter) {
    const Row& row = *parameterNamed(methodParameters(), parameter);
    auto* comboBox = named(new QComboBox, {}, textOf(row.label), textOf(row.meaning));
    wheelNeedsFocus(comboBox);
    return comboBox;
}

void MethodPanel::createMethodChoices() {
    // The data of an entry is the index of the alternative in its variant.
    m_form = createChoice("form");
    m_form->setObjectName("adaptive.form");
    m_form->addItem(tr("Ramp"), static_cast<int>(CurveRule(RampRule{}).index()));
    m_form->addItem(tr("Product of basis functions"), static_cast<int>(CurveRule(ProductRule{}).index()));

    m_reading = named(new QComboBox, "adaptive.reading", tr("Reading"),
                      tr("How the method is understood, all parameters at once. As published: the paper's words taken "
                         "literally. Settled: its open points settled by experiment. Default: what this "
                         "program takes"));
    wheelNeedsFocus(m_reading);
    m_reading->addItem(tr("As published"), static_cast<int>(MethodReading::asPublished));
    m_reading->addItem(tr("Settled"), static_cast<int>(MethodReading::settled));
    m_reading->addItem(tr("Default"), static_cast<int>(MethodReading::standard));
    m_reading->addItem(tr("Changed"), changedReading);
    qobject_cast<QStandardItemModel*>(m_reading->model())->item(m_reading->count() - 1)->setEnabled(false);

    m_interfaceFunction = createChoice("interface_function");
    m_interfaceFunction->setObjectName("adaptive.interfaceFunction");
    m_interfaceFunction->addItem(tr("Ratio of means"), static_cast<int>(DetectionRule(RatioRule{}).index()));
    m_interfaceFunction->addItem(tr("Variance in scale space"),
                                 static_cast<int>(DetectionRule(VarianceRule{}).index()));
}

void MethodPanel::takeForm() {
    m_config.curve = m_curves[static_cast<std::size_t>(m_form->currentData().toInt())];
    changed();
}

void MethodPanel::takeDetection() {
    m_config.detection = m_detections[static_cast<std::size_t>(m_interfaceFunction->currentData().toInt())];
    changed();
}

void MethodPanel::forgetRulesNotChosen() {
    m_detections = {DetectionRule(std::in_place_index<0>), DetectionRule(std::in_place_index<1>)};
    m_curves = {CurveRule(std::in_place_index<0>), CurveRule(std::in_place_index<1>)};
}

void MethodPanel::changed() {
    showConfig();
    emit configChanged(config());
}

void MethodPanel::takeReading() {
    const int reading = m_reading->currentData().toInt();
    if (reading == changedReading) return;
    AdaptiveOtfConfig config = configOf(static_cast<MethodReading>(reading));
    config.initial = m_config.initial;
    forgetRulesNotChosen();
    setConfig(config);
    emit configChanged(this->config());
}

void MethodPanel::showReading() {
    const auto reading = readingOf(m_config);
    selectData(m_reading, reading ? static_cast<int>(*reading) : changedReading);
    const bool ramp = std::holds_alternative<RampRule>(m_config.curve);
    for (QWidget* ofProduct : {static_cast<QWidget*>(m_strengthLabel), static_cast<QWidget*>(m_strength)})
        ofProduct->setVisible(!ramp);
    for (QWidget* ofRamp : {static_cast<QWidget*>(m_rampOpacityLabel), static_cast<QWidget*>(m_rampOpacity)})
        ofRamp->setVisible(ramp);
}

}  // namespace echolucent
