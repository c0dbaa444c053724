// The volume's place in VTK's scene: draws a picture that the ray caster has finished elsewhere.
#pragma once

#include <vtkVolumeMapper.h>

#include <memory>

#include "widgets/volume_view/scene/picture_request.h"

class vtkOpenGLHelper;
class vtkOpenGLRenderWindow;
class vtkTextureObject;

namespace echolucent {

/// A vtkVolumeMapper that casts no ray: it blends the newest finished picture over what is behind the volume's centre
/// and under what is in front of it, by one textured rectangle. A picture of the viewport's own size is drawn pixel by
/// pixel, unfiltered. (vtkRayCastImageDisplayHelper cannot: it stretches n-1 pixels over n, which blurs.)
/// A picture of another size or shape keeps its centre and fills the height, as its camera saw it.
class RayCastMapper : public vtkVolumeMapper {
public:
    static RayCastMapper* New();
    vtkTypeMacro(RayCastMapper, vtkVolumeMapper)

    /// The picture drawn from now on; none: nothing is drawn.
    void setPicture(std::shared_ptr<const ScreenPicture> picture);

    void Render(vtkRenderer* renderer, vtkVolume* volume) override;
    void ReleaseGraphicsResources(vtkWindow* window) override;

    RayCastMapper(const RayCastMapper&) = delete;
    RayCastMapper& operator=(const RayCastMapper&) = delete;

protected:
    RayCastMapper();
    ~RayCastMapper() override;

private:
    void upload(vtkOpenGLRenderWindow* window, bool filtered);
    bool prepareProgram(vtkOpenGLRenderWindow* window);

    std::shared_ptr<const ScreenPicture> m_picture;
    bool m_uploaded = false;
    std::unique_ptr<vtkOpenGLHelper> m_program;
    vtkTextureObject* m_texture;
};

}  // namespace echolucent
