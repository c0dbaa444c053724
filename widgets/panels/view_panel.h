// How the picture is made: near cut, mode, light, colours, sampling, projection, renderer, beam axis and phase.
#pragma once

#include <QWidget>

#include "processing/picture/light_direction.h"
#include "processing/ray_caster.h"
#include "processing/viewpoint.h"
#include "widgets/panels/preferred_renderer.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLayout;
class QSlider;
class QSpinBox;

namespace echolucent {

class ValueSlider;

/// Objects: view.nearCut (+ .value, .suggest), view.mode (+ .remark), view.shaded, view.lightAzimuth (+ .value),
/// view.lightElevation (+ .value), view.depthColouring, view.colourMap, view.interpolation, view.projection,
/// view.renderer, view.beamAxis, view.phase (+ .value; hidden with one phase), view.reset, view.savePicture. What plays
/// no part in the mode chosen is disabled, and the remark says so of the curve. No setter emits a signal.
class ViewPanel : public QWidget {
    Q_OBJECT

public:
    explicit ViewPanel(QWidget* parent = nullptr);

    [[nodiscard]] double nearCutMm() const;
    void setNearCutMm(double mm);
    /// The near cut goes from 0 to maxMm (the depth of the volume along the view); a larger value is clamped silently.
    /// Where the spacing is not known, the number is marked as a guess.
    void setNearCutRange(double maxMm, bool spacingKnown = true);

    [[nodiscard]] RenderMode mode() const;
    void setMode(RenderMode mode);
    [[nodiscard]] bool shaded() const;
    void setShaded(bool shaded);
    /// In whole degrees.
    [[nodiscard]] LightDirection light() const;
    void setLight(const LightDirection& light);
    [[nodiscard]] bool depthColoured() const;
    void setDepthColoured(bool coloured);
    [[nodiscard]] ColourMap colourMap() const;
    void setColourMap(ColourMap map);
    [[nodiscard]] Interpolation interpolation() const;
    void setInterpolation(Interpolation interpolation);
    [[nodiscard]] Projection projection() const;
    void setProjection(Projection projection);
    [[nodiscard]] PreferredRenderer renderer() const;
    void setRenderer(PreferredRenderer renderer);
    /// Where it is not usable, it cannot be chosen. At first it is not.
    void setGraphicsCardUsable(bool usable);
    [[nodiscard]] BeamAxis beamAxis() const;
    void setBeamAxis(BeamAxis axis);

    /// Number of phases, at least 1; with 1 the selector is hidden. The phase becomes 0 where it was beyond.
    void setPhaseCount(int count);
    /// Phase, counted from 0 (people read it from 1).
    [[nodiscard]] int phase() const;
    void setPhase(int phase);

signals:
    void nearCutChanged(double mm);
    /// The person asks where to cut.
    void nearCutSuggestionRequested();
    void modeChanged(echolucent::RenderMode mode);
    void shadedChanged(bool shaded);
    void lightChanged(const echolucent::LightDirection& light);
    void depthColouredChanged(bool coloured);
    void colourMapChanged(echolucent::ColourMap map);
    void interpolationChanged(echolucent::Interpolation interpolation);
    void projectionChanged(echolucent::Projection projection);
    void rendererChanged(echolucent::PreferredRenderer renderer);
    void beamAxisChanged(echolucent::BeamAxis axis);
    /// Counted from 0.
    void phaseChanged(int phase);
    void resetRequested();
    void savePictureRequested();

private:
    void createChoices();
    void createLight();
    void createPhaseSelector();
    void connectControls();
    void arrange();
    QLayout* createNearCutRow();
    QLayout* createButtons();
    void updateForMode();
    void showPhase(int phase);

    ValueSlider* m_nearCut = nullptr;
    QComboBox* m_mode = nullptr;
    QLabel* m_modeRemark = nullptr;
    QCheckBox* m_shaded = nullptr;
    ValueSlider* m_lightAzimuth = nullptr;
    ValueSlider* m_lightElevation = nullptr;
    QCheckBox* m_depthColoured = nullptr;
    QComboBox* m_colourMap = nullptr;
    QComboBox* m_interpolation = nullptr;
    QComboBox* m_projection = nullptr;
    QComboBox* m_renderer = nullptr;
    QComboBox* m_beamAxis = nullptr;
    QLabel* m_phaseLabel = nullptr;
    QWidget* m_phaseSelector = nullptr;
    QSlider* m_phaseSlider = nullptr;
    QSpinBox* m_phaseSpinBox = nullptr;
};

}  // namespace echolucent
