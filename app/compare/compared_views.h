// The pictures of a comparison: casts the panes and shows them.
#pragma once

#include <QImage>
#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "app/otf/shown_panes.h"
#include "processing/comparison/surface_picture.h"
#include "processing/document/panes.h"
#include "widgets/casting/progressive_caster.h"
#include "widgets/compare/compare_grid.h"
#include "widgets/compare/compare_rows.h"
#include "widgets/document/document_model.h"

namespace echolucent {

class Works;

/// What a pane is coloured by.
struct ColouredRays {
    std::shared_ptr<const SurfaceRectangles> rectangles;
    std::vector<ShownSurface> shown;  ///< of each ray
};

/// The name of a pane, and the colour and dashes of its curve. A curve has the same everywhere, and so has the adaptive
/// OTF. The OTF of another designer has none. A piecewise linear curve of the pane's own stands beside that of eq. 1,
/// so it has another colour.
[[nodiscard]] PaneFace faceOf(const Document& document, std::size_t place);

/// Casts the visible panes with exactly the camera of the first pane. Puts pictures, names and numbers into the grid.
/// The document alone says what is compared.
class ComparedViews : public QObject {
    Q_OBJECT

public:
    struct Parts {
        DocumentModel& model;
        OpenStudy& openStudy;
        Works& works;
        PaneOtfs& otfs;
        ShownPanes& panes;
        CompareGrid& grid;
    };
    /// What the parameters refer to must outlive this object.
    explicit ComparedViews(const Parts& parts, QObject* parent = nullptr);

    /// Shows or hides the comparison. While it is hidden, nothing is cast, and no designer runs for it.
    void setShown(bool shown);
    [[nodiscard]] bool shown() const { return m_shown; }
    /// Whether the screen shows what the document says, in any quality. True also if no picture is asked for.
    [[nodiscard]] bool frameIsCurrent() const;
    /// Whether every pane shows what the document asks for, converged.
    [[nodiscard]] bool settled() const;
    /// Whether some pane will not show what the document asks for: its OTF was cancelled or has failed. False while the
    /// comparison is hidden.
    [[nodiscard]] bool refused() const;
    /// ShownPanes::at().
    [[nodiscard]] const ShownPane& paneAt(std::size_t place) const { return m_parts.panes.at(place); }
    /// The newest frame; null before the first.
    [[nodiscard]] const std::shared_ptr<const CastPicture>& frame() const { return m_frame; }
    /// The images of the frame's panes, as shown: coloured if they are.
    [[nodiscard]] const std::vector<QImage>& images() const { return m_shownImages; }
    /// The image of one of the frame's panes for a file: with its legend, if it is coloured.
    [[nodiscard]] QImage imageToSave(std::size_t index) const;
    /// Sets whether each pane shows its OTF. On the full screen each does, and texts are for a projector.
    void setInsets(bool shown);
    void setFullScreen(bool full);
    /// Whether a pane of the frame is coloured.
    [[nodiscard]] bool coloured() const;
    /// Adds the milliseconds of a pane's picture if it is converged and not made of kept samples.
    void addTime(std::size_t place, CompareRow& row) const;
    /// The measures of the panes, by place; shown under the panes.
    void setRows(const std::vector<CompareRow>& rows);
    /// Colours the panes, by place; a pane without rays, or without a place in the list, is plain. Differences are
    /// plain. The colours hold for any camera along the view whose rays they are.
    void setColours(const std::vector<std::shared_ptr<const ColouredRays>>& colours);

public slots:
    /// Shows what the document says. Runs by itself when the document, an OTF or the arrangement of the panes changes.
    void follow();

signals:
    void frameShown();
    /// The panes may show, or ask for, something else.
    void followed();
    void failed();

private:
    [[nodiscard]] std::vector<std::size_t> placesWanted() const;
    /// Whether the frame has the panes of the newest request.
    [[nodiscard]] bool frameHasPanesAsked() const;
    void take(const std::shared_ptr<const CastPicture>& frame);
    [[nodiscard]] const ColouredRays* coloursAt(std::size_t place) const;
    [[nodiscard]] SurfaceLegend legendAt(std::size_t place) const;
    [[nodiscard]] QStringList names() const;
    void colourImages();
    void showFrame();
    void showFaces();
    void showPair();
    void stopCasting();
    void clear();
    void forgetStudy();

    Parts m_parts;
    bool m_shown = false;
    const Study* m_study = nullptr;  ///< of m_frame or of the newest request; compared by address only
    PictureRequest m_asked;          ///< the newest request; without panes if nothing is asked for
    std::shared_ptr<const CastPicture> m_frame;
    std::vector<QImage> m_images;                                   ///< of m_frame's panes
    ComparisonLayout m_colouredFor = ComparisonLayout::sideBySide;  ///< of m_shownImages
    std::vector<QImage> m_shownImages;                              ///< the same, coloured if they are
    std::vector<std::shared_ptr<const ColouredRays>> m_colours;     ///< by place
    std::vector<CompareRow> m_rows;
    /// The sources of the picture of a pair.
    struct ShownPair {
        std::shared_ptr<const CastPicture> frame;
        Comparison comparison;
        QString first, second;  ///< their names
        friend bool operator==(const ShownPair&, const ShownPair&) = default;
    };
    std::optional<ShownPair> m_pair;
    bool m_insets = false, m_fullScreen = false;
    bool m_waits = false;  ///< whether the panes keep their pictures until an OTF is there
    ProgressiveCaster m_caster;
};

}  // namespace echolucent
