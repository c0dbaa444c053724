// A control for each parameter of an OTF designer, made from its table.
#pragma once

#include <QString>
#include <QWidget>
#include <map>
#include <optional>
#include <string_view>

#include "processing/designers/designer_config.h"
#include "widgets/panels/parameter_controls.h"

namespace echolucent {

/// Those that mean nothing beside what is chosen are hidden. A control's object name is "designer." and the row's name
/// in camel case
/// ("designer.fluidOpacity"). A number that no person has moved keeps all its digits, whatever the control shows.
class DesignerParameters : public QWidget {
    Q_OBJECT

public:
    explicit DesignerParameters(QWidget* parent = nullptr);

    /// Emits nothing. The controls of another designer take the place of those before.
    void setConfig(const DesignerConfig& config);

signals:
    /// A person changed something; `label` is that of its row.
    void changed(const echolucent::DesignerConfig& config, const QString& label);

private:
    void makeControls();
    void showValues();
    void take(const AnyParameter& row, const ParameterValue& value);

    DesignerConfig m_config;
    std::map<std::string_view, ParameterControl> m_controls;  ///< by the row's name
    bool m_made = false;
};

/// The config with the parameter "threshold" set, and with the choice made that it belongs to; nothing where the
/// designer has no such parameter. Clamped into its range.
[[nodiscard]] std::optional<DesignerConfig> withThreshold(DesignerConfig config, double intensity);
/// Where that parameter plays a part, its value.
[[nodiscard]] std::optional<double> thresholdOf(const DesignerConfig& config);

/// The config with a parameter set, which must be in its table; where it means nothing there, the config as it was.
[[nodiscard]] DesignerConfig withParameter(DesignerConfig config, std::string_view name, const ParameterValue& value);

}  // namespace echolucent
