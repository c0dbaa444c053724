// The volume's place in VTK's scene. It draws a picture that the ray caster has finished elsewhere, or lets the
// graphics card make one.
#pragma once

#include <vtkVolumeMapper.h>

#include <limits>
#include <memory>

#include "processing/picture/screen_picture.h"
#include "widgets/volume_view/scene/graphics_card/card_renderer.h"

class vtkOpenGLHelper;
class vtkOpenGLRenderWindow;
class vtkTextureObject;

namespace echolucent {

/// A vtkVolumeMapper whose rays were cast elsewhere, or which has the card cast them into a texture. It blends the
/// newest finished picture, as one textured rectangle, over what VTK has drawn before. A picture of the viewport's own
/// size is drawn pixel by pixel, unfiltered. (vtkRayCastImageDisplayHelper stretches n-1 pixels over n, which blurs.) A
/// picture of another size or shape keeps its centre and fills the height, as its camera saw it.
///
/// The picture's colours are drawn as if the whole picture lay at the depth of the volume's centre. A picture with
/// depths is also written into the depth buffer, so that readers of the depth buffer find the surface. While a
/// vtkHardwareSelector draws, the volume is where its surface is: at its depths, or, without depths, where the picture
/// covers at least half.
///
/// The card draws its picture once, with the first drawing of the window. Later drawings show it again.
class RayCastMapper : public vtkVolumeMapper {
public:
    static RayCastMapper* New();
    vtkTypeMacro(RayCastMapper, vtkVolumeMapper)

        /// Sets the picture that is drawn from now on. Null draws nothing.
        void setPicture(std::shared_ptr<const ScreenPicture> picture);
    /// Lets the card draw from now on. The picture before stays until the card is done, and if the card fails, unless
    /// the card is lost.
    void setCardPicture(std::shared_ptr<const CardPicture> picture, std::shared_ptr<const KnownCardPicture> known);
    /// How long the card may draw in one drawing of the window; at first without end.
    void setCardPatience(double milliseconds) { m_patienceMilliseconds = milliseconds; }
    [[nodiscard]] CardRenderer& card() { return *m_card; }
    [[nodiscard]] const CardRenderer& card() const { return *m_card; }
    /// Another card in place of the one there is, for tests.
    void setCardAnswers(const CardAnswers& answers) { m_card = std::make_unique<CardRenderer>(answers); }

    void Render(vtkRenderer* renderer, vtkVolume* volume) override;
    void ReleaseGraphicsResources(vtkWindow* window) override;

    RayCastMapper(const RayCastMapper&) = delete;
    RayCastMapper& operator=(const RayCastMapper&) = delete;

protected:
    RayCastMapper();
    ~RayCastMapper() override;

private:
    struct OpenGl;
    /// A picture in textures.
    struct Shown {
        vtkTextureObject* colours;
        vtkTextureObject* depths;  ///< null if the picture has none
        int width, height;
    };
    [[nodiscard]] bool prepareShown(vtkOpenGLRenderWindow* window, Shown& shown);
    void upload(vtkOpenGLRenderWindow* window);
    void drawColours(vtkRenderer* renderer, vtkOpenGLRenderWindow* window, const Shown& shown, float depth);
    void drawSurface(vtkRenderer* renderer, vtkOpenGLRenderWindow* window, const Shown& shown, float depth);
    static void drawRectangle(vtkRenderer* renderer, vtkOpenGLHelper& program, const Shown& shown, float depth);

    std::shared_ptr<const ScreenPicture> m_picture;
    std::shared_ptr<const CardPicture> m_cardPicture;  ///< null if the picture is shown
    std::shared_ptr<const KnownCardPicture> m_known;
    std::unique_ptr<CardRenderer> m_card;
    double m_patienceMilliseconds = std::numeric_limits<double>::infinity();
    bool m_uploaded = false;
    std::unique_ptr<OpenGl> m_openGl;
};

}  // namespace echolucent
