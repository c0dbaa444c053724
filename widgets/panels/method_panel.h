// The parameters of the adaptive OTF, and what it found.
#pragma once

#include <QWidget>
#include <array>
#include <functional>
#include <vector>

#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/document/method_choice.h"
#include "processing/parameter.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSpinBox;
class QToolButton;

namespace echolucent {

class ValueSlider;

/// Objects: adaptive.strength (+ .value; product) or .rampOpacity (+ .value; ramp), .form, .initial, .opacityScale,
/// .compute, .reset, .summary, .message, .advanced and, under it, .reading, .interfaceFunction, .tubeColumns,
/// .tubeRows, .tubeSpacing, .cellSize, .slopeHalfStep, for the ratio .falseAlarm, for the variance .coarsestScale,
/// .finestScale, .significance.
class MethodPanel : public QWidget {
    Q_OBJECT

public:
    explicit MethodPanel(QWidget* parent = nullptr);

    /// What the panel shows. `initial` is a PowerCurve for the kinds parabolic and quartic. For linear and manual it is
    /// the last curve of that kind given to setConfig (else an empty one): the window puts the editor's curve there.
    /// Parameters without a control are as last set.
    [[nodiscard]] AdaptiveOtfConfig config() const { return m_config; }
    [[nodiscard]] InitialKind initialKind() const;
    /// a of the parabolic and quartic initial functions.
    [[nodiscard]] double opacityScale() const;

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
    /// A control of one number of the method.
    struct NumberControl {
        const Row* row;
        QWidget* widget;
        std::function<void(double)> show;  ///< shows a value; emits nothing
    };

    QWidget* createMainControls();
    QWidget* createAdvancedControls();
    QSpinBox* createSpinBox(const char* parameter);
    QDoubleSpinBox* createDoubleSpinBox(const char* parameter, int decimals, double step);
    ValueSlider* createSlider(const char* parameter, double step);
    template <typename Control>
    void bind(const Row& row, Control* control);
    void createMethodChoices();
    QComboBox* createChoice(const char* parameter);
    void connectControls();
    void showConfig();
    void showReading();
    void showInitial();
    void takeReading();
    void takeNumber(const Row& row, double value);
    void takeDetection();
    void takeForm();
    void changed();
    /// What was last set of rules that are not chosen goes back to its defaults.
    void forgetRulesNotChosen();
    void takeInitial();
    void resetToDefaults();

    AdaptiveOtfConfig m_config;
    OpacityCurve m_linear = LinearCurve{};  // last given to setConfig
    OpacityCurve m_manual = ManualCurve{};
    // What was last set of each alternative, by its index, so that choosing another and coming back loses nothing.
    std::array<DetectionRule, 2> m_detections{VarianceRule{}, RatioRule{}};
    std::array<CurveRule, 2> m_curves{ProductRule{}, RampRule{}};
    std::vector<NumberControl> m_numbers;
    ValueSlider* m_strength = nullptr;
    ValueSlider* m_rampOpacity = nullptr;
    QLabel* m_strengthLabel = nullptr;
    QLabel* m_rampOpacityLabel = nullptr;
    QComboBox* m_form = nullptr;
    QComboBox* m_reading = nullptr;
    QComboBox* m_interfaceFunction = nullptr;
    QComboBox* m_initial = nullptr;
    QDoubleSpinBox* m_opacityScale = nullptr;
    QToolButton* m_advanced = nullptr;
    QLabel* m_summary = nullptr;
    QLabel* m_message = nullptr;
};

}  // namespace echolucent
