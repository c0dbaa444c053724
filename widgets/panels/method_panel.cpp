#include "widgets/panels/method_panel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "processing/adaptive/method_parameters.h"
#include "widgets/panels/panel_controls.h"
#include "widgets/panels/value_slider.h"

namespace echolucent {
namespace {

/// The parameter's row; it must be there.
const Parameter<AdaptiveOtfConfig>& rowOf(std::string_view name) { return *parameterNamed(methodParameters(), name); }

QString methodObjectName(std::string_view name) {
    return QStringLiteral("adaptive.") + QString::fromStdString(camelCase(name));
}

QString methodToolTip(const Parameter<AdaptiveOtfConfig>& row) {
    return row.unit == "units" ? MethodPanel::tr("%1. A unit is the smallest voxel spacing").arg(textOf(row.meaning))
                               : textOf(row.meaning);
}

template <typename SpinBox, typename Value>
void showIn(SpinBox* spinBox, Value value) {
    const QSignalBlocker blocker(spinBox);
    spinBox->setValue(value);
}

/// Sets a parameter, clamped into what controls offer; a choice, or what means nothing in the config, stays.
void clampInto(const Parameter<AdaptiveOtfConfig>& row, AdaptiveOtfConfig& config) {
    const auto value = row.get(config);
    if (!value || !row.choices.empty()) return;
    const ParameterRange offered = row.offeredRange();
    if (const auto* whole = std::get_if<std::int64_t>(&*value))
        row.set(config, std::clamp(*whole, static_cast<std::int64_t>(offered.least),
                                   static_cast<std::int64_t>(offered.largest)));
    else if (const auto number = numberOf(*value))
        row.set(config, std::clamp(*number, offered.least, offered.largest));
}

}  // namespace

template <typename Control>
void MethodPanel::bind(const Row& row, Control* control) {
    control->setToolTip(methodToolTip(row));
    const ParameterRange offered = row.offeredRange();
    using Value = decltype(control->value());
    control->setRange(static_cast<Value>(offered.least), static_cast<Value>(offered.largest));
    const auto show = [control](double value) { showIn(control, static_cast<Value>(value)); };
    show(numberOf(defaultOf(methodParameters(), row)).value());
    m_numbers.push_back({&row, control, show});
    connect(control, &Control::valueChanged, this,
            [this, &row](auto value) { takeNumber(row, static_cast<double>(value)); });
}

QSpinBox* MethodPanel::createSpinBox(const char* parameter) {
    const Row& row = rowOf(parameter);
    auto* spinBox = named(new QSpinBox, methodObjectName(row.name), textOf(row.label));
    if (row.unit == "units") spinBox->setSuffix(tr(" units"));
    spinBox->setKeyboardTracking(false);
    wheelNeedsFocus(spinBox);
    bind(row, spinBox);
    return spinBox;
}

QDoubleSpinBox* MethodPanel::createDoubleSpinBox(const char* parameter, int decimals, double step) {
    const Row& row = rowOf(parameter);
    auto* spinBox = named(new QDoubleSpinBox, methodObjectName(row.name), textOf(row.label));
    spinBox->setDecimals(decimals);
    spinBox->setSingleStep(step);
    if (row.unit == "units") spinBox->setSuffix(tr(" units"));
    spinBox->setKeyboardTracking(false);
    wheelNeedsFocus(spinBox);
    bind(row, spinBox);
    return spinBox;
}

ValueSlider* MethodPanel::createSlider(const char* parameter, double step) {
    const Row& row = rowOf(parameter);
    auto* slider = new ValueSlider(methodObjectName(row.name), textOf(row.label), step, 2);
    bind(row, slider);
    return slider;
}

MethodPanel::MethodPanel(QWidget* parent) : QWidget(parent) {
    setObjectName("adaptive");
    setAccessibleName(tr("Adaptive opacity transfer function"));
    createMethodChoices();
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(createMainControls());
    layout->addWidget(createAdvancedControls());
    layout->addStretch(1);
    connectControls();
    showConfig();
}

QWidget* MethodPanel::createMainControls() {
    m_strength = createSlider("strength", 0.25);
    m_rampOpacity = createSlider("ramp_opacity", 0.01);
    m_strengthLabel = labelFor(m_strength, textOf(rowOf("strength").label));
    m_rampOpacityLabel = labelFor(m_rampOpacity, textOf(rowOf("ramp_opacity").label));
    m_initial = named(new QComboBox, "adaptive.initial", tr("Initial function"),
                      tr("The function that the method starts from"));
    m_initial->addItem(tr("x² (parabolic)"), static_cast<int>(InitialKind::parabolic));
    m_initial->addItem(tr("x⁴ (quartic)"), static_cast<int>(InitialKind::quartic));
    m_initial->addItem(tr("Linear curve"), static_cast<int>(InitialKind::linear));
    m_initial->addItem(tr("Manual nodes"), static_cast<int>(InitialKind::manual));
    wheelNeedsFocus(m_initial);
    m_opacityScale = createDoubleSpinBox("opacity_scale", 2, 0.05);
    m_opacityScale->setToolTip(
        tr("%1. The linear curve and the manual nodes bring their own").arg(textOf(rowOf("opacity_scale").meaning)));
    auto* compute = named(new QPushButton(tr("Compute for this view")), "adaptive.compute", tr("Compute for this view"),
                          tr("Lays the tube cores along the direction in which the camera looks (A)"));
    auto* reset = named(new QPushButton(tr("Defaults")), "adaptive.reset", tr("Reset to defaults"),
                        tr("Sets every parameter of the method to its default"));
    connect(compute, &QPushButton::clicked, this, &MethodPanel::computeRequested);
    connect(reset, &QPushButton::clicked, this, &MethodPanel::resetToDefaults);
    m_summary = named(new QLabel, "adaptive.summary", tr("What was found"));
    m_summary->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_message = named(new QLabel, "adaptive.message", tr("What could not be done"));
    m_message->setWordWrap(true);

    auto* controls = new QWidget;
    auto* grid = new QGridLayout(controls);
    grid->setHorizontalSpacing(4);  // both forms fit the column
    grid->setContentsMargins(0, 0, 0, 0);
    // One of the two, as the form has it.
    grid->addWidget(m_strengthLabel, 0, 0);
    grid->addWidget(m_strength, 0, 1, 1, 3);
    grid->addWidget(m_rampOpacityLabel, 0, 0);
    grid->addWidget(m_rampOpacity, 0, 1, 1, 3);
    grid->addWidget(labelFor(m_form, textOf(rowOf("form").label)), 1, 0);
    grid->addWidget(m_form, 1, 1, 1, 3);
    grid->addWidget(labelFor(m_initial, tr("Initial")), 2, 0);
    grid->addWidget(m_initial, 2, 1);
    grid->addWidget(labelFor(m_opacityScale, tr("Scale a")), 2, 2);
    grid->addWidget(m_opacityScale, 2, 3);
    grid->addWidget(compute, 3, 0, 1, 3);
    grid->addWidget(reset, 3, 3);
    grid->addWidget(m_summary, 4, 0, 1, 4);
    grid->addWidget(m_message, 5, 0, 1, 4);
    grid->setColumnStretch(1, 1);
    clearResult();
    return controls;
}

QWidget* MethodPanel::createAdvancedControls() {
    auto* tubeSpacing = createDoubleSpinBox("tube_spacing", 1, 1);
    tubeSpacing->setSpecialValueText(tr("automatic"));
    const std::vector<QWidget*> controls{createSpinBox("tube_columns"),
                                         createSpinBox("tube_rows"),
                                         tubeSpacing,
                                         createSpinBox("cell_size"),
                                         createDoubleSpinBox("false_alarm", 2, 0.25),
                                         createSpinBox("slope_half_step"),
                                         createSpinBox("coarsest_scale"),
                                         createSpinBox("finest_scale"),
                                         createDoubleSpinBox("significance", 2, 0.05)};

    m_advanced = named(new QToolButton, "adaptive.advanced", tr("Advanced parameters"),
                       tr("Reading, tube cores, cells and scales"));
    m_advanced->setText(tr("Advanced"));
    m_advanced->setCheckable(true);
    m_advanced->setAutoRaise(true);
    m_advanced->setFocusPolicy(Qt::StrongFocus);
    m_advanced->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_advanced->setArrowType(Qt::RightArrow);

    auto* hidden = new QWidget;
    auto* grid = new QGridLayout(hidden);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(labelFor(m_reading, tr("Reading")), 0, 0);
    grid->addWidget(m_reading, 0, 1);
    grid->addWidget(labelFor(m_interfaceFunction, tr("Interface")), 1, 0);
    grid->addWidget(m_interfaceFunction, 1, 1);
    constexpr int rowsAbove = 2;
    for (int i = 0; i < static_cast<int>(controls.size()); ++i) {
        QWidget* control = controls[static_cast<std::size_t>(i)];
        control->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        grid->addWidget(labelFor(control, control->accessibleName()), rowsAbove + i, 0);
        grid->addWidget(control, rowsAbove + i, 1);
    }
    grid->setColumnStretch(1, 1);
    hidden->hide();
    connect(m_advanced, &QToolButton::toggled, this, [this, hidden](bool open) {
        m_advanced->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
        hidden->setVisible(open);
    });

    auto* disclosure = new QWidget;
    auto* layout = new QVBoxLayout(disclosure);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_advanced, 0, Qt::AlignLeft);
    layout->addWidget(hidden);
    return disclosure;
}

void MethodPanel::connectControls() {
    connect(m_form, &QComboBox::currentIndexChanged, this, &MethodPanel::takeForm);
    connect(m_interfaceFunction, &QComboBox::currentIndexChanged, this, &MethodPanel::takeDetection);
    connect(m_reading, &QComboBox::currentIndexChanged, this, &MethodPanel::takeReading);
    connect(m_initial, &QComboBox::currentIndexChanged, this, &MethodPanel::takeInitial);
}

void MethodPanel::takeNumber(const Row& row, double value) {
    if (std::holds_alternative<std::int64_t>(defaultOf(methodParameters(), row)))
        row.set(m_config, std::llround(value));
    else
        row.set(m_config, value);
    if (auto* variance = std::get_if<VarianceRule>(&m_config.detection)) {
        // The scale that was not touched gives way.
        if (row.name == "coarsest_scale")
            variance->finestScale = std::min(variance->finestScale, variance->coarsestScale);
        else
            variance->coarsestScale = std::max(variance->finestScale, variance->coarsestScale);
    }
    changed();
}

void MethodPanel::takeInitial() {
    const InitialKind kind = initialKind();
    const bool power = kind == InitialKind::parabolic || kind == InitialKind::quartic;
    m_opacityScale->setEnabled(power);
    if (power) {
        m_config.initial = PowerCurve{kind == InitialKind::parabolic ? 2 : 4, opacityScale()};
    } else {
        m_config.initial = kind == InitialKind::linear ? m_linear : m_manual;
    }
    emit configChanged(config());
}

InitialKind MethodPanel::initialKind() const { return static_cast<InitialKind>(m_initial->currentData().toInt()); }

double MethodPanel::opacityScale() const { return m_opacityScale->value(); }

void MethodPanel::setConfig(const AdaptiveOtfConfig& config) {
    m_config = config;
    for (const NumberControl& number : m_numbers)
        if (number.widget != m_opacityScale || std::holds_alternative<PowerCurve>(m_config.initial))
            clampInto(*number.row, m_config);
    if (auto* variance = std::get_if<VarianceRule>(&m_config.detection))
        variance->finestScale = std::min(variance->finestScale, variance->coarsestScale);
    showConfig();
}

void MethodPanel::showConfig() {
    m_detections[m_config.detection.index()] = m_config.detection;
    m_curves[m_config.curve.index()] = m_config.curve;
    showInitial();
    for (const NumberControl& number : m_numbers) {
        const auto value = number.row->get(m_config);
        // The scale belongs to the powers alone; showInitial() says whether one is chosen.
        const bool applies =
            value && (number.widget != m_opacityScale || std::holds_alternative<PowerCurve>(m_config.initial));
        if (applies) number.show(numberOf(*value).value());
        number.widget->setEnabled(applies);
    }
    selectData(m_form, static_cast<int>(m_config.curve.index()));
    selectData(m_interfaceFunction, static_cast<int>(m_config.detection.index()));
    showReading();
}

void MethodPanel::showInitial() {
    InitialKind kind = InitialKind::manual;
    if (auto* power = std::get_if<PowerCurve>(&m_config.initial)) {
        // The panel offers two exponents; another one, from a file perhaps, becomes the nearer of them.
        power->exponent = power->exponent < 4 ? 2 : 4;
        kind = power->exponent == 2 ? InitialKind::parabolic : InitialKind::quartic;
    } else if (std::holds_alternative<LinearCurve>(m_config.initial)) {
        kind = InitialKind::linear;
        m_linear = m_config.initial;
    } else {
        m_manual = m_config.initial;
    }
    selectData(m_initial, static_cast<int>(kind));
    m_opacityScale->setEnabled(kind == InitialKind::parabolic || kind == InitialKind::quartic);
}

void MethodPanel::resetToDefaults() {
    const AdaptiveOtfConfig before = m_config;
    forgetRulesNotChosen();
    setConfig(AdaptiveOtfConfig{});
    if (m_config != before) emit configChanged(config());
}

void MethodPanel::showResult(const AdaptiveOtf& result) {
    QString summary = tr("%1 of %2 tube cores").arg(result.tubesWithWeight).arg(result.tubesMeetingVolume);
    if (result.tubesWithWeight > 0) {
        const QLocale locale;
        const MeanInterface mean = meanInterfaceOf(result);
        summary += QStringLiteral(" · I_L %1 · I_H %2")
                       .arg(locale.toString(mean.low, 'f', 2), locale.toString(mean.high, 'f', 2));
    }
    m_summary->setText(summary);
    m_message->setText(QString::fromStdString(result.message));
    m_message->setVisible(!result.message.empty());
}

void MethodPanel::clearResult() {
    m_summary->setText(tr("Not computed yet"));
    m_message->clear();
    m_message->hide();
}

}  // namespace echolucent
