#include "tests/benchmarks/card/card_window.h"

#include <vtkOpenGLRenderWindow.h>
#if __has_include(<vtkEGLRenderWindow.h>)
#include <vtkEGLRenderWindow.h>
#endif

namespace echolucent::bench {

bool CardWindow::hasEgl() {
#if __has_include(<vtkEGLRenderWindow.h>)
    return true;
#else
    return false;
#endif
}

CardWindow::CardWindow([[maybe_unused]] bool egl)
    : m_known(std::make_shared<const KnownCardPicture>(knownCardPicture())) {
#if __has_include(<vtkEGLRenderWindow.h>)
    if (egl) m_window = vtkSmartPointer<vtkEGLRenderWindow>::New();
#endif
    if (!m_window) m_window = vtkSmartPointer<vtkRenderWindow>::New();
    m_window->SetOffScreenRendering(1);
    m_window->SetMultiSamples(0);
    m_window->SetSize(64, 64);
    m_window->Render();
    m_renderer.meet(*vtkOpenGLRenderWindow::SafeDownCast(m_window));
}

CardWindow::~CardWindow() { m_renderer.release(m_window); }

bool CardWindow::draw(const std::shared_ptr<const CardPicture>& picture) {
    m_window->MakeCurrent();
    return m_renderer.draw(*vtkOpenGLRenderWindow::SafeDownCast(m_window), picture, m_known) ==
           CardRenderer::Drawing::done;
}

}  // namespace echolucent::bench
