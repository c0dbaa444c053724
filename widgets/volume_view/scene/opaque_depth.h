// Where the scene's opaque actors stand, for rays to end there.
#pragma once

#include <vtkNew.h>
#include <vtkType.h>

#include <memory>
#include <vector>

#include "processing/picture/ray_cast_settings.h"

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;
class vtkTextureObject;

namespace echolucent {

/// The visible opaque props that have a place in space, volumes left out.
/// Props without bounds (text and lines over the picture) have none.
[[nodiscard]] std::vector<vtkProp*> opaqueProps(vtkRenderer& renderer);

/// Draws the opaque props of a renderer once more, into a depth buffer of its own in the same OpenGL context, and reads
/// that back. Reading it makes the processor wait for OpenGL (5 to 29 ms): so it is done only where there are such
/// props, and only when camera, size or a prop changed since the last time.
class OpaqueDepth {
public:
    OpaqueDepth();
    ~OpaqueDepth();
    OpaqueDepth(const OpaqueDepth&) = delete;
    OpaqueDepth& operator=(const OpaqueDepth&) = delete;

    /// Null where nothing opaque is visible, and where the renderer's window cannot draw yet. The same map (the same
    /// pointer) as the last time where nothing that it shows has changed. Makes the window's context current.
    [[nodiscard]] std::shared_ptr<const DepthMap> read(vtkRenderer& renderer, const Camera& camera, int width,
                                                       int height);

private:
    /// What a map was made from.
    struct Made {
        Camera camera;
        int width = 0, height = 0;
        std::vector<vtkProp*> props;  // compared by identity only, never followed
        vtkMTimeType propsChanged = 0;
        friend bool operator==(const Made&, const Made&) = default;
    };
    [[nodiscard]] DepthMap draw(vtkRenderer& renderer, vtkOpenGLRenderWindow& window, const Made& made);
    void prepareBuffers(vtkOpenGLRenderWindow& window, int width, int height);

    Made m_made;
    std::shared_ptr<const DepthMap> m_map;
    vtkNew<vtkOpenGLFramebufferObject> m_buffers;
    vtkNew<vtkTextureObject> m_colour;
    vtkNew<vtkTextureObject> m_depth;
};

}  // namespace echolucent
