// Sliders of the parameters on which the reading of a tube core depends.
#pragma once

#include <QWidget>
#include <map>
#include <string_view>

#include "processing/adaptive/method_parameters.h"
#include "widgets/controls/parameter_controls.h"

namespace echolucent {

/// The rows of methodParameters() that this panel offers: cells, detection, what is read around a surface, and the
/// form's strength or ramp. A range that is too wide for a slider is offered in the part that is of use.
[[nodiscard]] const ParameterTable<AdaptiveOtfConfig>& readingParameters();

/// A slider for each row that means something under the present rules; the others are hidden. Objects: GROUP.NAME, with
/// the row's name in camel case, as in the panel Method.
class ReadingParameters : public QWidget {
    Q_OBJECT

public:
    explicit ReadingParameters(const QString& group, QWidget* parent = nullptr);

    /// Shows a config. Emits nothing.
    void setConfig(const AdaptiveOtfConfig& config);

signals:
    /// A person has moved a slider. The config is valid (problemOf()): if two parameters would cross, the one that was
    /// not moved follows.
    void configChanged(const echolucent::AdaptiveOtfConfig& config);

private:
    void showThoseThatApply();

    ParameterControls<AdaptiveOtfConfig> m_controls;
    std::map<std::string_view, QWidget*> m_lines;  ///< label and slider of a row, by its name
};

}  // namespace echolucent
