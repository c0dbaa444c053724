// The parameters of the adaptive OTF, and what the method found.
#pragma once

#include <QWidget>
#include <array>
#include <map>
#include <optional>
#include <string_view>

#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/document/method_choice.h"
#include "processing/parameters/parameter.h"
#include "widgets/controls/parameter_controls.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace echolucent {

class DocumentModel;

/// Objects: adaptive.strength (+ .value; product) or .rampOpacity (+ .value; ramp), .form, .initial, .opacityScale,
/// .compute, .reset, .summary, .message, .advanced. Under Advanced: .reading, .interfaceFunction, .tubeColumns,
/// .tubeRows, .tubeSpacing, .cellSize, .slopeHalfStep, for the ratio .falseAlarm, for the variance .coarsestScale,
/// .finestScale, .significance.
class MethodPanel : public QWidget {
    Q_OBJECT

public:
    explicit MethodPanel(QWidget* parent = nullptr);
    /// Shows the document's method from now on. A person's changes become steps. The document outlives the panel.
    void showDocument(DocumentModel& document);

    /// What the panel shows. `initial` is a PowerCurve for the kinds parabolic and quartic. For linear and manual it is
    /// the last curve of that kind given to setConfig(), else the default one. Parameters without a control keep their
    /// last value.
    [[nodiscard]] AdaptiveOtfConfig config() const { return m_config; }
    [[nodiscard]] InitialKind initialKind() const { return m_initialKind; }
    /// a of the parabolic and quartic initial functions.
    [[nodiscard]] double opacityScale() const { return m_opacityScale; }

    /// Shows a configuration. Emits nothing. Each value is clamped into its control's range. A sampled initial curve
    /// counts as manual.
    void setConfig(const AdaptiveOtfConfig& config);
    /// Shows the summary line, and the result's message if there is one.
    void showResult(const AdaptiveOtf& result);
    /// Says "Not computed yet" in the summary line and hides the message, for example when another volume is opened.
    void clearResult();

signals:
    /// The person changed a parameter; `initial` as in config().
    void configChanged(const echolucent::AdaptiveOtfConfig& config);
    /// The person asked for the OTF of the present viewing direction.
    void computeRequested();

private:
    using Row = Parameter<AdaptiveOtfConfig>;

    void createControls();
    void createReading();
    QWidget* createMainControls();
    QWidget* createAdvancedControls();
    /// The row must have a control.
    [[nodiscard]] const ParameterControl& of(std::string_view name) const { return m_controls.at(name); }
    /// Whether the person can set a row. The scale belongs to the power curves alone.
    [[nodiscard]] bool applies(const Row& row) const;
    void showConfig();
    void showReading();
    [[nodiscard]] std::optional<ParameterValue> valueIfChosen(const Row& row) const;
    void showInitial();
    void take(const Row& row, const ParameterValue& value);
    void takeReading();
    void takeInitial(InitialKind kind);
    void changed();
    /// Sets the rules that are not chosen back to their defaults.
    void forgetRulesNotChosen();
    void resetToDefaults();

    AdaptiveOtfConfig m_config;
    OpacityCurve m_linear = LinearCurve{};  // last given to setConfig
    OpacityCurve m_manual = ManualCurve{};
    InitialKind m_initialKind = InitialKind::parabolic;
    double m_opacityScale = defaultOpacityScale;  // of the last power curve
    // The last values of each rule, by its index: a person may choose another rule and come back without loss.
    std::array<DetectionRule, 2> m_detections{VarianceRule{}, RatioRule{}};
    std::array<CurveRule, 2> m_curves{ProductRule{}, RampRule{}};
    std::map<std::string_view, ParameterControl> m_controls;  // by the row's name
    ParameterControl m_initial;
    QComboBox* m_reading = nullptr;
    QToolButton* m_advanced = nullptr;
    QLabel* m_summary = nullptr;
    QLabel* m_message = nullptr;
};

}  // namespace echolucent
