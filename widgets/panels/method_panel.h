// The parameters of the adaptive OTF, and what it found.
#pragma once

#include <QWidget>

#include "processing/adaptive_otf.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSpinBox;
class QToolButton;

namespace echolucent {

class ValueSlider;

/// The kind of initial function that the adaptive method multiplies.
enum class InitialKind {
    parabolic,  ///< a x^2
    quartic,    ///< a x^4
    linear,     ///< the linear curve of the editor
    manual,     ///< the manual nodes of the editor
};

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
    /// Fields without a control (sigmaPerKernelSize, kernelCut) are as last set.
    [[nodiscard]] AdaptiveOtfConfig config() const { return m_config; }
    [[nodiscard]] InitialKind initialKind() const;
    /// a of the parabolic and quartic initial functions.
    [[nodiscard]] double opacityScale() const;

    /// Shows a configuration, each value clamped into its control's range; emits nothing. A sampled initial curve
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
    QWidget* createMainControls();
    QWidget* createAdvancedControls();
    void connectControls();
    void createMethodChoices();
    void showConfig();
    void showReading();
    void showInitial();
    void takeReading();
    void changed();
    void takeScales(int coarsest, int finest);
    void takeInitial();
    void resetToDefaults();

    AdaptiveOtfConfig m_config;
    OpacityCurve m_linear = LinearCurve{};  // last given to setConfig
    OpacityCurve m_manual = ManualCurve{};
    ValueSlider* m_strength = nullptr;
    ValueSlider* m_rampOpacity = nullptr;
    QLabel* m_strengthLabel = nullptr;
    QLabel* m_rampOpacityLabel = nullptr;
    QComboBox* m_form = nullptr;
    QComboBox* m_reading = nullptr;
    QComboBox* m_interfaceFunction = nullptr;
    QComboBox* m_initial = nullptr;
    QDoubleSpinBox* m_opacityScale = nullptr;
    QSpinBox* m_tubeColumns = nullptr;
    QSpinBox* m_tubeRows = nullptr;
    QDoubleSpinBox* m_tubeSpacing = nullptr;
    QSpinBox* m_cellSize = nullptr;
    QSpinBox* m_coarsestScale = nullptr;
    QSpinBox* m_finestScale = nullptr;
    QDoubleSpinBox* m_significance = nullptr;
    QDoubleSpinBox* m_falseAlarm = nullptr;
    QSpinBox* m_slopeHalfStep = nullptr;
    QToolButton* m_advanced = nullptr;
    QLabel* m_summary = nullptr;
    QLabel* m_message = nullptr;
};

}  // namespace echolucent
