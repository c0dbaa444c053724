#include "widgets/tube_cores/reading_parameters.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <optional>

namespace echolucent {

namespace {

struct Offered {
    std::string_view name;
    std::optional<ParameterRange> range{};  ///< empty: the row's own
    std::optional<ParameterSteps> steps{};  ///< empty: the row's own
};

constexpr ParameterSteps byOne{1, 0};

/// In the order in which the method comes to them.
constexpr std::array offeredRows{
    Offered{"cell_size"},
    Offered{"coarsest_scale"},
    Offered{"finest_scale"},
    Offered{"significance"},
    Offered{"tracking_range", ParameterRange{0, 10}, ParameterSteps{0.5, 1}},
    Offered{"least_edge_to_noise", ParameterRange{0, 20}, ParameterSteps{0.5, 1}},
    Offered{"false_alarm"},
    Offered{"slabs_before", ParameterRange{1, 40}, byOne},
    Offered{"slabs_behind", ParameterRange{1, 40}, byOne},
    Offered{"least_fluid", ParameterRange{1, 40}, byOne},
    Offered{"low_reach", ParameterRange{0, 60}, byOne},
    Offered{"high_reach", ParameterRange{0, 60}, byOne},
    Offered{"slope_half_step"},
    Offered{"strength"},
    Offered{"ramp_begin", ParameterRange{-1, 3}, ParameterSteps{0.05, 2}},
    Offered{"ramp_end", ParameterRange{-1, 5}, ParameterSteps{0.05, 2}},
};

ParameterTable<AdaptiveOtfConfig> madeTable() {
    ParameterTable<AdaptiveOtfConfig> table{{}, methodParameters().standard, methodParameters().problem};
    // The rules' own rows say when the others apply. They have no slider.
    for (const std::string_view rule : {"interface_function", "form"}) {
        table.rows.push_back(*parameterNamed(methodParameters(), rule));
        table.rows.back().inPanels = false;
    }
    for (const Offered& offered : offeredRows) {
        Parameter<AdaptiveOtfConfig> row = *parameterNamed(methodParameters(), offered.name);
        if (offered.range) row.offered = offered.range;
        if (offered.steps) row.steps = offered.steps;
        row.inPanels = true;
        table.rows.push_back(std::move(row));
    }
    return table;
}

/// The config after a person has set the row of this name.
AdaptiveOtfConfig withoutCrossing(AdaptiveOtfConfig config, std::string_view set) {
    if (auto* variance = std::get_if<VarianceRule>(&config.detection)) {
        if (set == "finest_scale")
            variance->coarsestScale = std::max(variance->coarsestScale, variance->finestScale);
        else
            variance->finestScale = std::min(variance->finestScale, variance->coarsestScale);
    }
    if (auto* ramp = std::get_if<RampRule>(&config.curve)) {
        constexpr double apart = 0.05;
        if (set == "ramp_end")
            ramp->begin = std::min(ramp->begin, ramp->end - apart);
        else
            ramp->end = std::max(ramp->end, ramp->begin + apart);
    }
    return config;
}

}  // namespace

const ParameterTable<AdaptiveOtfConfig>& readingParameters() {
    static const ParameterTable<AdaptiveOtfConfig> table = madeTable();
    return table;
}

ReadingParameters::ReadingParameters(const QString& group, QWidget* parent)
    : QWidget(parent),
      m_controls(readingParameters(), group, NumberControl::resettingSlider,
                 [this](const AdaptiveOtfConfig& config, const AnyParameter& row) {
                     const AdaptiveOtfConfig valid = withoutCrossing(config, row.name);
                     setConfig(valid);
                     emit configChanged(valid);
                 }) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    for (const Parameter<AdaptiveOtfConfig>& row : readingParameters()) {
        if (!row.inPanels) continue;
        const ParameterControl& control = m_controls.of(row.name);
        auto* line = new QWidget;
        auto* layout = new QVBoxLayout(line);
        layout->setContentsMargins(0, 0, 0, 0);
        layout->setSpacing(0);
        layout->addWidget(control.label);
        layout->addWidget(control.widget);
        column->addWidget(line);
        m_lines.emplace(row.name, line);
    }
    showThoseThatApply();
}

void ReadingParameters::setConfig(const AdaptiveOtfConfig& config) {
    m_controls.setValues(config);
    showThoseThatApply();
}

void ReadingParameters::showThoseThatApply() {
    for (const Parameter<AdaptiveOtfConfig>& row : readingParameters())
        if (row.inPanels) m_lines.at(row.name)->setVisible(row.get(m_controls.values()).has_value());
}

}  // namespace echolucent
