#include "widgets/panels/method_panel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QStandardItemModel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <string_view>
#include <vector>

#include "processing/adaptive/method_parameters.h"
#include "processing/adaptive/method_reading.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/document/document_model.h"

namespace echolucent {
namespace {

/// Entry of the choice of readings if a parameter was changed. A person cannot choose it.
constexpr int changedReading = -1;

/// `mainRows` have a fixed place: above, and the interface function under Advanced, below the reading. Then follow
/// `advancedRows` in this order, and last the table's other rows.
constexpr std::array mainRows{std::string_view("strength"), std::string_view("ramp_opacity"), std::string_view("form"),
                              std::string_view("opacity_scale"), std::string_view("interface_function")};
constexpr std::array advancedRows{
    std::string_view("tube_columns"),   std::string_view("tube_rows"),    std::string_view("tube_spacing"),
    std::string_view("cell_size"),      std::string_view("false_alarm"),  std::string_view("slope_half_step"),
    std::string_view("coarsest_scale"), std::string_view("finest_scale"), std::string_view("significance")};

/// Clamps a parameter into its control's range. Leaves choices alone, and parameters without meaning in the config.
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

MethodPanel::MethodPanel(QWidget* parent) : QWidget(parent) {
    setObjectName("adaptive");
    setAccessibleName(tr("Adaptive opacity transfer function"));
    createControls();
    createReading();
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(createMainControls());
    layout->addWidget(createAdvancedControls());
    layout->addStretch(1);
    showConfig();
}

void MethodPanel::showDocument(DocumentModel& document) {
    connect(this, &MethodPanel::configChanged, &document, [this, &document](const AdaptiveOtfConfig& config) {
        document.change(tr("method"), [&](Document& next) {
            next.method = {config, m_initialKind, m_opacityScale};
            next.method.config.initial = AdaptiveOtfConfig{}.initial;  // its kind and scale stand beside the config
        });
    });
    document.bind(&DocumentModel::methodChanged, this, [this](const Document& shown) { setConfig(configOf(shown)); });
}

void MethodPanel::createControls() {
    for (const Row& row : methodParameters()) {
        if (!row.inPanels) continue;
        const bool slider = row.name == "strength" || row.name == "ramp_opacity";
        m_controls.emplace(row.name, parameterControl({&row, defaultOf(methodParameters(), row)}, "adaptive",
                                                      slider ? NumberControl::slider : NumberControl::spinBox, this,
                                                      [this, &row](const auto& value) { take(row, value); }));
    }
    const auto& initial = *parameterNamed(initialFunctionParameters(), "initial");
    m_initial = parameterControl({&initial, defaultOf(initialFunctionParameters(), initial)}, "adaptive",
                                 NumberControl::spinBox, this, [this](const ParameterValue& value) {
                                     takeInitial(initialKindFromName(std::get<std::string>(value)).value());
                                 });
    // Short labels, as the column is narrow.
    m_initial.label->setText(tr("Initial"));
    of("opacity_scale").label->setText(tr("Scale a"));
    of("interface_function").label->setText(tr("Interface"));
    QWidget* scale = of("opacity_scale").widget;
    scale->setToolTip(tr("%1. The piecewise linear curve and the manual nodes bring their own").arg(scale->toolTip()));
    qobject_cast<QDoubleSpinBox*>(of("tube_spacing").widget)->setSpecialValueText(tr("automatic"));
}

void MethodPanel::createReading() {
    m_reading = named(new QComboBox, "adaptive.reading", tr("Reading"),
                      tr("How the method is understood, all parameters at once. As published: the paper's words taken "
                         "literally, but for eq. 5, which is mended, and for voxels of less speckle, of which the "
                         "curve is made if speckle is reduced. Settled: its open points settled by experiment. "
                         "Version 0.1: what the program took before it had an aim. Default: what it takes now"));
    wheelNeedsFocus(m_reading);
    m_reading->addItem(tr("As published"), static_cast<int>(MethodReading::asPublished));
    m_reading->addItem(tr("Settled"), static_cast<int>(MethodReading::settled));
    m_reading->addItem(tr("Version 0.1"), static_cast<int>(MethodReading::firstVersion));
    m_reading->addItem(tr("Default"), static_cast<int>(MethodReading::standard));
    m_reading->addItem(tr("Changed"), changedReading);
    qobject_cast<QStandardItemModel*>(m_reading->model())->item(m_reading->count() - 1)->setEnabled(false);
    connect(m_reading, &QComboBox::currentIndexChanged, this, &MethodPanel::takeReading);
}

QWidget* MethodPanel::createMainControls() {
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
    grid->setHorizontalSpacing(4);  // so that both forms fit the column
    grid->setContentsMargins(0, 0, 0, 0);
    for (const std::string_view ofTheForm : {"strength", "ramp_opacity"}) {  // the form shows one of the two
        grid->addWidget(of(ofTheForm).label, 0, 0);
        grid->addWidget(of(ofTheForm).widget, 0, 1, 1, 3);
    }
    grid->addWidget(of("form").label, 1, 0);
    grid->addWidget(of("form").widget, 1, 1, 1, 3);
    grid->addWidget(m_initial.label, 2, 0);
    grid->addWidget(m_initial.widget, 2, 1);
    grid->addWidget(of("opacity_scale").label, 2, 2);
    grid->addWidget(of("opacity_scale").widget, 2, 3);
    grid->addWidget(compute, 3, 0, 1, 3);
    grid->addWidget(reset, 3, 3);
    grid->addWidget(m_summary, 4, 0, 1, 4);
    grid->addWidget(m_message, 5, 0, 1, 4);
    grid->setColumnStretch(1, 1);
    clearResult();
    return controls;
}

QWidget* MethodPanel::createAdvancedControls() {
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
    auto add = [grid, line = 0](QLabel* label, QWidget* control) mutable {
        grid->addWidget(label, line, 0);
        grid->addWidget(control, line++, 1);
    };
    add(labelFor(m_reading, tr("Reading")), m_reading);
    add(of("interface_function").label, of("interface_function").widget);
    std::vector<std::string_view> rows(advancedRows.begin(), advancedRows.end());
    for (const Row& row : methodParameters())
        if (row.inPanels && std::ranges::find(mainRows, row.name) == mainRows.end() &&
            std::ranges::find(rows, row.name) == rows.end())
            rows.push_back(row.name);
    for (const std::string_view row : rows) {
        of(row).widget->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        add(of(row).label, of(row).widget);
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

bool MethodPanel::applies(const Row& row) const {
    return row.get(m_config).has_value() &&
           (row.name != "opacity_scale" || std::holds_alternative<PowerCurve>(m_config.initial));
}

void MethodPanel::take(const Row& row, const ParameterValue& value) {
    row.set(m_config, value);
    // If there would be too many tube cores, the count that the person did not set follows.
    TubeGrid& grid = m_config.grid;
    if (row.name == "tube_columns")
        grid.rows = std::min(grid.rows, mostTubeCores / grid.columns);
    else if (row.name == "tube_rows")
        grid.columns = std::min(grid.columns, mostTubeCores / grid.rows);
    if (!row.choices.empty()) {
        m_config.detection = m_detections[m_config.detection.index()];
        m_config.curve = m_curves[m_config.curve.index()];
    } else if (auto* variance = std::get_if<VarianceRule>(&m_config.detection)) {
        // If the scales cross, the scale that the person did not set follows.
        if (row.name == "coarsest_scale")
            variance->finestScale = std::min(variance->finestScale, variance->coarsestScale);
        else
            variance->coarsestScale = std::max(variance->finestScale, variance->coarsestScale);
    }
    changed();
}

void MethodPanel::takeInitial(InitialKind kind) {
    switch (kind) {
        case InitialKind::parabolic: m_config.initial = PowerCurve{2, m_opacityScale}; break;
        case InitialKind::quartic: m_config.initial = PowerCurve{4, m_opacityScale}; break;
        case InitialKind::linear: m_config.initial = m_linear; break;
        case InitialKind::manual: m_config.initial = m_manual; break;
    }
    changed();
}

void MethodPanel::takeReading() {
    const int reading = m_reading->currentData().toInt();
    if (reading == changedReading) return;
    AdaptiveOtfConfig config = configOf(static_cast<MethodReading>(reading));
    config.initial = m_config.initial;
    forgetRulesNotChosen();
    setConfig(config);
    emit configChanged(m_config);
}

void MethodPanel::changed() {
    showConfig();
    emit configChanged(m_config);
}

void MethodPanel::setConfig(const AdaptiveOtfConfig& config) {
    m_config = config;
    for (const Row& row : methodParameters())
        if (row.inPanels && applies(row)) clampInto(row, m_config);
    if (auto* variance = std::get_if<VarianceRule>(&m_config.detection))
        variance->finestScale = std::min(variance->finestScale, variance->coarsestScale);
    showConfig();
}

void MethodPanel::showConfig() {
    m_detections[m_config.detection.index()] = m_config.detection;
    m_curves[m_config.curve.index()] = m_config.curve;
    showInitial();
    for (const Row& row : methodParameters()) {
        if (!row.inPanels) continue;
        if (applies(row))
            of(row.name).show(*row.get(m_config));
        else if (const auto value = valueIfChosen(row))
            of(row.name).show(*value);
        enableOrSayWhy(*of(row.name).widget, applies(row), whyGreyed(row));
    }
    showReading();
}

/// The value that a row of a rule not chosen will have once its rule is.
std::optional<ParameterValue> MethodPanel::valueIfChosen(const Row& row) const {
    if (row.scope.parameter.empty()) return std::nullopt;
    AdaptiveOtfConfig other = m_config;
    other.detection = m_detections[1 - m_config.detection.index()];
    other.curve = m_curves[1 - m_config.curve.index()];
    return row.get(other);
}

void MethodPanel::showInitial() {
    if (auto* power = std::get_if<PowerCurve>(&m_config.initial)) {
        // The panel offers two exponents. Another one, perhaps from a file, becomes the nearer of them.
        power->exponent = power->exponent < 4 ? 2 : 4;
        m_initialKind = power->exponent == 2 ? InitialKind::parabolic : InitialKind::quartic;
        m_opacityScale = power->scale;
    } else if (std::holds_alternative<LinearCurve>(m_config.initial)) {
        m_initialKind = InitialKind::linear;
        m_linear = m_config.initial;
    } else {
        m_initialKind = InitialKind::manual;
        m_manual = m_config.initial;
    }
    m_initial.show(std::string(nameOf(m_initialKind)));
}

void MethodPanel::showReading() {
    const auto reading = readingOf(m_config);
    selectData(m_reading, reading ? static_cast<int>(*reading) : changedReading);
    const bool ramp = std::holds_alternative<RampRule>(m_config.curve);
    for (QWidget* ofProduct : {static_cast<QWidget*>(of("strength").label), of("strength").widget})
        ofProduct->setVisible(!ramp);
    for (QWidget* ofRamp : {static_cast<QWidget*>(of("ramp_opacity").label), of("ramp_opacity").widget})
        ofRamp->setVisible(ramp);
}

void MethodPanel::forgetRulesNotChosen() {
    m_detections = {DetectionRule(std::in_place_index<0>), DetectionRule(std::in_place_index<1>)};
    m_curves = {CurveRule(std::in_place_index<0>), CurveRule(std::in_place_index<1>)};
}

void MethodPanel::resetToDefaults() {
    const AdaptiveOtfConfig before = m_config;
    forgetRulesNotChosen();
    setConfig(AdaptiveOtfConfig{});
    if (m_config != before) emit configChanged(m_config);
}

void MethodPanel::showResult(const AdaptiveOtf& result) {
    QString summary = tr("%1 of %2 tube cores").arg(result.tubesWithWeight).arg(result.tubesMeetingVolume);
    if (result.tubesWithWeight > 0) {
        const QLocale locale = QLocale::c();
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
