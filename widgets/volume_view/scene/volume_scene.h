// The 3D scene: the volume's picture and what is written over it. Knows no Qt.
#pragma once

#include <vtkNew.h>

#include <memory>
#include <string>

#include "processing/picture/renderer_choice.h"
#include "processing/picture/screen_picture.h"
#include "widgets/volume_view/scene/annotation/caption.h"
#include "widgets/volume_view/scene/annotation/orientation_marker.h"
#include "widgets/volume_view/scene/annotation/overlay_lines.h"
#include "widgets/volume_view/scene/annotation/scale_bar.h"
#include "widgets/volume_view/scene/graphics_card/graphics_card.h"
#include "widgets/volume_view/scene/graphics_card/graphics_card_volume.h"

class vtkRenderer;
class vtkVolume;
class vtkVolumeProperty;

namespace echolucent {

class RayCastMapper;

/// One vtkRenderer in grid mm on black. To be used in one thread, the one that renders. Nothing here casts rays or
/// starts a rendering: show() and the setters only change the scene.
class VolumeScene {
public:
    VolumeScene();
    ~VolumeScene();
    VolumeScene(const VolumeScene&) = delete;
    VolumeScene& operator=(const VolumeScene&) = delete;

    /// For a render window.
    [[nodiscard]] vtkRenderer* renderer();
    /// The volume's prop, for pickers: its property carries the curve and the colours in use.
    [[nodiscard]] vtkVolume* volumeProp() { return m_volumeProp; }
    [[nodiscard]] const ScaleBar& scaleBar() const { return m_scaleBar; }

    /// Shows a volume; null makes an empty scene, in which nothing is drawn. The picture of the volume before is
    /// dropped.
    void setVolume(std::shared_ptr<const Volume> volume);
    /// Takes the same scan, of which a scalpel cut other voxels (Volume::isSameScanAs()). The picture stays.
    void setCut(std::shared_ptr<const Volume> volume) { m_volume = std::move(volume); }
    void setTransfer(const Classification& classification, ColourMap colourMap);
    /// Puts a finished picture in the scene and looks at the scene with the camera it was made for.
    void show(std::shared_ptr<const ScreenPicture> picture, const Camera& camera);
    /// Looks at the scene with a camera and leaves the volume to the graphics card, which draws it with every drawing
    /// of the window. Only where rendererFor(look) says graphicsCard; the curve is that of setTransfer(). Of the look,
    /// the size plays no part.
    void showLive(const Camera& camera, const RayCastSettings& look);
    [[nodiscard]] Camera camera();
    void setAnnotationsVisible(bool visible);
    /// Says in the picture what was done to it; an empty text says nothing.
    void setCaption(const std::string& text);
    [[nodiscard]] const std::string& caption() const { return m_caption.text(); }
    /// Lines over the picture, beside the annotations; those in space follow the camera.
    void setOverlay(const Overlay& overlay) { m_overlay.setOverlay(overlay); }
    [[nodiscard]] const Overlay& overlay() const { return m_overlay.overlay(); }

    /// For pickers that read the depth buffer (vtkRenderer::GetZ(), vtkWorldPointPicker, vtkHardwareSelector): whether
    /// the pictures that are asked for from now on tell the depth of each pixel (RayCastSettings::findDepth).
    void setDepthWanted(bool wanted) { m_depthWanted = wanted; }
    [[nodiscard]] bool wantsDepth() const { return m_depthWanted; }

    // ---- Who renders

    void setRenderer(RendererChoice choice) { m_choice = choice; }
    [[nodiscard]] RendererChoice rendererChoice() const { return m_choice; }
    /// software or graphicsCard, for the volume in the scene. The graphics card is known once the window was drawn, and
    /// whether it can hold and draw the volume at the latest after the first drawing of showLive(): ask again after
    /// each.
    [[nodiscard]] RendererChoice rendererInUse() const { return rendererFor({}); }
    /// Who renders a picture of this look and classification: some of both only the software ray caster has.
    [[nodiscard]] RendererChoice rendererFor(const RayCastSettings& look,
                                             const Classification& classification = ManualCurve{}) const;
    /// Why rendererFor() says software although that was not the choice, as a sentence; else empty.
    [[nodiscard]] std::string whySoftware(const RayCastSettings& look = {},
                                          const Classification& classification = ManualCurve{}) const;
    /// OpenGL's name for what draws; empty until the window was drawn once.
    [[nodiscard]] const std::string& openGlRenderer() const { return m_card.renderer; }
    /// True where OpenGL is known and no software.
    [[nodiscard]] bool graphicsCardAtHand() const;
    /// What the graphics card took for the last drawing of showLive().
    [[nodiscard]] double liveMilliseconds() const { return m_cardVolume.milliseconds(); }

private:
    void lookThrough(const Camera& camera);
    void prepareDrawing();
    void layOutAnnotations();
    void updateVisibility();

    std::shared_ptr<const Volume> m_volume;
    vtkNew<vtkRenderer> m_renderer;
    vtkNew<RayCastMapper> m_mapper;
    vtkNew<vtkVolume> m_volumeProp;
    vtkNew<vtkVolumeProperty> m_property;
    OrientationMarker m_orientationMarker;
    ScaleBar m_scaleBar;
    Caption m_caption;
    OverlayLines m_overlay;
    GraphicsCard m_card;
    GraphicsCardVolume m_cardVolume;
    RendererChoice m_choice = RendererChoice::automatic;
    /// What the property was set from.
    struct Transfer {
        Classification classification;
        ColourMap colourMap;
        friend bool operator==(const Transfer&, const Transfer&) = default;
    };
    std::optional<Transfer> m_transfer;
    bool m_annotationsVisible = true;
    bool m_hasPicture = false;
    bool m_depthWanted = false;
    unsigned long m_startObserver = 0;
};

}  // namespace echolucent
