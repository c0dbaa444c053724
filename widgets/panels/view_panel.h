// How the picture looks: brightness, smoothing, light and front; behind *More* all else that makes it.
#pragma once

#include <QWidget>
#include <memory>
#include <string_view>
#include <vector>

#include "processing/picture/look.h"
#include "processing/picture/renderer_choice.h"
#include "processing/viewpoint/viewpoint.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QLayout;
class QPushButton;
class QToolButton;

namespace echolucent {

class ValueSlider;
template <typename Values>
class ParameterControls;

/// Objects: view.brightness, view.reduction, view.lightAmount (+ .value, .reset), view.nearCut (+ .value, .suggest),
/// view.front.fromHere, view.front.none, view.front.show; behind view.more: view.mode (+ .remark), view.mixing,
/// view.mixedMode, view.lighting, view.lightAzimuth (+ .value), view.lightElevation (+ .value), view.lightSoftness,
/// view.shadow, view.occlusion, view.translucency, view.depthColouring, view.colourMap, view.interpolation,
/// view.projection, view.renderer, view.beamAxis, view.reset, view.resetAll, view.savePicture; sliders with ".value"
/// and
/// ".reset". The controls stand in groups, each with a reset beside its title: view.cut.reset, view.light.reset,
/// view.speckle.reset, view.colours.reset, view.rendering.reset; view.reset resets the view. Controls that play no part
/// in the chosen mode are disabled and say why. view.mode.remark says that the opacity curve, light and depth colours
/// play no part in it. No setter emits a signal.
class ViewPanel : public QWidget {
    Q_OBJECT

public:
    explicit ViewPanel(QWidget* parent = nullptr);
    ~ViewPanel() override;

    /// Whether all controls are seen, or those alone that stand before view.more. [true]
    void setMoreShown(bool shown);

    [[nodiscard]] double frontMm() const;
    void setFrontMm(double mm);
    /// The front's depth goes from 0 to maxMm, the volume's depth along the front. A larger value is clamped without a
    /// signal. If the spacing is unknown, the number is marked as a guess.
    void setFrontRange(double maxMm, bool spacingKnown = true);

    /// Without a front there is none to take away or to show. [true]
    void setFrontThere(bool there);

    /// The last look set, with a person's changes since; lookAtStart() at first.
    [[nodiscard]] const Look& look() const;
    void setLook(const Look& look);
    [[nodiscard]] RendererChoice renderer() const;
    void setRenderer(RendererChoice renderer);
    /// The person can choose the graphics card only if it is usable. At first it is not.
    void setGraphicsCardUsable(bool usable);
    [[nodiscard]] BeamAxis beamAxis() const;
    void setBeamAxis(BeamAxis axis);

signals:
    void frontChanged(double mm);
    /// The person asks for a suggested front.
    void frontSuggestionRequested();
    /// The person asks for a front across what is seen now.
    void frontFromHereRequested();
    void noFrontRequested();
    void frontShownIn3d(bool shown);
    /// The person asks for the front of the side that is taken.
    void frontResetRequested();
    void lookChanged(const echolucent::Look& look);
    /// The person moved the one slider of the light (light_amount.h).
    void lightAmountChanged(const echolucent::Look& look);
    /// A group of the look, named by its title, was reset to the values at start.
    void lookReset(const echolucent::Look& look, const QString& group);
    void rendererChanged(echolucent::RendererChoice renderer);
    void beamAxisChanged(echolucent::BeamAxis axis);
    void resetRequested();
    void resetAllRequested();
    void savePictureRequested();

private:
    void createChoices();
    void connectControls();
    void arrange();
    QLayout* createButtons();
    void createLight();
    QToolButton* createMore();
    void addPictureRows(QGridLayout& grid);
    void addCutGroup(QGridLayout& grid);
    void addLookGroups(QGridLayout& grid);
    void addViewGroup(QGridLayout& grid);
    void resetLook(const QString& group, const std::vector<std::string_view>& rows);
    void followLook();

    ValueSlider* m_front = nullptr;
    ValueSlider* m_light = nullptr;
    QToolButton* m_more = nullptr;
    QWidget* m_rest = nullptr;  ///< what *More* opens
    QToolButton* m_resetSmoothing = nullptr;
    QPushButton* m_noFront = nullptr;
    QWidget* m_frontIn3d = nullptr;
    std::unique_ptr<ParameterControls<Look>> m_look;
    QLabel* m_modeRemark = nullptr;
    QComboBox* m_renderer = nullptr;
    QComboBox* m_beamAxis = nullptr;
};

}  // namespace echolucent
