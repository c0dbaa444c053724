#include "widgets/panels/designer_parameters.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <algorithm>
#include <cmath>
#include <utility>

#include "processing/designers/designer.h"
#include "processing/picture/look.h"
#include "widgets/panels/panel_controls.h"
#include "widgets/panels/short_spin_box.h"

namespace echolucent {

/// What the tables of all designers say of a row, whatever config it is of.
struct DesignerParameters::Row {
    std::string name;
    QString label, toolTip;
    std::string_view unit;
    ParameterRange offered;
    std::vector<std::string_view> choices;
};

namespace {

QString designerObjectName(const std::string& name) { return "designer." + QString::fromStdString(camelCase(name)); }

/// The column of panels is narrow: units are short.
QString suffixOf(std::string_view unit) {
    if (unit.empty() || unit == "share" || unit.size() > 8) return {};
    return unit == "percent" ? QStringLiteral(" %") : " " + textOf(unit);
}

double stepFor(const ParameterRange& range) {
    const double span = range.largest - range.least;
    return span <= 2.0 ? 0.05 : span <= 20.0 ? 0.25 : 1.0;
}

}  // namespace

DesignerConfig withParameter(DesignerConfig config, std::string_view name, const ParameterValue& value) {
    forEachParameter(config, [&](const auto& row, auto& values) {
        if (row.name == name) row.set(values, value);
    });
    return config;
}

std::optional<DesignerConfig> withThreshold(DesignerConfig config, double intensity) {
    bool found = false;
    forEachParameter(config, [&](const auto& row, auto& values) {
        if (row.name != "threshold") return;
        for (const auto& other : parametersOf(values))
            if (!row.scope.parameter.empty() && other.name == row.scope.parameter)
                other.set(values, std::string(row.scope.choice));
        found = row.set(values, std::clamp(intensity, row.range.least, row.range.largest));
    });
    return found ? std::optional(std::move(config)) : std::nullopt;
}

std::optional<double> thresholdOf(const DesignerConfig& config) {
    std::optional<double> threshold;
    forEachParameter(config, [&](const auto& row, const auto& values) {
        if (row.name != "threshold") return;
        if (const auto value = row.get(values)) threshold = numberOf(*value);
    });
    return threshold;
}

DesignerParameters::DesignerParameters(QWidget* parent) : QWidget(parent) { new QGridLayout(this); }

void DesignerParameters::setConfig(const DesignerConfig& config) {
    const bool another = !m_made || config.index() != m_config.index();
    m_config = config;
    if (another) makeControls();
    showValues();
}

void DesignerParameters::makeControls() {
    m_made = true;
    for (const Control& control : m_controls) {
        delete control.label;
        delete control.widget;
    }
    m_controls.clear();
    delete layout();
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setColumnStretch(1, 1);
    // The kinds of all parameters are told by the defaults, with the choice made that a parameter belongs to.
    DesignerConfig standard = defaultConfigOf(designerOf(m_config));
    forEachParameter(standard, [&](const auto& row, auto& values) {
        auto scoped = values;
        if (!row.scope.parameter.empty())
            for (const auto& other : parametersOf(values))
                if (other.name == row.scope.parameter) other.set(scoped, std::string(row.scope.choice));
        const auto value = row.get(scoped);
        if (!value) return;
        const QString meaning = textOf(row.meaning);
        const Row words{std::string(row.name),
                        textOf(row.label),
                        row.unit == "units" ? tr("%1. A unit is the smallest voxel spacing").arg(meaning)
                        : suffixOf(row.unit).isEmpty() && row.unit.size() > 8
                            ? tr("%1, in %2").arg(meaning, textOf(row.unit))
                            : meaning,
                        row.unit,
                        row.offeredRange(),
                        row.choices};
        m_controls.push_back(std::holds_alternative<bool>(*value)          ? createFlag(words)
                             : std::holds_alternative<std::string>(*value) ? createChoice(words)
                                                                           : createNumber(words, *value));
        const int line = static_cast<int>(m_controls.size()) - 1;
        const Control& made = m_controls.back();
        if (made.label != nullptr) grid->addWidget(made.label, line, 0);
        if (made.label != nullptr)
            grid->addWidget(made.widget, line, 1);
        else
            grid->addWidget(made.widget, line, 0, 1, 2);
    });
}

DesignerParameters::Control DesignerParameters::createFlag(const Row& row) {
    auto* box = named(new QCheckBox(row.label), designerObjectName(row.name), row.label, row.toolTip);
    connect(box, &QCheckBox::toggled, this,
            [this, name = row.name, label = row.label](bool on) { take(name, label, on); });
    return {row.name, nullptr, box, [box](const ParameterValue& value) {
                const QSignalBlocker blocker(box);
                box->setChecked(std::get<bool>(value));
            }};
}

DesignerParameters::Control DesignerParameters::createChoice(const Row& row) {
    auto* box = named(new QComboBox, designerObjectName(row.name), row.label, row.toolTip);
    for (const std::string_view choice : row.choices)
        box->addItem(QString::fromStdString(labelOfChoice(choice)).replace('_', ' '), textOf(choice));
    box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    wheelNeedsFocus(box);
    connect(box, &QComboBox::currentIndexChanged, this, [this, box, name = row.name, label = row.label] {
        take(name, label, box->currentData().toString().toStdString());
    });
    return {row.name, labelFor(box, row.label), box, [box](const ParameterValue& value) {
                const QSignalBlocker blocker(box);
                box->setCurrentIndex(box->findData(textOf(std::get<std::string>(value))));
            }};
}

DesignerParameters::Control DesignerParameters::createNumber(const Row& row, const ParameterValue& standard) {
    QWidget* widget = nullptr;
    std::function<void(const ParameterValue&)> show;
    if (std::holds_alternative<std::int64_t>(standard)) {
        auto* box = new QSpinBox;
        box->setRange(static_cast<int>(row.offered.least), static_cast<int>(row.offered.largest));
        box->setSuffix(suffixOf(row.unit));
        box->setKeyboardTracking(false);
        connect(box, &QSpinBox::valueChanged, this,
                [this, name = row.name, label = row.label](int value) { take(name, label, std::int64_t{value}); });
        show = [box](const ParameterValue& value) {
            const QSignalBlocker blocker(box);
            box->setValue(static_cast<int>(numberOf(value).value()));
        };
        widget = box;
    } else {
        auto* box = new ShortSpinBox;
        box->setDecimals(3);
        box->setRange(row.offered.least, row.offered.largest);
        box->setSingleStep(stepFor(row.offered));
        box->setSuffix(suffixOf(row.unit));
        box->setKeyboardTracking(false);  // "25" is one value, not 2 and then 25
        connect(box, &QDoubleSpinBox::valueChanged, this,
                [this, name = row.name, label = row.label](double value) { take(name, label, value); });
        show = [box](const ParameterValue& value) {
            const QSignalBlocker blocker(box);
            box->setValue(std::round(1000.0 * numberOf(value).value()) / 1000.0);
        };
        widget = box;
    }
    named(widget, designerObjectName(row.name), row.label, row.toolTip);
    widget->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    wheelNeedsFocus(widget);
    return {row.name, labelFor(widget, row.label), widget, std::move(show)};
}

void DesignerParameters::take(const std::string& name, const QString& label, const ParameterValue& value) {
    const DesignerConfig next = withParameter(m_config, name, value);
    if (next == m_config) return;
    m_config = next;
    showValues();
    emit changed(m_config, label);
}

void DesignerParameters::showValues() {
    forEachParameter(std::as_const(m_config), [this](const auto& row, const auto& values) {
        const auto control = std::ranges::find(m_controls, row.name, &Control::name);
        if (control == m_controls.end()) return;
        const auto value = row.get(values);
        if (value) control->show(*value);
        control->widget->setVisible(value.has_value());
        if (control->label != nullptr) control->label->setVisible(value.has_value());
    });
}

}  // namespace echolucent
