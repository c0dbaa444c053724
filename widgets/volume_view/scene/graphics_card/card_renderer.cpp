#include "widgets/volume_view/scene/graphics_card/card_renderer.h"

#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLQuadHelper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkPixelBufferObject.h>
#include <vtkShaderProgram.h>
#include <vtkTextureObject.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <utility>

#include "widgets/volume_view/scene/graphics_card/card_textures.h"
#include "widgets/volume_view/scene/graphics_card/card_uniforms.h"

namespace echolucent {

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

constexpr float nowhere = 1e30f;  // the shader writes more where a pixel has no depth

/// The most steps that a ray of a picture may have.
double mostSteps(const CardPicture& picture, const RayCastSettings& settings) {
    const VolumeGeometry& geometry = picture.scan->filled.geometry();
    return std::max(1.0, length(geometry.boxMaxMm() - geometry.boxMinMm()) / (settings.step * geometry.unit()));
}

std::vector<float> pixelsOf(vtkTextureObject& texture, int components) {
    unsigned size[2] = {texture.GetWidth(), texture.GetHeight()};
    std::vector<float> pixels(std::size_t{size[0]} * size[1] * static_cast<std::size_t>(components));
    vtkIdType steps[2] = {0, 0};
    vtkSmartPointer<vtkPixelBufferObject> buffer;
    buffer.TakeReference(texture.Download());
    buffer->Download2D(VTK_FLOAT, pixels.data(), size, components, steps);
    return pixels;
}

}  // namespace

struct CardRenderer::OpenGl {
    CardTextures textures;
    vtkNew<vtkOpenGLFramebufferObject> frame;
    vtkNew<vtkTextureObject> colours, depths;
    std::map<std::string, std::unique_ptr<vtkOpenGLQuadHelper>> programs;  ///< by their source
};

CardRenderer::CardRenderer(CardAnswers answers) : m_answers(std::move(answers)), m_openGl(std::make_unique<OpenGl>()) {}
CardRenderer::~CardRenderer() = default;

vtkTextureObject& CardRenderer::colours() { return *m_openGl->colours; }
vtkTextureObject& CardRenderer::depths() { return *m_openGl->depths; }
int CardRenderer::volumesBrought() const { return m_openGl->textures.volumesBrought(); }

void CardRenderer::setReading(CardReading reading) {
    m_reading = reading;
    m_drawn = nullptr;
}

void CardRenderer::meet(vtkOpenGLRenderWindow& window) {
    if (m_met && m_window == &window) return;
    const std::string before = m_card.renderer;
    m_card = m_answers.describe(window);
    m_met = true;
    m_window = &window;
    m_checked = false;
    m_drawn = nullptr;
    m_samplesOfTile = firstSamplesOfTile;
    if (m_card.renderer != before) m_isWrong = false;
    if (!m_isWrong) m_failure.clear();
    m_openGl->textures.setKeptBytes(m_card.freeBytes > 0 ? m_card.freeBytes / 2 : std::int64_t{1} << 30);
}

void CardRenderer::forgetFailure() {
    if (!m_isWrong) m_failure.clear();
}

bool CardRenderer::fail(std::string sentence) {
    m_failure = std::move(sentence);
    m_drawn = nullptr;
    return false;
}

bool CardRenderer::failed(vtkOpenGLRenderWindow& window) {
    switch (m_answers.error(window)) {
        case CardError::none: return false;
        case CardError::outOfMemory:
            fail("The graphics card has too little memory for the picture, so the software draws it.");
            break;
        case CardError::contextLost:
            fail("The graphics card was lost while it drew, so the software draws.");
            m_met = false;
            break;
        case CardError::other: fail("The graphics card's driver reported an error, so the software draws."); break;
    }
    return true;
}

bool CardRenderer::draw(vtkOpenGLRenderWindow& window, const std::shared_ptr<const CardPicture>& picture,
                        const std::shared_ptr<const KnownCardPicture>& known) {
    meet(window);
    if (!m_failure.empty()) return false;
    if (m_drawn == picture) return true;
    m_drawn = nullptr;
    if (m_answers.error(window) == CardError::contextLost)  // other errors are of whoever drew before
        return fail("The graphics card was lost while it drew, so the software draws.");
    if (!m_checked && !check(window, *known)) return false;
    if (!drawChecked(window, *picture)) return false;
    m_drawn = picture;
    return true;
}

bool CardRenderer::check(vtkOpenGLRenderWindow& window, const KnownCardPicture& known) {
    if (!drawChecked(window, known.picture)) return false;
    const double levels = levelsBetween(m_answers.drewKnownPicture(read()), known.expected);
    m_checked = levels <= KnownCardPicture::tolerance;
    m_isWrong = !m_checked;
    if (m_checked) return true;
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", std::min(levels, 255.0));
    return fail(std::string("The graphics card draws a picture whose pixels are known wrongly (by ") + text +
                " levels of 255), so the software draws.");
}

bool CardRenderer::prepareTargets(vtkOpenGLRenderWindow& window, const RayCastSettings& settings) {
    const auto width = static_cast<unsigned>(settings.width), height = static_cast<unsigned>(settings.height);
    const auto prepare = [&](vtkTextureObject& texture, int components) {
        texture.SetContext(&window);
        if (texture.GetHandle() != 0 && texture.GetWidth() == width && texture.GetHeight() == height) return true;
        texture.SetWrapS(vtkTextureObject::ClampToEdge);
        texture.SetWrapT(vtkTextureObject::ClampToEdge);
        texture.SetMinificationFilter(vtkTextureObject::Nearest);
        texture.SetMagnificationFilter(vtkTextureObject::Nearest);
        return texture.Allocate2D(width, height, components, VTK_FLOAT);
    };
    return prepare(colours(), 4) && (!settings.findDepth || prepare(depths(), 1));
}

bool CardRenderer::drawChecked(vtkOpenGLRenderWindow& window, const CardPicture& picture) {
    auto begin = Clock::now();
    if (!m_openGl->textures.bring(window, picture) || !prepareTargets(window, picture.settings)) {
        if (!failed(window)) fail("The graphics card cannot hold the volume, so the software draws it.");
        return false;
    }
    if (failed(window)) return false;
    m_uploadMilliseconds = millisecondsSince(begin);
    begin = Clock::now();
    m_tiles = 0;
    vtkOpenGLState* state = window.GetState();
    vtkOpenGLState::ScopedglDepthMask keepDepthMask(state);
    vtkOpenGLState::ScopedglColorMask keepColourMask(state);
    vtkOpenGLState::ScopedglBlendFuncSeparate keepBlending(state);
    vtkOpenGLState::ScopedglEnableDisable keepBlend(state, GL_BLEND);
    vtkOpenGLState::ScopedglEnableDisable keepDepthTest(state, GL_DEPTH_TEST);
    vtkOpenGLState::ScopedglEnableDisable keepScissorTest(state, GL_SCISSOR_TEST);
    vtkOpenGLState::ScopedglScissor keepScissor(state);
    vtkOpenGLState::ScopedglViewport keepViewport(state);
    vtkOpenGLState::ScopedglClearColor keepClearColour(state);
    state->PushFramebufferBindings();
    const RayCastSettings& settings = picture.settings;
    const double share = settings.mode == RenderMode::direct ? settings.mixing.share : 0.0;
    bool drawn = drawWith(window, picture, settings, 1.0 - share);
    if (drawn && share > 0.0) drawn = drawWith(window, picture, mixedIn(settings), share);
    m_openGl->frame->UnBind();
    state->PopFramebufferBindings();
    if (failed(window)) return false;
    m_drawMilliseconds = millisecondsSince(begin);
    return drawn;
}

bool CardRenderer::drawWith(vtkOpenGLRenderWindow& window, const CardPicture& picture, const RayCastSettings& settings,
                            double weight) {
    const std::string source = m_answers.shaderSource(cardShader(picture, settings, m_reading));
    auto& program = m_openGl->programs[source];
    if (!program) {
        program = std::make_unique<vtkOpenGLQuadHelper>(&window, nullptr, source.c_str(), "");
    } else if (program->Program) {
        window.GetShaderCache()->ReadyShaderProgram(program->Program);
    }
    if (!program->Program || !program->Program->GetCompiled())
        return fail("The graphics card's driver does not understand the shader, so the software draws.");

    const bool isMixedIn = settings.mode != picture.settings.mode;
    vtkOpenGLFramebufferObject& frame = *m_openGl->frame;
    vtkOpenGLState* state = window.GetState();
    frame.SetContext(&window);
    frame.Bind();
    frame.AddColorAttachment(0, &colours());
    if (settings.findDepth)
        frame.AddColorAttachment(1, &depths());
    else
        frame.RemoveColorAttachment(1);
    frame.ActivateDrawBuffers(settings.findDepth ? 2 : 1);
    const char* problem = nullptr;
    if (!vtkOpenGLFramebufferObject::GetFrameBufferStatus(vtkOpenGLFramebufferObject::GetDrawMode(), problem))
        return fail("The graphics card cannot draw into single precision, so the software draws.");
    state->vtkglViewport(0, 0, settings.width, settings.height);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    if (isMixedIn) {
        state->vtkglEnable(GL_BLEND);
        state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    } else {
        state->vtkglDisable(GL_BLEND);
        state->vtkglDisable(GL_SCISSOR_TEST);
        state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
        state->vtkglClear(GL_COLOR_BUFFER_BIT);
    }
    setCardUniforms(*program->Program, picture, settings, weight);
    m_openGl->textures.bind(picture, *program->Program);
    state->vtkglEnable(GL_SCISSOR_TEST);
    const ray_casting::RayGeometry::PixelBox whole{0, settings.width, 0, settings.height};
    const auto box = settings.findDepth ? whole : picture.pixels;  // every pixel must tell its depth
    const double steps = mostSteps(picture, settings);
    for (int row = box.firstRow; row < box.lastRow;) {
        const double pixels = std::max(m_samplesOfTile / steps, 256.0);
        const int columns = std::min(box.lastColumn - box.firstColumn, static_cast<int>(std::min(pixels, 1e5)));
        const int rows = std::clamp(static_cast<int>(pixels / std::max(columns, 1)), 1, box.lastRow - row);
        for (int column = box.firstColumn; column < box.lastColumn; column += columns) {
            const auto begin = Clock::now();
            const int width = std::min(columns, box.lastColumn - column);
            state->vtkglScissor(column, row, width, rows);
            program->Render();
            window.WaitForCompletion();
            ++m_tiles;
            const double perMillisecond = steps * width * rows / std::max(millisecondsSince(begin), 1e-3);
            m_samplesOfTile =
                std::clamp(perMillisecond * tileMilliseconds, m_samplesOfTile / 4.0, m_samplesOfTile * 4.0);
        }
        row += rows;
    }
    m_openGl->textures.unbind();
    return true;
}

Picture CardRenderer::read() const {
    Picture picture;
    vtkTextureObject& colours = *m_openGl->colours;
    picture.width = static_cast<int>(colours.GetWidth());
    picture.height = static_cast<int>(colours.GetHeight());
    picture.rgba = pixelsOf(colours, 4);
    if (!m_drawn || !m_drawn->settings.findDepth) return picture;
    picture.depthMm = pixelsOf(*m_openGl->depths, 1);
    for (float& depth : picture.depthMm)
        if (!(depth < nowhere)) depth = std::numeric_limits<float>::infinity();
    return picture;
}

void CardRenderer::release(vtkWindow* window) {
    m_openGl->textures.release(window);
    m_openGl->programs.clear();
    m_openGl->colours->ReleaseGraphicsResources(window);
    m_openGl->depths->ReleaseGraphicsResources(window);
    m_openGl->frame->ReleaseGraphicsResources(window);
    m_drawn = nullptr;
    m_met = false;
}

}  // namespace echolucent
