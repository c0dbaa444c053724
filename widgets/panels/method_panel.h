// The parameters of the adaptive OTF, and what it found.
#pragma once

#include <QWidget>
#include <array>
#include <map>
#include <string_view>

#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/document/method_choice.h"
#include "processing/parameters/parameter.h"
#include "widgets/panels/parameter_controls.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace echolucent {

class DocumentModel;

/// Objects: adaptive.strength (+ .value; product) or .rampOpacity (+ .value; ramp), .form, .initial, .opacityScale,
/// .compute, .reset, .summary, .message, .advanced and, under it, .reading, .interfaceFunction, .tubeColumns,
/// .tubeRows, .tubeSpacing, .cellSize, .slopeHalfStep, for the ratio .falseAlarm, for the variance .coarsestScale,
/// .finestScale, .significance.
class MethodPanel : public QWidget {
    Q_OBJECT

public:
    explicit MethodPanel(QWidget* parent = nullptr);
    /// Shows the document's method from here on, and makes steps of what is set. The document outlives the panel.
    void showDocument(DocumentModel& document);

    /// What the panel shows. `initial` is a PowerCurve for the kinds parabolic and quartic. For linear and manual it is
    /// the last curve of that kind given to setConfig (else an empty one): the window puts the editor's curve there.
    /// Parameters without a control are as last set.
    [[nodiscard]] AdaptiveOtfConfig config() const { return m_config; }
    [[nodiscard]] InitialKind initialKind() const { return m_initialKind; }
    /// a of the parabolic and quartic initial functions.
    [[nodiscard]] double opacityScale() const { return m_opacityScale; }

    /// Shows a configuration, each value clamped into what its control offers; emits nothing. A sampled initial curve
    /// counts as manual.
    void setConfig(const AdaptiveOtfConfig& config);
    /// Shows what was found: the summary line and the result's message, if any.
    void showResult(const AdaptiveOtf& result);
    /// Empties the summary and the message, for example when another volume is opened.
    void clearResult();

signals:
    /// The person changed a parameter; `initial` as in config().
    void configChanged(const echolucent::AdaptiveOtfConfig& config);
    /// The person asked for the OTF of the direction in which the camera looks.
    void computeRequested();

private:
    using Row = Parameter<AdaptiveOtfConfig>;

    void createControls();
    void createReading();
    QWidget* createMainControls();
    QWidget* createAdvancedControls();
    /// Of a row that the panel has.
    [[nodiscard]] const ParameterControl& of(std::string_view name) const { return m_controls.at(name); }
    /// Whether the person can set a row; the scale belongs to the powers alone.
    [[nodiscard]] bool applies(const Row& row) const;
    void showConfig();
    void showReading();
    void showInitial();
    void take(const Row& row, const ParameterValue& value);
    void takeReading();
    void takeInitial(InitialKind kind);
    void changed();
    /// What was last set of rules that are not chosen goes back to its defaults.
    void forgetRulesNotChosen();
    void resetToDefaults();

    AdaptiveOtfConfig m_config;
    OpacityCurve m_linear = LinearCurve{};  // last given to setConfig
    OpacityCurve m_manual = ManualCurve{};
    InitialKind m_initialKind = InitialKind::parabolic;
    double m_opacityScale = defaultOpacityScale;  // last of a power
    // What was last set of each alternative, by its index, so that choosing another and coming back loses nothing.
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
