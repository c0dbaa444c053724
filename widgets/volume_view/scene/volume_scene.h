// The 3D scene: the volume's picture and what is written over it. It knows no Qt.
#pragma once

#include <vtkNew.h>

#include <memory>
#include <optional>
#include <string>

#include "processing/classification.h"
#include "processing/picture/camera.h"
#include "processing/picture/colour_map.h"
#include "processing/picture/renderer_choice.h"
#include "processing/picture/screen_picture.h"
#include "widgets/volume_view/scene/annotation/caption.h"
#include "widgets/volume_view/scene/annotation/orientation_marker.h"
#include "widgets/volume_view/scene/annotation/overlay_lines.h"
#include "widgets/volume_view/scene/annotation/scale_bar.h"
#include "widgets/volume_view/scene/annotation/shade.h"

class vtkRenderer;
class vtkVolume;
class vtkVolumeProperty;

namespace echolucent {

struct CardAnswers;
struct CardPicture;
struct KnownCardPicture;
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
    /// Lets the graphics card draw a picture with the next drawing of the window. If the card fails, the picture before
    /// stays, unless the card is lost, and rendererInUse() says software. Neither may be null.
    void show(std::shared_ptr<const CardPicture> picture, std::shared_ptr<const KnownCardPicture> known);
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
    /// pickers that read the depth buffer: vtkRenderer::GetZ(), vtkWorldPointPicker, vtkHardwareSelector. The software
    /// renders them, so that depths do not depend on the graphics card.
    void setDepthWanted(bool wanted) { m_depthWanted = wanted; }
    [[nodiscard]] bool wantsDepth() const { return m_depthWanted; }

    // ---- Who renders

    /// Gives a card that has failed another chance, unless it draws wrongly.
    void setRenderer(RendererChoice choice);
    [[nodiscard]] RendererChoice rendererChoice() const { return m_choice; }
    /// software or graphicsCard, for the volume in the scene. The scene knows the graphics card once the window was
    /// drawn. After the first drawing of a card's picture it knows whether the card can draw it. Ask again after each
    /// of the two.
    [[nodiscard]] RendererChoice rendererInUse() const;
    /// A sentence that says why rendererInUse() is software against the choice; else empty.
    [[nodiscard]] std::string whySoftware() const;
    /// OpenGL's name for the renderer; empty until the window was drawn once.
    [[nodiscard]] const std::string& openGlRenderer() const;
    /// The window may be on another card now. The next drawing asks and checks it anew.
    void forgetCard();
    /// Answers in the place of the card, for tests. Call this before the window is drawn.
    void setCardAnswers(const CardAnswers& answers);
    /// True if OpenGL is known and is no software.
    [[nodiscard]] bool graphicsCardAtHand() const;
    /// How long the card may draw in one drawing of the window; at first without end.
    void setCardPatience(double milliseconds);
    /// Whether the card's picture is not done. The next drawing goes on with it. The picture before is shown meanwhile.
    [[nodiscard]] bool cardGoesOn() const;
    /// The time that the newest picture of the card took in this thread.
    [[nodiscard]] double cardMilliseconds() const;

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
