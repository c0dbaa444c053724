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

#include "widgets/panels/panel_controls.h"
#include "widgets/panels/value_slider.h"

namespace echolucent {
namespace {

QSpinBox* createSpinBox(const QString& name, const QString& accessibleName, const QString& toolTip, int minimum,
                        int maximum, const QString& suffix = {}) {
    auto* spinBox = named(new QSpinBox, "adaptive." + name, accessibleName, toolTip);
    spinBox->setRange(minimum, maximum);
    spinBox->setSuffix(suffix);
    spinBox->setKeyboardTracking(false);
    wheelNeedsFocus(spinBox);
    return spinBox;
}

QDoubleSpinBox* createDoubleSpinBox(const QString& name, const QString& accessibleName, const QString& toolTip,
                                    double maximum, int decimals, double step, const QString& suffix = {}) {
    auto* spinBox = named(new QDoubleSpinBox, "adaptive." + name, accessibleName, toolTip);
    spinBox->setDecimals(decimals);
    spinBox->setRange(0, maximum);
    spinBox->setSingleStep(step);
    spinBox->setSuffix(suffix);
    spinBox->setKeyboardTracking(false);
    wheelNeedsFocus(spinBox);
    return spinBox;
}

template <typename SpinBox, typename Value>
void showIn(SpinBox* spinBox, Value value) {
    const QSignalBlocker blocker(spinBox);
    spinBox->setValue(value);
}

template <typename Control, typename Value>
Value clampedInto(const Control* control, Value value) {
    return std::clamp<Value>(value, control->minimum(), control->maximum());
}

/// Mean of I_L or I_H over the tube cores with a surface, weighted by what they bring to the curve.
double weightedMean(const AdaptiveOtf& result, std::optional<double> TubeCore::*intensity) {
    double sum = 0.0;
    double weight = 0.0;
    for (const TubeCore& tube : result.tubes) {
        if (!(tube.*intensity).has_value()) continue;
        sum += tube.d * (tube.*intensity).value();
        weight += tube.d;
    }
    return weight > 0.0 ? sum / weight : 0.0;
}

}  // namespace

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
    m_strength = new ValueSlider("adaptive.strength", tr("Strength"), 0.25, 2);
    m_strength->setRange(0, 40);
    m_strength->setToolTip(
        tr("How far the found surfaces bend the initial function: number of tube cores times the "
           "largest weight of one"));
    m_rampOpacity = new ValueSlider("adaptive.rampOpacity", tr("Opacity"), 0.01, 2);
    m_rampOpacity->setRange(0.01, 1);
    m_rampOpacity->setToolTip(tr("Opacity where all tube cores say surface"));
    m_strengthLabel = labelFor(m_strength, tr("Strength"));
    m_rampOpacityLabel = labelFor(m_rampOpacity, tr("Opacity"));
    m_initial = named(new QComboBox, "adaptive.initial", tr("Initial function"),
                      tr("The function that the method starts from"));
    m_initial->addItem(tr("x² (parabolic)"), static_cast<int>(InitialKind::parabolic));
    m_initial->addItem(tr("x⁴ (quartic)"), static_cast<int>(InitialKind::quartic));
    m_initial->addItem(tr("Linear curve"), static_cast<int>(InitialKind::linear));
    m_initial->addItem(tr("Manual nodes"), static_cast<int>(InitialKind::manual));
    wheelNeedsFocus(m_initial);
    m_opacityScale =
        createDoubleSpinBox("opacityScale", tr("Opacity scale a"),
                            tr("a: opacity of the initial function at full intensity. The linear curve and "
                               "the manual nodes bring their own"),
                            10, 2, 0.05);
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
    grid->setContentsMargins(0, 0, 0, 0);
    // One of the two, as the form has it.
    grid->addWidget(m_strengthLabel, 0, 0);
    grid->addWidget(m_strength, 0, 1, 1, 3);
    grid->addWidget(m_rampOpacityLabel, 0, 0);
    grid->addWidget(m_rampOpacity, 0, 1, 1, 3);
    grid->addWidget(labelFor(m_form, tr("Form")), 1, 0);
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
    m_tubeColumns = createSpinBox("tubeColumns", tr("Tube columns"), tr("Tube cores across the picture"), 1, 400);
    m_tubeRows = createSpinBox("tubeRows", tr("Tube rows"), tr("Tube cores down the picture"), 1, 400);
    m_tubeSpacing =
        createDoubleSpinBox("tubeSpacing", tr("Tube spacing"),
                            tr("Distance of neighbouring tube cores; automatic: the grid covers the volume. "
                               "A unit is the smallest voxel spacing"),
                            1000, 1, 1, tr(" units"));
    m_tubeSpacing->setSpecialValueText(tr("automatic"));
    m_cellSize =
        createSpinBox("cellSize", tr("Cell size"), tr("Edge of the cells along a tube core"), 2, 32, tr(" units"));
    m_coarsestScale = createSpinBox("coarsestScale", tr("Coarsest scale"),
                                    tr("n of the widest kernel, 2ⁿ units, in which a surface is looked for"), 1, 10);
    m_finestScale = createSpinBox("finestScale", tr("Finest scale"),
                                  tr("n of the narrowest kernel, 2ⁿ units, to which a surface is followed"), 1, 10);
    m_significance =
        createDoubleSpinBox("significance", tr("Significance"),
                            tr("A local maximum counts from this share of the largest value on"), 1, 2, 0.05);
    m_slopeHalfStep =
        createSpinBox("slopeHalfStep", tr("Slope half step"),
                      tr("The slope at a surface is taken over this many units to either side"), 1, 32, tr(" units"));

    m_falseAlarm =
        createDoubleSpinBox("falseAlarm", tr("Least contrast"),
                            tr("Ratio of means: a surface counts from this contrast on, in standard deviations "
                               "of the contrast where nothing is"),
                            20, 2, 0.25);

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
    grid->addWidget(m_reading, 0, 1, 1, 3);
    grid->addWidget(labelFor(m_interfaceFunction, tr("Interface")), 1, 0);
    grid->addWidget(m_interfaceFunction, 1, 1, 1, 3);
    constexpr int rowsAbove = 2;
    const std::array<QWidget*, 9> controls{m_tubeColumns,   m_tubeRows,      m_tubeSpacing, m_cellSize,    m_falseAlarm,
                                           m_slopeHalfStep, m_coarsestScale, m_finestScale, m_significance};
    for (int i = 0; i < static_cast<int>(controls.size()); ++i) {
        QWidget* control = controls[static_cast<std::size_t>(i)];
        control->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // two columns fit a narrow dock
        control->setMinimumWidth(84);
        grid->addWidget(labelFor(control, control->accessibleName()), rowsAbove + i / 2, 2 * (i % 2));
        grid->addWidget(control, rowsAbove + i / 2, 2 * (i % 2) + 1);
    }
    grid->setColumnStretch(1, 4);  // "automatic" is the longest text
    grid->setColumnStretch(3, 3);
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
    const auto changes = [this](auto* control, auto AdaptiveOtfConfig::*field) {
        using Control = std::remove_pointer_t<decltype(control)>;
        connect(control, &Control::valueChanged, this, [this, field](auto value) {
            m_config.*field = value;
            changed();
        });
    };
    changes(m_strength, &AdaptiveOtfConfig::strength);
    changes(m_rampOpacity, &AdaptiveOtfConfig::rampOpacity);
    changes(m_falseAlarm, &AdaptiveOtfConfig::falseAlarm);
    changes(m_tubeColumns, &AdaptiveOtfConfig::tubeColumns);
    changes(m_tubeRows, &AdaptiveOtfConfig::tubeRows);
    changes(m_tubeSpacing, &AdaptiveOtfConfig::tubeSpacing);
    changes(m_cellSize, &AdaptiveOtfConfig::cellSize);
    changes(m_significance, &AdaptiveOtfConfig::significance);
    changes(m_slopeHalfStep, &AdaptiveOtfConfig::slopeHalfStep);
    connect(m_coarsestScale, &QSpinBox::valueChanged, this,
            [this](int scale) { takeScales(scale, std::min(scale, m_config.finestScale)); });
    connect(m_finestScale, &QSpinBox::valueChanged, this,
            [this](int scale) { takeScales(std::max(scale, m_config.coarsestScale), scale); });
    connect(m_form, &QComboBox::currentIndexChanged, this, [this] {
        m_config.form = static_cast<CurveForm>(m_form->currentData().toInt());
        changed();
    });
    connect(m_interfaceFunction, &QComboBox::currentIndexChanged, this, [this] {
        m_config.interfaceFunction = static_cast<InterfaceFunction>(m_interfaceFunction->currentData().toInt());
        changed();
    });
    connect(m_reading, &QComboBox::currentIndexChanged, this, &MethodPanel::takeReading);
    connect(m_initial, &QComboBox::currentIndexChanged, this, &MethodPanel::takeInitial);
    connect(m_opacityScale, &QDoubleSpinBox::valueChanged, this, &MethodPanel::takeInitial);
}

void MethodPanel::takeScales(int coarsest, int finest) {
    m_config.coarsestScale = coarsest;
    m_config.finestScale = finest;
    showIn(m_coarsestScale, coarsest);
    showIn(m_finestScale, finest);
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
    m_config.strength = clampedInto(m_strength, config.strength);
    m_config.rampOpacity = clampedInto(m_rampOpacity, config.rampOpacity);
    m_config.falseAlarm = clampedInto(m_falseAlarm, config.falseAlarm);
    m_config.tubeColumns = clampedInto(m_tubeColumns, config.tubeColumns);
    m_config.tubeRows = clampedInto(m_tubeRows, config.tubeRows);
    m_config.tubeSpacing = clampedInto(m_tubeSpacing, config.tubeSpacing);
    m_config.cellSize = clampedInto(m_cellSize, config.cellSize);
    m_config.coarsestScale = clampedInto(m_coarsestScale, config.coarsestScale);
    m_config.finestScale = std::min(clampedInto(m_finestScale, config.finestScale), m_config.coarsestScale);
    m_config.significance = clampedInto(m_significance, config.significance);
    m_config.slopeHalfStep = clampedInto(m_slopeHalfStep, config.slopeHalfStep);
    showConfig();
}

void MethodPanel::showConfig() {
    showIn(m_strength, m_config.strength);
    showIn(m_rampOpacity, m_config.rampOpacity);
    showIn(m_falseAlarm, m_config.falseAlarm);
    showIn(m_tubeColumns, m_config.tubeColumns);
    showIn(m_tubeRows, m_config.tubeRows);
    showIn(m_tubeSpacing, m_config.tubeSpacing);
    showIn(m_cellSize, m_config.cellSize);
    showIn(m_coarsestScale, m_config.coarsestScale);
    showIn(m_finestScale, m_config.finestScale);
    showIn(m_significance, m_config.significance);
    showIn(m_slopeHalfStep, m_config.slopeHalfStep);
    selectData(m_form, static_cast<int>(m_config.form));
    selectData(m_interfaceFunction, static_cast<int>(m_config.interfaceFunction));
    showInitial();
    showReading();
}

void MethodPanel::showInitial() {
    InitialKind kind = InitialKind::manual;
    if (auto* power = std::get_if<PowerCurve>(&m_config.initial)) {
        // The panel offers two exponents; another one, from a file perhaps, becomes the nearer of them.
        power->exponent = power->exponent < 4 ? 2 : 4;
        power->scale = clampedInto(m_opacityScale, power->scale);
        kind = power->exponent == 2 ? InitialKind::parabolic : InitialKind::quartic;
        showIn(m_opacityScale, power->scale);
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
    setConfig(AdaptiveOtfConfig{});
    if (m_config != before) emit configChanged(config());
}

void MethodPanel::showResult(const AdaptiveOtf& result) {
    QString summary = tr("%1 of %2 tube cores").arg(result.tubesWithSurface).arg(result.tubesMeetingVolume);
    if (result.tubesWithSurface > 0) {
        const QLocale locale;
        summary += QStringLiteral(" · I_L %1 · I_H %2")
                       .arg(locale.toString(weightedMean(result, &TubeCore::lowIntensity), 'f', 2),
                            locale.toString(weightedMean(result, &TubeCore::highIntensity), 'f', 2));
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
