// How the picture is made: near cut, light, colours, sampling, projection, beam axis and phase.
#pragma once

#include <QWidget>

#include "processing/ray_caster.h"
#include "processing/view.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QSlider;
class QSpinBox;

namespace echolucent {

class ValueSlider;

/// Objects: view.nearCut (+ .value, .suggest), view.shaded, view.colourMap, view.interpolation, view.projection,
/// view.beamAxis, view.phase (+ .value; hidden with one phase), view.reset, view.savePicture. No setter emits a signal.
class ViewPanel : public QWidget {
    Q_OBJECT

public:
    explicit ViewPanel(QWidget* parent = nullptr);

    [[nodiscard]] double nearCutMm() const;
    void setNearCutMm(double mm);
    /// The near cut goes from 0 to maxMm (the depth of the volume along the view); a larger value is clamped silently.
    /// Where the spacing is not known, the number is marked as a guess.
    void setNearCutRange(double maxMm, bool spacingKnown = true);

    [[nodiscard]] bool shaded() const;
    void setShaded(bool shaded);
    [[nodiscard]] ColourMap colourMap() const;
    void setColourMap(ColourMap map);
    [[nodiscard]] Interpolation interpolation() const;
    void setInterpolation(Interpolation interpolation);
    [[nodiscard]] Projection projection() const;
    void setProjection(Projection projection);
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
    void shadedChanged(bool shaded);
    void colourMapChanged(echolucent::ColourMap map);
    void interpolationChanged(echolucent::Interpolation interpolation);
    void projectionChanged(echolucent::Projection projection);
    void beamAxisChanged(echolucent::BeamAxis axis);
    /// Counted from 0.
    void phaseChanged(int phase);
    void resetRequested();
    void savePictureRequested();

private:
    void createChoices();
    void createPhaseSelector();
    void arrange();
    void showPhase(int phase);

    ValueSlider* m_nearCut = nullptr;
    QCheckBox* m_shaded = nullptr;
    QComboBox* m_colourMap = nullptr;
    QComboBox* m_interpolation = nullptr;
    QComboBox* m_projection = nullptr;
    QComboBox* m_beamAxis = nullptr;
    QLabel* m_phaseLabel = nullptr;
    QWidget* m_phaseSelector = nullptr;
    QSlider* m_phaseSlider = nullptr;
    QSpinBox* m_phaseSpinBox = nullptr;
};

}  // namespace echolucent
