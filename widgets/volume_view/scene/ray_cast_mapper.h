// The volume's place in VTK's scene. It draws a picture that the ray caster has finished elsewhere.
#pragma once

#include <vtkVolumeMapper.h>

#include <memory>

#include "processing/picture/screen_picture.h"

class vtkOpenGLHelper;
class vtkOpenGLRenderWindow;

namespace echolucent {

class GraphicsCardVolume;

/// A vtkVolumeMapper that casts no ray. It blends the newest finished picture, as one textured rectangle, over what VTK
/// has drawn before. A picture of the viewport's own size is drawn pixel by pixel, unfiltered.
/// (vtkRayCastImageDisplayHelper stretches n-1 pixels over n, which blurs.) A picture of another size or shape keeps
/// its centre and fills the height, as its camera saw it.
///
/// The picture's colours are drawn as if the whole picture lay at the depth of the volume's centre. A picture with
/// depths is also written into the depth buffer, so that readers of the depth buffer find the surface. While a
/// vtkHardwareSelector draws, the volume is where its surface is: at its depths, or, without depths, where the picture
/// covers at least half.
///
/// A GraphicsCardVolume may be drawn in place of the picture.
class RayCastMapper : public vtkVolumeMapper {
public:
    static RayCastMapper* New();
    vtkTypeMacro(RayCastMapper, vtkVolumeMapper)

        /// Sets the picture that is drawn from now on. Null draws nothing.
        void setPicture(std::shared_ptr<const ScreenPicture> picture);
    /// Draws this volume in place of the picture. Null brings the picture back. The volume must outlive this mapper's
    /// next drawing.
    void setGraphicsCardVolume(GraphicsCardVolume* volume);

    void Render(vtkRenderer* renderer, vtkVolume* volume) override;
    void ReleaseGraphicsResources(vtkWindow* window) override;

    RayCastMapper(const RayCastMapper&) = delete;
    RayCastMapper& operator=(const RayCastMapper&) = delete;

protected:
    RayCastMapper();
    ~RayCastMapper() override;

private:
    struct OpenGl;
    void upload(vtkOpenGLRenderWindow* window, bool filtered);
    void drawColours(vtkRenderer* renderer, vtkOpenGLRenderWindow* window, float depth);
    void drawSurface(vtkRenderer* renderer, vtkOpenGLRenderWindow* window, float depth);
    void drawRectangle(vtkRenderer* renderer, vtkOpenGLHelper& program, float depth);

    std::shared_ptr<const ScreenPicture> m_picture;
    GraphicsCardVolume* m_card = nullptr;
    bool m_uploaded = false;
    std::unique_ptr<OpenGl> m_openGl;
};

}  // namespace echolucent
