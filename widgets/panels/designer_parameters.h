// A control for each parameter of an OTF designer, made from its table.
#pragma once

#include <QString>
#include <QWidget>
#include <map>
#include <optional>
#include <string_view>

#include "processing/designers/choice/designer_config.h"
#include "processing/volume/value_scale.h"
#include "widgets/controls/parameter_controls.h"

namespace echolucent {

/// Parameters that have no meaning beside the present choices are hidden. The object name of a control is the prefix, a
/// dot, and the row's name in camel case ("designer.fluidOpacity"). A number keeps all its digits until a person moves
/// it, however few its control shows.
class DesignerParameters : public QWidget {
    Q_OBJECT

public:
    explicit DesignerParameters(QString prefix = QStringLiteral("designer"), QWidget* parent = nullptr);

    /// Makes new controls if the designer is another one. Emits nothing.
    void setConfig(const DesignerConfig& config);

    /// The file's values, of which the tool tip of an intensity says one.
    void setValueWindow(const ValueWindow& window);

signals:
    /// A person changed something; `label` is that of its row.
    void changed(const echolucent::DesignerConfig& config, const QString& label);

private:
    void makeControls();
    void showValues();
    void take(const AnyParameter& row, const ParameterValue& value);

    void showThreshold();

    QString m_prefix;
    DesignerConfig m_config;
    ValueWindow m_values;
    QString m_meaning;                                        // of the threshold
    std::map<std::string_view, ParameterControl> m_controls;  ///< by the row's name
    bool m_made = false;
};

/// Sets the parameter "threshold", clamped into its range. If it belongs to a choice, makes that choice too. No value
/// if the designer has no such parameter.
[[nodiscard]] std::optional<DesignerConfig> withThreshold(DesignerConfig config, double intensity);
/// The value of the parameter "threshold"; no value if it plays no part.
[[nodiscard]] std::optional<double> thresholdOf(const DesignerConfig& config);

/// Sets a parameter, which must be in its table. If it has no meaning in this config, the config stays the same.
[[nodiscard]] DesignerConfig withParameter(DesignerConfig config, std::string_view name, const ParameterValue& value);

}  // namespace echolucent
