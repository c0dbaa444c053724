// The 3D scene: the volume's picture and what is written over it. It knows no Qt.
#pragma once

#include <vtkNew.h>

#include <memory>
#include <string>

#include "processing/classification.h"
#include "processing/picture/renderer_choice.h"
#include "processing/picture/screen_picture.h"
#include "widgets/volume_view/scene/annotation/caption.h"
#include "widgets/volume_view/scene/annotation/orientation_marker.h"
#include "widgets/volume_view/scene/annotation/overlay_lines.h"
#include "widgets/volume_view/scene/annotation/scale_bar.h"
#include "widgets/volume_view/scene/annotation/shade.h"
#include "widgets/volume_view/scene/graphics_card/graphics_card.h"
#include "widgets/volume_view/scene/graphics_card/graphics_card_volume.h"

class vtkRenderer;
class vtkVolume;
class vtkVolumeProperty;

namespace echolucent {

class RayCastMapper;

/// One vtkRenderer in grid mm on black. Only the rendering thread may use it. Nothing here casts rays or starts a
/// rendering: show() and the setters only change the scene.
class VolumeScene {
public:
    VolumeScene();
    ~VolumeScene();
    VolumeScene(const VolumeScene&) = delete;
    VolumeScene& operator=(const VolumeScene&) = delete;

    [[nodiscard]] vtkRenderer* renderer();
    /// The volume's prop, for pickers: its property carries the curve and the colours in use.
    [[nodiscard]] vtkVolume* volumeProp() { return m_volumeProp; }
    [[nodiscard]] const ScaleBar& scaleBar() const { return m_scaleBar; }

    /// Shows a volume. Null makes an empty scene. The picture of the volume before is dropped.
    void setVolume(std::shared_ptr<const Volume> volume);
    /// Takes the same scan with other voxels cut by a scalpel (Volume::isSameScanAs()). The picture stays.
    void setCut(std::shared_ptr<const Volume> volume) { m_volume = std::move(volume); }
    void setTransfer(const Classification& classification, ColourMap colourMap);
    /// Shows a finished picture with the camera it was made for.
    void show(std::shared_ptr<const ScreenPicture> picture, const Camera& camera);
    /// Looks at the scene with a camera. The graphics card then draws the volume with every drawing of the window. Call
    /// this only if rendererFor(look) says graphicsCard. The curve is that of setTransfer(). The look's size and camera
    /// play no part.
    void showLive(const Camera& camera, const RayCastSettings& look);
    [[nodiscard]] Camera camera();
    void setAnnotationsVisible(bool visible);
    /// Lays a shade over picture and annotations, because they are about to be replaced.
    void setDimmed(bool dimmed) { m_shade.setVisible(dimmed); }
    /// Words in the picture that say what was done to it. An empty text shows nothing.
    void setCaption(const std::string& text);
    [[nodiscard]] const std::string& caption() const { return m_caption.text(); }
    /// Lines, discs and words over the picture, besides the annotations. Those in space follow the camera.
    void setOverlay(const Overlay& overlay) { m_overlay.setOverlay(overlay); }
    [[nodiscard]] const Overlay& overlay() const { return m_overlay.overlay(); }

    /// Whether the pictures asked for from now on have the depth of each pixel (RayCastSettings::findDepth). For
    /// pickers that read the depth buffer: vtkRenderer::GetZ(), vtkWorldPointPicker, vtkHardwareSelector.
    void setDepthWanted(bool wanted) { m_depthWanted = wanted; }
    [[nodiscard]] bool wantsDepth() const { return m_depthWanted; }

    // ---- Who renders

    void setRenderer(RendererChoice choice) { m_choice = choice; }
    [[nodiscard]] RendererChoice rendererChoice() const { return m_choice; }
    /// software or graphicsCard, for the volume in the scene. The scene knows the graphics card once the window was
    /// drawn. After the first drawing of showLive() it knows whether the card can hold and draw the volume. Ask again
    /// after each of the two.
    [[nodiscard]] RendererChoice rendererInUse() const { return rendererFor({}); }
    /// Who renders a picture of this look and classification. Some looks and classifications only the software ray
    /// caster can draw.
    [[nodiscard]] RendererChoice rendererFor(const RayCastSettings& look,
                                             const Classification& classification = ManualCurve{}) const;
    /// A sentence that says why rendererFor() chose software against the choice; else empty.
    [[nodiscard]] std::string whySoftware(const RayCastSettings& look = {},
                                          const Classification& classification = ManualCurve{}) const;
    /// OpenGL's name for the renderer; empty until the window was drawn once.
    [[nodiscard]] const std::string& openGlRenderer() const { return m_card.renderer; }
    /// True if OpenGL is known and is no software.
    [[nodiscard]] bool graphicsCardAtHand() const;
    /// The time of the last drawing of showLive().
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
    Shade m_shade;
    GraphicsCard m_card;
    GraphicsCardVolume m_cardVolume;
    RendererChoice m_choice = RendererChoice::automatic;
    /// The values that the property was set from.
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
