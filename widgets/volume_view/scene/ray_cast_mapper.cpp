#include "widgets/volume_view/scene/ray_cast_mapper.h"

#include <vtkCamera.h>
#include <vtkHardwareSelector.h>
#include <vtkNew.h>
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
#include <array>
#include <utility>

#include "processing/volume/geometry.h"

namespace echolucent {

namespace {

constexpr const char* vertexShader = R"(//VTK::System::Dec
in vec4 vertexMC;
in vec2 tcoordMC;
out vec2 tcoordVC;
void main() { tcoordVC = tcoordMC; gl_Position = vertexMC; }
)";

constexpr const char* colourShader = R"(//VTK::System::Dec
//VTK::Output::Dec
in vec2 tcoordVC;
uniform sampler2D picture;
void main() { gl_FragData[0] = texture2D(picture, tcoordVC); }
)";

// Draws the volume's surface in one colour at its depth: 0 on the camera's near clipping plane, 1 on the far one.
constexpr const char* surfaceShader = R"(//VTK::System::Dec
//VTK::Output::Dec
in vec2 tcoordVC;
uniform sampler2D picture;
uniform sampler2D depths;
uniform int hasDepths;
uniform int parallelProjection;
uniform float eyeMm;
uniform float nearMm;
uniform float farMm;
uniform vec3 marker;
void main() {
    float windowDepth = gl_FragCoord.z;
    if (hasDepths == 1) {
        float mm = texture2D(depths, tcoordVC).r;
        if (!(mm < 1e30)) discard;
        float before = mm - eyeMm;
        windowDepth = (before - nearMm) / (farMm - nearMm);
        if (parallelProjection == 0) windowDepth *= farMm / before;
    } else if (texture2D(picture, tcoordVC).a < 0.5) {
        discard;
    }
    gl_FragDepth = clamp(windowDepth, 0.0, 1.0);
    gl_FragData[0] = vec4(marker, 1.0);
}
)";

/// Depth of the volume's centre in normalised device coordinates, kept above the near end.
float depthOfCentre(vtkRenderer* renderer, vtkVolume* volume) {
    const double* centre = volume->GetCenter();
    renderer->SetWorldPoint(centre[0], centre[1], centre[2], 1.0);
    renderer->WorldToDisplay();
    return static_cast<float>(2.0 * std::clamp(renderer->GetDisplayPoint()[2], 1e-6, 1.0) - 1.0);
}

bool prepare(std::unique_ptr<vtkOpenGLHelper>& program, vtkOpenGLRenderWindow* window, const char* fragmentShader) {
    if (program) return window->GetShaderCache()->ReadyShaderProgram(program->Program) != nullptr;
    program = std::make_unique<vtkOpenGLHelper>();
    program->Program = window->GetShaderCache()->ReadyShaderProgram(vertexShader, fragmentShader, "");
    if (program->Program) program->VAO->ShaderProgramChanged();
    return program->Program != nullptr;
}

void release(std::unique_ptr<vtkOpenGLHelper>& program, vtkWindow* window) {
    if (program) program->ReleaseGraphicsResources(window);
    program.reset();
}

/// VTK's signature is not const, but VTK only reads the picture.
template <typename Component>
void fill(vtkTextureObject& texture, vtkOpenGLRenderWindow* window, const ScreenPicture& picture, int components,
          int type, const std::vector<Component>& pixels) {
    texture.SetContext(window);
    texture.SetWrapS(vtkTextureObject::ClampToEdge);
    texture.SetWrapT(vtkTextureObject::ClampToEdge);
    texture.Create2DFromRaw(static_cast<unsigned>(picture.width), static_cast<unsigned>(picture.height), components,
                            type, const_cast<Component*>(pixels.data()));
}

}  // namespace

struct RayCastMapper::OpenGl {
    std::unique_ptr<vtkOpenGLHelper> colours, surface;
    vtkNew<vtkTextureObject> picture, depths;
};

vtkStandardNewMacro(RayCastMapper);

RayCastMapper::RayCastMapper() : m_card(std::make_unique<CardRenderer>()), m_openGl(std::make_unique<OpenGl>()) {}

RayCastMapper::~RayCastMapper() = default;

void RayCastMapper::setPicture(std::shared_ptr<const ScreenPicture> picture) {
    // What the card has not finished is not wanted any more, and the scan that it has drawn may go.
    if (std::exchange(m_cardPicture, nullptr)) m_card->forgetPictures();
    if (picture == m_picture) return;
    m_picture = std::move(picture);
    m_uploaded = false;
    Modified();
}

void RayCastMapper::setCardPicture(std::shared_ptr<const CardPicture> picture,
                                   std::shared_ptr<const KnownCardPicture> known) {
    m_cardPicture = std::move(picture);
    m_known = std::move(known);
    Modified();
}

void RayCastMapper::upload(vtkOpenGLRenderWindow* window) {
    if (m_uploaded) return;
    fill(*m_openGl->picture, window, *m_picture, 4, VTK_UNSIGNED_CHAR, m_picture->rgba);
    if (!m_picture->depthMm.empty()) {
        vtkTextureObject& depths = *m_openGl->depths;
        // There is nothing to interpolate between a surface and no surface.
        depths.SetMinificationFilter(vtkTextureObject::Nearest);
        depths.SetMagnificationFilter(vtkTextureObject::Nearest);
        fill(depths, window, *m_picture, 1, VTK_FLOAT, m_picture->depthMm);
    }
    m_uploaded = true;
}

/// False if there is nothing to show.
bool RayCastMapper::prepareShown(vtkOpenGLRenderWindow* window, Shown& shown) {
    using Drawing = CardRenderer::Drawing;
    const Drawing drawing =
        m_cardPicture ? m_card->draw(*window, m_cardPicture, m_known, m_patienceMilliseconds) : Drawing::failed;
    if (drawing == Drawing::done) m_picture = nullptr;
    if (!m_picture && m_card->drawn()) {
        const RayCastSettings& settings = m_card->drawn()->settings;
        shown = {&m_card->colours(), nullptr, settings.width, settings.height};
        return true;
    }
    if (!m_picture || m_picture->rgba.empty()) return false;
    upload(window);
    shown = {m_openGl->picture, m_picture->depthMm.empty() ? nullptr : m_openGl->depths.Get(), m_picture->width,
             m_picture->height};
    return true;
}

void RayCastMapper::Render(vtkRenderer* renderer, vtkVolume* volume) {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    Shown shown{};
    if (!window || !prepareShown(window, shown)) return;
    const int* viewport = renderer->GetSize();
    const bool filtered = shown.width != viewport[0] || shown.height != viewport[1];
    const int filter = filtered ? vtkTextureObject::Linear : vtkTextureObject::Nearest;
    shown.colours->SetMinificationFilter(filter);
    shown.colours->SetMagnificationFilter(filter);

    vtkOpenGLState* state = window->GetState();
    vtkOpenGLState::ScopedglDepthMask keepDepthMask(state);
    vtkOpenGLState::ScopedglDepthFunc keepDepthFunction(state);
    vtkOpenGLState::ScopedglColorMask keepColourMask(state);
    vtkOpenGLState::ScopedglBlendFuncSeparate keepBlending(state);
    vtkOpenGLState::ScopedglEnableDisable keepBlend(state, GL_BLEND);
    vtkOpenGLState::ScopedglEnableDisable keepDepthTest(state, GL_DEPTH_TEST);
    state->vtkglDepthFunc(GL_LEQUAL);
    const float centre = depthOfCentre(renderer, volume);
    if (vtkHardwareSelector* selector = renderer->GetSelector()) {
        selector->BeginRenderProp();
        drawSurface(renderer, window, shown, centre);
        selector->EndRenderProp();
        return;
    }
    drawColours(renderer, window, shown, centre);
    if (!shown.depths) return;
    // Draw depths in a pass of their own. In one pass with the colours, the depth test would cut the colours, or depths
    // would be wiped out where the volume has no surface.
    state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    drawSurface(renderer, window, shown, centre);
}

void RayCastMapper::drawColours(vtkRenderer* renderer, vtkOpenGLRenderWindow* window, const Shown& shown, float depth) {
    if (!prepare(m_openGl->colours, window, colourShader)) return;
    vtkOpenGLState* state = window->GetState();
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    vtkTextureObject& picture = *shown.colours;
    picture.Activate();
    m_openGl->colours->Program->SetUniformi("picture", picture.GetTextureUnit());
    drawRectangle(renderer, *m_openGl->colours, shown, depth);
    picture.Deactivate();
}

void RayCastMapper::drawSurface(vtkRenderer* renderer, vtkOpenGLRenderWindow* window, const Shown& shown, float depth) {
    if (!prepare(m_openGl->surface, window, surfaceShader)) return;
    vtkOpenGLState* state = window->GetState();
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDisable(GL_BLEND);
    vtkTextureObject& picture = *shown.colours;
    vtkTextureObject& depths = shown.depths ? *shown.depths : picture;
    picture.Activate();
    depths.Activate();
    vtkCamera& camera = *renderer->GetActiveCamera();
    const double eyeMm = Vec3(camera.GetPosition()).dot(normalized(Vec3(camera.GetDirectionOfProjection())));
    const double* clippingMm = camera.GetClippingRange();
    vtkHardwareSelector* selector = renderer->GetSelector();
    const bool namesProp = selector && selector->GetCurrentPass() == vtkHardwareSelector::ACTOR_PASS;
    std::array<float, 3> marker{0, 0, 0};  // a pass over cells or points has no marker
    if (namesProp) selector->GetPropColorValue(marker.data());
    vtkShaderProgram& program = *m_openGl->surface->Program;
    program.SetUniformi("picture", picture.GetTextureUnit());
    program.SetUniformi("depths", depths.GetTextureUnit());
    program.SetUniformi("hasDepths", shown.depths != nullptr);
    program.SetUniformi("parallelProjection", camera.GetParallelProjection());
    program.SetUniformf("eyeMm", static_cast<float>(eyeMm));
    program.SetUniformf("nearMm", static_cast<float>(clippingMm[0]));
    program.SetUniformf("farMm", static_cast<float>(clippingMm[1]));
    program.SetUniform3f("marker", marker.data());
    drawRectangle(renderer, *m_openGl->surface, shown, depth);
    depths.Deactivate();
    picture.Deactivate();
}

void RayCastMapper::drawRectangle(vtkRenderer* renderer, vtkOpenGLHelper& program, const Shown& shown, float depth) {
    const int* viewport = renderer->GetSize();
    const float x = static_cast<float>((static_cast<double>(shown.width) / shown.height) /
                                       (static_cast<double>(viewport[0]) / viewport[1]));
    std::array<float, 12> vertices{-x, -1, depth, x, -1, depth, x, 1, depth, -x, 1, depth};
    std::array<float, 8> textureCoordinates{0, 1, 1, 1, 1, 0, 0, 0};  // the picture's first row is at the top
    vtkOpenGLRenderUtilities::RenderQuad(vertices.data(), textureCoordinates.data(), program.Program, program.VAO);
}

void RayCastMapper::ReleaseGraphicsResources(vtkWindow* window) {
    m_openGl->picture->ReleaseGraphicsResources(window);
    m_openGl->depths->ReleaseGraphicsResources(window);
    m_uploaded = false;
    m_card->release(window);
    release(m_openGl->colours, window);
    release(m_openGl->surface, window);
    vtkVolumeMapper::ReleaseGraphicsResources(window);
}

}  // namespace echolucent
