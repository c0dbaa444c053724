// A window off the screen, and the pictures that a card draws in it.
#pragma once

#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include <memory>

#include "widgets/volume_view/scene/graphics_card/card_renderer.h"

namespace echolucent::bench {

class CardWindow {
public:
    /// `egl` only if hasEgl().
    explicit CardWindow(bool egl = false);
    ~CardWindow();
    CardWindow(const CardWindow&) = delete;
    CardWindow& operator=(const CardWindow&) = delete;

    /// Whether VTK was built with a window that needs no X server.
    [[nodiscard]] static bool hasEgl();

    /// False if the card failed; CardRenderer::failure() then says why.
    bool draw(const std::shared_ptr<const CardPicture>& picture);
    [[nodiscard]] CardRenderer& renderer() { return m_renderer; }

private:
    vtkSmartPointer<vtkRenderWindow> m_window;
    std::shared_ptr<const KnownCardPicture> m_known;
    CardRenderer m_renderer;
};

}  // namespace echolucent::bench
