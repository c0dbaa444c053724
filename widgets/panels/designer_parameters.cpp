#include "widgets/panels/designer_parameters.h"

#include <QGridLayout>
#include <QLabel>
#include <algorithm>
#include <utility>

#include "processing/designers/choice/designer.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/controls/value_text.h"

namespace echolucent {

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
        chooseScope(parametersOf(values), row, values);
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

DesignerParameters::DesignerParameters(QString prefix, QWidget* parent) : QWidget(parent), m_prefix(std::move(prefix)) {
    new QGridLayout(this);
}

void DesignerParameters::setConfig(const DesignerConfig& config) {
    const bool another = !m_made || config.index() != m_config.index();
    m_config = config;
    if (another) makeControls();
    showValues();
}

void DesignerParameters::makeControls() {
    m_made = true;
    for (const auto& [name, control] : m_controls) {
        delete control.label;
        delete control.widget;
    }
    m_controls.clear();
    delete layout();
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setColumnStretch(1, 1);
    const auto rows = std::visit([](const auto& values) { return defaultsOf(parametersOf(values)); }, m_config);
    for (const ParameterDefault& row : rows) {
        if (!row.row->inPanels) continue;
        const ParameterControl made =
            parameterControl(row, m_prefix, NumberControl::spinBox, this,
                             [this, &described = *row.row](const auto& value) { take(described, value); });
        made.widget->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        const int line = static_cast<int>(m_controls.size());
        if (made.label != nullptr) grid->addWidget(made.label, line, 0);
        grid->addWidget(made.widget, line, made.label != nullptr ? 1 : 0, 1, made.label != nullptr ? 1 : 2);
        m_controls.emplace(row.row->name, made);
        if (row.row->name == "threshold") m_meaning = made.widget->toolTip();
    }
}

void DesignerParameters::take(const AnyParameter& row, const ParameterValue& value) {
    const DesignerConfig next = withParameter(m_config, row.name, value);
    if (next == m_config) return;
    m_config = next;
    showValues();
    emit changed(m_config, textOf(row.label));
}

void DesignerParameters::showValues() {
    forEachParameter(std::as_const(m_config), [this](const auto& row, const auto& values) {
        const auto found = m_controls.find(row.name);
        if (found == m_controls.end()) return;
        const auto value = row.get(values);
        if (value) found->second.show(*value);
        found->second.widget->setVisible(value.has_value());
        if (found->second.label != nullptr) found->second.label->setVisible(value.has_value());
    });
    showThreshold();
}

void DesignerParameters::setValueWindow(const ValueWindow& window) {
    m_values = window;
    if (m_made) showThreshold();
}

void DesignerParameters::showThreshold() {
    const auto found = m_controls.find("threshold");
    const auto threshold = thresholdOf(m_config);
    // Kindlmann's is a gradient.
    if (found == m_controls.end() || !threshold || std::holds_alternative<KindlmannConfig>(m_config)) return;
    QString tip = m_meaning;
    if (!m_values.isNormalised())
        tip += "\n" + tr("%1 is %2 in the file's values")
                          .arg(*threshold, 0, 'f', 3)
                          .arg(valueText(m_values.valueAt(*threshold), m_values));
    found->second.widget->setToolTip(tip);
}

}  // namespace echolucent
