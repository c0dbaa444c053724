#include "widgets/volume_view/scene/ray_cast_mapper.h"

#include <vtkObjectFactory.h>
#include <vtkOpenGLHelper.h>
#include <vtkOpenGLRenderUtilities.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkOpenGLVertexArrayObject.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>
#include <vtkTextureObject.h>
#include <vtkVolume.h>

#include <algorithm>

namespace echolucent {

namespace {

constexpr const char* vertexShader = R"(//VTK::System::Dec
in vec4 vertexMC;
in vec2 tcoordMC;
out vec2 tcoordVC;
void main() { tcoordVC = tcoordMC; gl_Position = vertexMC; }
)";

constexpr const char* fragmentShader = R"(//VTK::System::Dec
//VTK::Output::Dec
in vec2 tcoordVC;
uniform sampler2D picture;
void main() { gl_FragData[0] = texture2D(picture, tcoordVC); }
)";

/// Depth of the volume's centre in normalised device coordinates, kept off the far plane's end.
float depthOfCentre(vtkRenderer* renderer, vtkVolume* volume) {
    const double* centre = volume->GetCenter();
    renderer->SetWorldPoint(centre[0], centre[1], centre[2], 1.0);
    renderer->WorldToDisplay();
    return static_cast<float>(2.0 * std::clamp(renderer->GetDisplayPoint()[2], 1e-6, 1.0) - 1.0);
}

}  // namespace

vtkStandardNewMacro(RayCastMapper);

RayCastMapper::RayCastMapper() : m_texture(vtkTextureObject::New()) {}

RayCastMapper::~RayCastMapper() { m_texture->Delete(); }

void RayCastMapper::setPicture(std::shared_ptr<const ScreenPicture> picture) {
    m_picture = std::move(picture);
    m_uploaded = false;
    Modified();
}

void RayCastMapper::upload(vtkOpenGLRenderWindow* window, bool filtered) {
    const int filter = filtered ? vtkTextureObject::Linear : vtkTextureObject::Nearest;
    m_texture->SetMinificationFilter(filter);
    m_texture->SetMagnificationFilter(filter);
    if (m_uploaded) return;
    m_texture->SetContext(window);
    m_texture->SetWrapS(vtkTextureObject::ClampToEdge);
    m_texture->SetWrapT(vtkTextureObject::ClampToEdge);
    // VTK's signature is not const; the bytes are only read.
    m_texture->Create2DFromRaw(static_cast<unsigned>(m_picture->width), static_cast<unsigned>(m_picture->height), 4,
                               VTK_UNSIGNED_CHAR, const_cast<std::uint8_t*>(m_picture->rgba.data()));
    m_uploaded = true;
}

bool RayCastMapper::prepareProgram(vtkOpenGLRenderWindow* window) {
    if (m_program) return window->GetShaderCache()->ReadyShaderProgram(m_program->Program) != nullptr;
    m_program = std::make_unique<vtkOpenGLHelper>();
    m_program->Program = window->GetShaderCache()->ReadyShaderProgram(vertexShader, fragmentShader, "");
    if (m_program->Program) m_program->VAO->ShaderProgramChanged();
    return m_program->Program != nullptr;
}

void RayCastMapper::Render(vtkRenderer* renderer, vtkVolume* volume) {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    if (!m_picture || m_picture->rgba.empty() || !window || !prepareProgram(window)) return;
    const int* viewport = renderer->GetSize();
    upload(window, m_picture->width != viewport[0] || m_picture->height != viewport[1]);

    vtkOpenGLState* state = window->GetState();
    vtkOpenGLState::ScopedglDepthMask keepDepthMask(state);
    vtkOpenGLState::ScopedglBlendFuncSeparate keepBlending(state);
    vtkOpenGLState::ScopedglEnableDisable keepBlend(state, GL_BLEND);
    vtkOpenGLState::ScopedglEnableDisable keepDepthTest(state, GL_DEPTH_TEST);
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);

    const float depth = depthOfCentre(renderer, volume);
    const float x = static_cast<float>((static_cast<double>(m_picture->width) / m_picture->height) /
                                       (static_cast<double>(viewport[0]) / viewport[1]));
    float vertices[] = {-x, -1, depth, x, -1, depth, x, 1, depth, -x, 1, depth};
    float textureCoordinates[] = {0, 1, 1, 1, 1, 0, 0, 0};  // the picture's first row is at the top
    m_texture->Activate();
    m_program->Program->SetUniformi("picture", m_texture->GetTextureUnit());
    vtkOpenGLRenderUtilities::RenderQuad(vertices, textureCoordinates, m_program->Program, m_program->VAO);
    m_texture->Deactivate();
}

void RayCastMapper::ReleaseGraphicsResources(vtkWindow* window) {
    m_texture->ReleaseGraphicsResources(window);
    m_uploaded = false;
    if (m_program) {
        m_program->ReleaseGraphicsResources(window);
        m_program.reset();
    }
    vtkVolumeMapper::ReleaseGraphicsResources(window);
}

}  // namespace echolucent
