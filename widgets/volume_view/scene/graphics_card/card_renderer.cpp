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
#include <vtk_glew.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
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

/// The most steps that a ray of a picture may have.
double mostSteps(const CardPicture& picture, const RayCastSettings& settings) {
    const VolumeGeometry& geometry = picture.scan->filled.geometry();
    return std::max(1.0, length(geometry.boxMaxMm() - geometry.boxMinMm()) / (settings.step * geometry.unit()));
}

}  // namespace

struct CardRenderer::OpenGl {
    CardTextures textures;
    vtkNew<vtkOpenGLFramebufferObject> frame;
    /// What a picture is drawn into. While one is drawn, the newest one that is done stays.
    std::array<vtkNew<vtkTextureObject>, 2> targets;
    std::size_t done = 0;  ///< the target of the newest picture that is done
    std::map<std::string, std::unique_ptr<vtkOpenGLQuadHelper>> programs;  ///< by their source
    vtkOpenGLQuadHelper* program = nullptr;                                ///< the one in use
    vtkTextureObject& next() { return *targets[1 - done]; }
};

CardRenderer::CardRenderer(CardAnswers answers) : m_answers(std::move(answers)), m_openGl(std::make_unique<OpenGl>()) {}
CardRenderer::~CardRenderer() = default;

vtkTextureObject& CardRenderer::colours() { return *m_openGl->targets[m_openGl->done]; }
int CardRenderer::volumesBrought() const { return m_openGl->textures.volumesBrought(); }

void CardRenderer::setReading(CardReading reading) {
    m_reading = reading;
    m_drawn = nullptr;
    m_begun = {};
}

void CardRenderer::meet(vtkOpenGLRenderWindow& window) {
    if (m_met && m_window == &window) return;
    const std::string before = m_card.renderer;
    if (m_window == &window) m_openGl->textures.release(&window);  // else free memory lacks what they take
    m_card = m_answers.describe(window);
    m_met = true;
    m_window = &window;
    m_checked = false;
    m_drawn = nullptr;
    m_begun = {};
    m_samplesOfBand = firstSamplesOfBand;
    if (m_card.renderer != before) m_isWrong = false;
    if (!m_isWrong) m_failure.clear();
    m_openGl->textures.setKeptBytes(m_card.freeBytes > 0 ? m_card.freeBytes / 2 : std::int64_t{1} << 30);
}

void CardRenderer::forgetFailure() {
    if (!m_isWrong) m_failure.clear();
}

void CardRenderer::forgetPictures() {
    m_drawn = nullptr;
    m_begun = {};
}

bool CardRenderer::fail(std::string sentence) {
    m_failure = std::move(sentence);
    m_begun = {};
    return false;
}

void CardRenderer::lose() {
    fail("The graphics card was lost while it drew, so the software draws.");
    m_drawn = nullptr;
}

bool CardRenderer::failed(vtkOpenGLRenderWindow& window) {
    switch (m_answers.error(window)) {
        case CardError::none: return false;
        case CardError::outOfMemory:
            m_openGl->textures.release(&window);
            fail("The graphics card has too little memory for the picture, so the software draws it.");
            break;
        case CardError::contextLost: lose(); break;
    }
    return true;
}

CardRenderer::Drawing CardRenderer::draw(vtkOpenGLRenderWindow& window,
                                         const std::shared_ptr<const CardPicture>& picture,
                                         const std::shared_ptr<const KnownCardPicture>& known,
                                         double patienceMilliseconds) {
    meet(window);
    if (!m_failure.empty()) return Drawing::failed;
    if (m_drawn == picture) {
        m_begun = {};
        return Drawing::done;
    }
    const Time until = std::isfinite(patienceMilliseconds)
                           ? Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                                std::chrono::duration<double, std::milli>(patienceMilliseconds))
                           : Time::max();
    // Other errors are of whoever drew before.
    const bool lost = m_answers.error(window) == CardError::contextLost;
    if (lost) lose();
    if (lost || (!m_checked && !check(window, known))) return Drawing::failed;
    if (m_begun.picture != picture && !begin(window, picture)) return Drawing::failed;
    return goOn(window, until);
}

bool CardRenderer::check(vtkOpenGLRenderWindow& window, const std::shared_ptr<const KnownCardPicture>& known) {
    const std::shared_ptr<const CardPicture> picture(known, &known->picture);
    if (!begin(window, picture) || goOn(window, Time::max()) != Drawing::done) return false;
    const double levels = levelsBetween(m_answers.drewKnownPicture(read()), known->expected);
    m_checked = levels <= KnownCardPicture::tolerance;
    m_isWrong = !m_checked;
    m_drawn = nullptr;  // nobody is to see the known picture
    if (m_checked) return true;
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", std::min(levels, 255.0));
    return fail(std::string("The graphics card draws a picture whose pixels are known wrongly (by ") + text +
                " levels of 255), so the software draws.");
}

bool CardRenderer::prepareTargets(vtkOpenGLRenderWindow& window, const RayCastSettings& settings) {
    const auto width = static_cast<unsigned>(settings.width), height = static_cast<unsigned>(settings.height);
    vtkTextureObject& target = m_openGl->next();
    target.SetContext(&window);
    if (target.GetHandle() != 0 && target.GetWidth() == width && target.GetHeight() == height) return true;
    target.SetWrapS(vtkTextureObject::ClampToEdge);
    target.SetWrapT(vtkTextureObject::ClampToEdge);
    target.SetMinificationFilter(vtkTextureObject::Nearest);
    target.SetMagnificationFilter(vtkTextureObject::Nearest);
    return target.Allocate2D(width, height, 4, VTK_FLOAT);
}

bool CardRenderer::begin(vtkOpenGLRenderWindow& window, const std::shared_ptr<const CardPicture>& picture) {
    const auto begin = Clock::now();
    m_begun = {};
    if (!m_openGl->textures.bring(window, *picture) || !prepareTargets(window, picture->settings)) {
        if (!failed(window)) fail("The graphics card cannot hold the volume, so the software draws it.");
        return false;
    }
    if (failed(window)) return false;
    m_uploadMilliseconds = millisecondsSince(begin);
    m_drawMilliseconds = 0.0;
    m_bands = 0;
    m_begun.picture = picture;
    return true;
}

CardRenderer::Drawing CardRenderer::goOn(vtkOpenGLRenderWindow& window, Time until) {
    const auto begin = Clock::now();
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
    const RayCastSettings& settings = m_begun.picture->settings;
    const double share = settings.mode == RenderMode::direct ? settings.mixing.share : 0.0;
    bool whole = false, able = true;
    if (!m_begun.mixesIn) {
        able = prepareProgram(window, settings);
        whole = able && drawBands(window, settings, 1.0 - share, until);
        m_begun.mixesIn = whole && share > 0.0;
        if (m_begun.mixesIn) m_begun.nextRow = 0;
    }
    if (able && m_begun.mixesIn) {
        const RayCastSettings other = mixedIn(settings);
        able = prepareProgram(window, other);
        whole = able && drawBands(window, other, share, until);
    }
    m_openGl->frame->UnBind();
    state->PopFramebufferBindings();
    if (!able || failed(window)) return Drawing::failed;
    m_drawMilliseconds += millisecondsSince(begin);
    if (!whole) return Drawing::goesOn;
    m_openGl->done = 1 - m_openGl->done;
    m_drawn = std::exchange(m_begun, {}).picture;
    return Drawing::done;
}

bool CardRenderer::prepareProgram(vtkOpenGLRenderWindow& window, const RayCastSettings& settings) {
    const std::string source = m_answers.shaderSource(cardShader(*m_begun.picture, settings, m_reading));
    auto& program = m_openGl->programs[source];
    if (!program) {
        program = std::make_unique<vtkOpenGLQuadHelper>(&window, nullptr, source.c_str(), "");
    } else if (program->Program) {
        window.GetShaderCache()->ReadyShaderProgram(program->Program);
    }
    if (!program->Program || !program->Program->GetCompiled())
        return fail("The graphics card's driver does not understand the shader, so the software draws.");
    m_openGl->program = program.get();
    vtkOpenGLFramebufferObject& frame = *m_openGl->frame;
    frame.SetContext(&window);
    frame.Bind();
    frame.AddColorAttachment(0, &m_openGl->next());
    frame.ActivateDrawBuffers(1);
    const char* problem = nullptr;
    return vtkOpenGLFramebufferObject::GetFrameBufferStatus(vtkOpenGLFramebufferObject::GetDrawMode(), problem) ||
           fail("The graphics card cannot draw into single precision, so the software draws.");
}

/// False if time is up before the picture is whole.
bool CardRenderer::drawBands(vtkOpenGLRenderWindow& window, const RayCastSettings& settings, double weight,
                             Time until) {
    const CardPicture& picture = *m_begun.picture;
    vtkShaderProgram& program = *m_openGl->program->Program;
    vtkOpenGLState* state = window.GetState();
    state->vtkglViewport(0, 0, settings.width, settings.height);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    const auto& box = picture.pixels;
    if (m_begun.mixesIn) {
        state->vtkglEnable(GL_BLEND);
        state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    } else {
        state->vtkglDisable(GL_BLEND);
        state->vtkglDisable(GL_SCISSOR_TEST);
        state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
        if (m_begun.nextRow == 0) state->vtkglClear(GL_COLOR_BUFFER_BIT);
    }
    setCardUniforms(program, picture, settings, weight);
    m_openGl->textures.bind(picture, program);
    state->vtkglEnable(GL_SCISSOR_TEST);
    const int columns = box.lastColumn - box.firstColumn;
    const double samplesOfRow = mostSteps(picture, settings) * std::max(columns, 1);
    int& row = m_begun.nextRow;
    for (row = std::max(row, box.firstRow); row < box.lastRow && columns > 0;) {
        const auto begin = Clock::now();
        const int rows = static_cast<int>(std::clamp(m_samplesOfBand / samplesOfRow, 1.0, box.lastRow - row + 0.0));
        state->vtkglScissor(box.firstColumn, row, columns, rows);
        m_openGl->program->Render();
        window.WaitForCompletion();
        ++m_bands;
        row += rows;
        const double perMillisecond = samplesOfRow * rows / std::max(millisecondsSince(begin), 1e-3);
        m_samplesOfBand = std::clamp(perMillisecond * bandMilliseconds, m_samplesOfBand / 4.0, m_samplesOfBand * 4.0);
        if (Clock::now() >= until) break;  // each call draws a band at least
    }
    m_openGl->textures.unbind();
    return row >= box.lastRow || columns <= 0;
}

Picture CardRenderer::read() const {
    vtkTextureObject& target = *m_openGl->targets[m_openGl->done];
    unsigned size[2] = {target.GetWidth(), target.GetHeight()};
    Picture picture = emptyPicture(static_cast<int>(size[0]), static_cast<int>(size[1]));
    vtkIdType steps[2] = {0, 0};
    vtkSmartPointer<vtkPixelBufferObject> buffer;
    buffer.TakeReference(target.Download());
    buffer->Download2D(VTK_FLOAT, picture.rgba.data(), size, 4, steps);
    return picture;
}

void CardRenderer::release(vtkWindow* window) {
    m_openGl->textures.release(window);
    m_openGl->programs.clear();
    for (auto& target : m_openGl->targets) target->ReleaseGraphicsResources(window);
    m_openGl->frame->ReleaseGraphicsResources(window);
    m_drawn = nullptr;
    m_begun = {};
    m_met = false;
}

}  // namespace echolucent
