#include "widgets/volume_view/scene/scene_renderer.h"

#include <vtkObjectFactory.h>
#include <vtkVolume.h>

#include "widgets/volume_view/scene/ray_cast_mapper.h"

namespace echolucent {

vtkStandardNewMacro(SceneRenderer);

int SceneRenderer::UpdateGeometry(vtkFrameBufferObjectBase* buffers) {
    auto* mapper = m_pictureProp ? RayCastMapper::SafeDownCast(m_pictureProp->GetMapper()) : nullptr;
    const int rendered = vtkOpenGLRenderer::UpdateGeometry(buffers);
    if (mapper) mapper->setDrawn(false);
    return rendered;
}

void SceneRenderer::DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase* buffers) {
    auto* mapper = m_pictureProp ? RayCastMapper::SafeDownCast(m_pictureProp->GetMapper()) : nullptr;
    if (mapper && mapper->writesDepth() && m_pictureProp->GetVisibility()) {
        m_pictureProp->RenderVolumetricGeometry(this);
        mapper->setDrawn(true);
    }
    vtkOpenGLRenderer::DeviceRenderTranslucentPolygonalGeometry(buffers);
}

}  // namespace echolucent
