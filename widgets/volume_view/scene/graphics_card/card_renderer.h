// Draws pictures on a graphics card, into textures.
#pragma once

#include <memory>
#include <string>

#include "processing/card_picture/card_picture.h"
#include "widgets/volume_view/scene/graphics_card/card_answers.h"
#include "widgets/volume_view/scene/graphics_card/card_shader.h"

class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

namespace echolucent {

/// Draws the picture of a CardPicture as castRays() casts it (docs/rendering.md, "On a graphics card"). Before the
/// first picture in a context it draws a known one, and draws nothing if the card draws that wrongly. It draws a
/// picture in tiles that each take about tileMilliseconds, because drivers end drawings that take seconds. Only the
/// thread of the window may use it, and only while the window's context is current.
class CardRenderer {
public:
    explicit CardRenderer(CardAnswers answers = {});
    ~CardRenderer();
    CardRenderer(const CardRenderer&) = delete;
    CardRenderer& operator=(const CardRenderer&) = delete;

    /// Asks the card what it is, if the window or its context is a new one. What failed on another card is forgotten.
    void meet(vtkOpenGLRenderWindow& window);
    /// What the card said; its name is empty before it was met.
    [[nodiscard]] const GraphicsCard& card() const { return m_card; }
    /// The next meeting asks and checks the card anew, because another may have taken its place.
    void forget() { m_met = false; }

    /// Draws a picture, unless it is the newest one drawn. False if something failed; failure() then says what, and
    /// nothing is drawn any more before the failure is forgotten. `known` is not null.
    bool draw(vtkOpenGLRenderWindow& window, const std::shared_ptr<const CardPicture>& picture,
              const std::shared_ptr<const KnownCardPicture>& known);
    /// The newest picture drawn, rows from the top; premultiplied colours, and depths of 1e38 where there are none.
    [[nodiscard]] vtkTextureObject& colours();
    /// Only if the settings asked for depths.
    [[nodiscard]] vtkTextureObject& depths();
    /// The newest picture drawn, read back.
    [[nodiscard]] Picture read() const;

    /// A sentence that says why the card does not draw; empty if it may.
    [[nodiscard]] const std::string& failure() const { return m_failure; }
    /// Another volume or the person's choice gives the card another chance. A card that draws wrongly gets none.
    void forgetFailure();
    /// Wall time of the newest picture: bringing it to the card, and drawing it.
    [[nodiscard]] double uploadMilliseconds() const { return m_uploadMilliseconds; }
    [[nodiscard]] double drawMilliseconds() const { return m_drawMilliseconds; }
    /// Tiles of the newest picture.
    [[nodiscard]] int tiles() const { return m_tiles; }
    /// How often a volume's voxels were brought to the card.
    [[nodiscard]] int volumesBrought() const;

    void setReading(CardReading reading);
    /// Samples that the first tile may have. Later ones follow the measured time.
    void setSamplesOfTile(double samples) { m_samplesOfTile = samples; }
    static constexpr double tileMilliseconds = 30.0;

    void release(vtkWindow* window);

private:
    struct OpenGl;
    bool check(vtkOpenGLRenderWindow& window, const KnownCardPicture& known);
    bool drawChecked(vtkOpenGLRenderWindow& window, const CardPicture& picture);
    bool prepareTargets(vtkOpenGLRenderWindow& window, const RayCastSettings& settings);
    bool drawWith(vtkOpenGLRenderWindow& window, const CardPicture& picture, const RayCastSettings& settings,
                  double weight);
    bool failed(vtkOpenGLRenderWindow& window);
    bool fail(std::string sentence);

    CardAnswers m_answers;
    CardReading m_reading = CardReading::filter;
    GraphicsCard m_card;
    vtkOpenGLRenderWindow* m_window = nullptr;  ///< the one met last; never used through this
    bool m_met = false, m_checked = false, m_isWrong = false;
    std::string m_failure;
    std::shared_ptr<const CardPicture> m_drawn;
    double m_samplesOfTile = firstSamplesOfTile;
    static constexpr double firstSamplesOfTile = 1 << 22;
    double m_uploadMilliseconds = 0.0, m_drawMilliseconds = 0.0;
    int m_tiles = 0;
    std::unique_ptr<OpenGl> m_openGl;
};

}  // namespace echolucent
