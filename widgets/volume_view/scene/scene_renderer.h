// VTK's renderer, with the volume's picture drawn before what is translucent.
#pragma once

#include <vtkOpenGLRenderer.h>

class vtkVolume;

namespace echolucent {

/// VTK draws opaque props, then translucent ones, then volumes: a volume's picture would cover the translucent props
/// before it. A picture that writes its depths is drawn before them here: those behind its surface are hidden by it,
/// those before it are blended over it. (Props within haze that stays below half opacity are seen as before it.)
/// In every other case this is VTK's own renderer.
class SceneRenderer : public vtkOpenGLRenderer {
public:
    static SceneRenderer* New();
    vtkTypeMacro(SceneRenderer, vtkOpenGLRenderer)

        /// The prop whose mapper is a RayCastMapper; must outlive this renderer's drawing.
        void setPictureProp(vtkVolume* prop) {
        m_pictureProp = prop;
    }

    void DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase* buffers = nullptr) override;

    SceneRenderer(const SceneRenderer&) = delete;
    SceneRenderer& operator=(const SceneRenderer&) = delete;

protected:
    SceneRenderer() = default;
    ~SceneRenderer() override = default;
    int UpdateGeometry(vtkFrameBufferObjectBase* buffers = nullptr) override;

private:
    vtkVolume* m_pictureProp = nullptr;
};

}  // namespace echolucent
