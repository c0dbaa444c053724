#include "widgets/volume_view/scene/opaque_depth.h"

#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderUtilities.h>  // and with it OpenGL's own names
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPixelBufferObject.h>
#include <vtkPropCollection.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextureObject.h>
#include <vtkVolume.h>

#include <algorithm>
#include <array>
#include <limits>

#include "widgets/volume_view/scene/vtk_camera.h"
#include "widgets/volume_view/scene/window_depth.h"

namespace echolucent {

namespace {

vtkMTimeType lastChange(const std::vector<vtkProp*>& props) {
    vtkMTimeType last = 0;
    for (vtkProp* prop : props) last = std::max(last, prop->GetRedrawMTime());
    return last;
}

std::array<double, 6> boundsOf(const std::vector<vtkProp*>& props) {
    vtkBoundingBox box;
    for (vtkProp* prop : props) box.AddBounds(prop->GetBounds());
    std::array<double, 6> bounds{};
    box.GetBounds(bounds.data());
    return bounds;
}

/// Puts the window in the state in which VTK draws, and back in the one that its owner left.
class DrawingState {
public:
    explicit DrawingState(vtkOpenGLRenderWindow& window)
        : m_window(window), m_foreign(vtkGenericOpenGLRenderWindow::SafeDownCast(&window) != nullptr) {
        if (m_foreign) {
            window.MakeCurrent();
            window.GetState()->Reset();
            window.GetState()->Push();
        }
        window.Start();
    }
    ~DrawingState() {
        m_window.End();
        if (m_foreign) m_window.GetState()->Pop();
    }
    DrawingState(const DrawingState&) = delete;
    DrawingState& operator=(const DrawingState&) = delete;

private:
    vtkOpenGLRenderWindow& m_window;
    bool m_foreign;
};

/// The renderer looks through another camera as long as this lives.
class LookingThrough {
public:
    LookingThrough(vtkRenderer& renderer, vtkCamera& camera)
        : m_renderer(renderer), m_before(renderer.GetActiveCamera()) {
        renderer.SetActiveCamera(&camera);
    }
    ~LookingThrough() { m_renderer.SetActiveCamera(m_before); }
    LookingThrough(const LookingThrough&) = delete;
    LookingThrough& operator=(const LookingThrough&) = delete;

private:
    vtkRenderer& m_renderer;
    vtkSmartPointer<vtkCamera> m_before;
};

/// OpenGL's rows go up, ours down.
DepthMap mapOf(const std::vector<float>& windowDepths, int width, int height, const WindowDepth& scale) {
    DepthMap map{width, height, std::vector<float>(windowDepths.size())};
    const auto columns = static_cast<std::size_t>(width);
    for (std::size_t row = 0; row < static_cast<std::size_t>(height); ++row) {
        const float* from = &windowDepths[(static_cast<std::size_t>(height) - 1 - row) * columns];
        std::transform(from, from + columns, &map.depthMm[row * columns], [&](float depth) {
            return depth >= 1.0f ? std::numeric_limits<float>::infinity() : static_cast<float>(scale.mmOf(depth));
        });
    }
    return map;
}

}  // namespace

std::vector<vtkProp*> opaqueProps(vtkRenderer& renderer) {
    std::vector<vtkProp*> props;
    vtkPropCollection* all = renderer.GetViewProps();
    vtkCollectionSimpleIterator position;
    all->InitTraversal(position);
    while (vtkProp* prop = all->GetNextProp(position)) {
        if (!prop->GetVisibility() || vtkVolume::SafeDownCast(prop)) continue;
        const double* bounds = prop->GetBounds();
        if (bounds && vtkBoundingBox::IsValid(bounds) && prop->HasOpaqueGeometry()) props.push_back(prop);
    }
    return props;
}

OpaqueDepth::OpaqueDepth() = default;

OpaqueDepth::~OpaqueDepth() = default;

std::shared_ptr<const DepthMap> OpaqueDepth::read(vtkRenderer& renderer, const Camera& camera, int width, int height) {
    Made made{camera, width, height, opaqueProps(renderer), 0};
    if (made.props.empty() || width < 1 || height < 1) {
        m_map.reset();
        return nullptr;
    }
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer.GetRenderWindow());
    auto* foreign = vtkGenericOpenGLRenderWindow::SafeDownCast(window);
    if (!window || (foreign && !foreign->GetReadyForRendering())) return nullptr;
    made.propsChanged = lastChange(made.props);
    if (m_map && made == m_made) return m_map;
    DepthMap map = draw(renderer, *window, made);
    // Props that fit themselves to the camera while they are drawn are as new as this map.
    made.propsChanged = lastChange(made.props);
    m_made = std::move(made);
    const bool same =
        m_map && m_map->width == map.width && m_map->height == map.height && m_map->depthMm == map.depthMm;
    if (!same) m_map = std::make_shared<const DepthMap>(std::move(map));
    return m_map;
}

DepthMap OpaqueDepth::draw(vtkRenderer& renderer, vtkOpenGLRenderWindow& window, const Made& made) {
    vtkNew<vtkCamera> camera;
    echolucent::setCamera(*camera, made.camera);
    camera->SetUseExplicitAspectRatio(true);
    camera->SetExplicitAspectRatio(static_cast<double>(made.width) / made.height);
    setClippingRange(*camera, boundsOf(made.props));

    const DrawingState drawing(window);
    const LookingThrough looking(renderer, *camera);
    vtkOpenGLState* state = window.GetState();
    vtkOpenGLState::ScopedglViewport keepViewport(state);
    vtkOpenGLState::ScopedglScissor keepScissor(state);
    vtkOpenGLState::ScopedglDepthMask keepDepthMask(state);
    vtkOpenGLState::ScopedglDepthFunc keepDepthFunction(state);
    vtkOpenGLState::ScopedglEnableDisable keepDepthTest(state, GL_DEPTH_TEST);
    vtkOpenGLState::ScopedglEnableDisable keepScissorTest(state, GL_SCISSOR_TEST);
    vtkOpenGLState::ScopedglEnableDisable keepBlend(state, GL_BLEND);
    state->PushFramebufferBindings();
    prepareBuffers(window, made.width, made.height);
    state->vtkglViewport(0, 0, made.width, made.height);
    state->vtkglScissor(0, 0, made.width, made.height);
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglDisable(GL_BLEND);
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthFunc(GL_LEQUAL);
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglClearDepth(1.0);
    state->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (vtkProp* prop : made.props) prop->RenderOpaqueGeometry(&renderer);

    std::vector<float> windowDepths(static_cast<std::size_t>(made.width) * static_cast<std::size_t>(made.height));
    std::array<int, 4> extent{0, made.width - 1, 0, made.height - 1};
    std::array<unsigned, 2> size{static_cast<unsigned>(made.width), static_cast<unsigned>(made.height)};
    std::array<vtkIdType, 2> increments{0, 0};
    const auto pixels = vtkSmartPointer<vtkPixelBufferObject>::Take(m_buffers->DownloadDepth(extent.data(), VTK_FLOAT));
    pixels->Download2D(VTK_FLOAT, windowDepths.data(), size.data(), 1, increments.data());
    state->PopFramebufferBindings();
    return mapOf(windowDepths, made.width, made.height, WindowDepth(*camera));
}

void OpaqueDepth::prepareBuffers(vtkOpenGLRenderWindow& window, int width, int height) {
    const auto columns = static_cast<unsigned>(width), rows = static_cast<unsigned>(height);
    m_buffers->SetContext(&window);
    m_buffers->Bind();
    if (m_depth->GetHandle() == 0) {
        m_colour->SetContext(&window);
        m_colour->Allocate2D(columns, rows, 4, VTK_UNSIGNED_CHAR);
        m_depth->SetContext(&window);
        m_depth->AllocateDepth(columns, rows, vtkTextureObject::Float32);
        m_buffers->AddColorAttachment(0, m_colour);
        m_buffers->AddDepthAttachment(m_depth);
    }
    m_colour->Resize(columns, rows);
    m_depth->Resize(columns, rows);
    m_buffers->ActivateBuffer(0);
}

}  // namespace echolucent
