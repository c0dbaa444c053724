// The volume's place in VTK's scene: draws a picture that the ray caster has finished elsewhere.
#pragma once

#include <vtkVolumeMapper.h>

#include <memory>

#include "processing/picture/screen_picture.h"

class vtkOpenGLHelper;
class vtkOpenGLRenderWindow;
class vtkTextureObject;

namespace echolucent {

class GraphicsCardVolume;

/// A vtkVolumeMapper that casts no ray: it blends the newest finished picture over what VTK has drawn before, by one
/// textured rectangle. A picture of the viewport's own size is drawn pixel by pixel, unfiltered.
/// (vtkRayCastImageDisplayHelper cannot: it stretches n-1 pixels over n, which blurs.) A picture of another size or
/// shape keeps its centre and fills the height, as its camera saw it.
///
/// Its colours are drawn as if all of it lay at the volume's centre. A picture with depths is also written into the
/// depth buffer, so that what reads the depth buffer finds the surface. While a vtkHardwareSelector draws, the volume
/// is where its surface is: at a depth, or, without depths, where the picture covers at least half.
///
/// Instead of the picture a GraphicsCardVolume may be drawn in this mapper's place.
class RayCastMapper : public vtkVolumeMapper {
public:
    static RayCastMapper* New();
    vtkTypeMacro(RayCastMapper, vtkVolumeMapper)

        /// Sets the picture that is drawn from now on; nothing is drawn where it is null.
        void setPicture(std::shared_ptr<const ScreenPicture> picture);
    /// Sets what is drawn instead of the picture; null brings the picture back. It must outlive this mapper's next
    /// drawing.
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
