// Draws pictures on a graphics card, into textures.
#pragma once

#include <chrono>
#include <limits>
#include <memory>
#include <string>

#include "processing/card_picture/card_picture.h"
#include "widgets/volume_view/scene/graphics_card/card_answers.h"
#include "widgets/volume_view/scene/graphics_card/card_shader.h"

class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

namespace echolucent {

/// Draws the picture of a CardPicture as castRays() casts it (docs/rendering.md, "On a graphics card"), but finds no
/// depths of pixels. Before the first picture in a context it draws a known one, and draws nothing if the card draws
/// that wrongly. It draws a picture in bands of rows that each take about bandMilliseconds, because drivers end
/// drawings that take seconds. So a picture may also be drawn in several calls. Only the thread of the window may use
/// it, and only while the window's context is current.
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

    enum class Drawing { done, goesOn, failed };
    /// Draws a picture, unless it is the newest one drawn. If that takes longer than `patienceMilliseconds`, the next
    /// call with the same picture goes on with it. If something failed, failure() says what, and nothing is drawn any
    /// more before the failure is forgotten. `known` is not null.
    Drawing draw(vtkOpenGLRenderWindow& window, const std::shared_ptr<const CardPicture>& picture,
                 const std::shared_ptr<const KnownCardPicture>& known,
                 double patienceMilliseconds = std::numeric_limits<double>::infinity());
    /// Whether a picture was begun and is not done.
    [[nodiscard]] bool goesOn() const { return m_begun.picture != nullptr; }
    /// The newest picture that is done; null if there is none. It stays while another is drawn.
    [[nodiscard]] const std::shared_ptr<const CardPicture>& drawn() const { return m_drawn; }
    /// Its premultiplied colours, rows from the top.
    [[nodiscard]] vtkTextureObject& colours();
    /// The same, read back.
    [[nodiscard]] Picture read() const;

    /// A sentence that says why the card does not draw; empty if it may.
    [[nodiscard]] const std::string& failure() const { return m_failure; }
    /// Another volume or the person's choice gives the card another chance. A card that draws wrongly gets none.
    void forgetFailure();
    /// Lets go of what was drawn, so that its volume can be freed.
    void forgetPictures();
    /// Wall time of the newest picture: bringing it to the card, and drawing it.
    [[nodiscard]] double uploadMilliseconds() const { return m_uploadMilliseconds; }
    [[nodiscard]] double drawMilliseconds() const { return m_drawMilliseconds; }
    /// Bands of the newest picture.
    [[nodiscard]] int bands() const { return m_bands; }
    /// How often a volume's voxels were brought to the card.
    [[nodiscard]] int volumesBrought() const;

    void setReading(CardReading reading);
    /// Samples that the first band may have. Later ones follow the measured time.
    void setSamplesOfBand(double samples) { m_samplesOfBand = samples; }
    static constexpr double bandMilliseconds = 30.0;

    void release(vtkWindow* window);

private:
    struct OpenGl;
    /// A picture that is being drawn.
    struct Begun {
        std::shared_ptr<const CardPicture> picture;
        bool mixesIn = false;  ///< whether the picture is there and the other mode is mixed into it
        int nextRow = 0;
    };
    using Time = std::chrono::steady_clock::time_point;
    bool check(vtkOpenGLRenderWindow& window, const std::shared_ptr<const KnownCardPicture>& known);
    bool begin(vtkOpenGLRenderWindow& window, const std::shared_ptr<const CardPicture>& picture);
    Drawing goOn(vtkOpenGLRenderWindow& window, Time until);
    bool prepareTargets(vtkOpenGLRenderWindow& window, const RayCastSettings& settings);
    bool prepareProgram(vtkOpenGLRenderWindow& window, const RayCastSettings& settings);
    bool drawBands(vtkOpenGLRenderWindow& window, const RayCastSettings& settings, double weight, Time until);
    bool failed(vtkOpenGLRenderWindow& window);
    /// The picture before stays.
    bool fail(std::string sentence);
    /// Nothing stays.
    void lose();

    CardAnswers m_answers;
    CardReading m_reading = CardReading::filter;
    GraphicsCard m_card;
    vtkOpenGLRenderWindow* m_window = nullptr;  ///< the one met last; never used through this
    bool m_met = false, m_checked = false, m_isWrong = false;
    std::string m_failure;
    std::shared_ptr<const CardPicture> m_drawn;
    Begun m_begun;
    double m_samplesOfBand = firstSamplesOfBand;
    static constexpr double firstSamplesOfBand = 1 << 22;
    double m_uploadMilliseconds = 0.0, m_drawMilliseconds = 0.0;
    int m_bands = 0;
    std::unique_ptr<OpenGl> m_openGl;
};

}  // namespace echolucent
