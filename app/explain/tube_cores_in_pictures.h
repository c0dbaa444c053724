// Tube cores in the planes and in the 3D view: draws them, and a click on one chooses it.
#pragma once

#include <QObject>
#include <array>
#include <functional>
#include <memory>

#include "app/explain/tube_core_choice.h"
#include "app/otf/shown_panes.h"
#include "processing/explanation/tube_core_marks.h"
#include "widgets/marking_pointer.h"
#include "widgets/planes/plane_pane.h"

namespace echolucent {

class BoxIn3d;
class VolumeViewWidget;

/// Shows the tube cores of the scene's adaptive OTF while TubeCoreChoice says so and no motion plays. A left click on
/// one chooses it; a drag that begins there does what it does elsewhere. While a tool is in the hand, the tool gets the
/// click.
class TubeCoresInPictures : public QObject {
    Q_OBJECT

public:
    struct Parts {
        TubeCoreChoice& choice;
        PaneOtfs& otfs;
        ShownPanes& panes;
        std::array<PlanePane*, 3> planes;  ///< A, B, C
        VolumeViewWidget& picture;
        BoxIn3d& overlay;
        std::function<bool()> handIsFree;  ///< whether no tool is in the hand
    };
    /// What the parameters refer to must outlive this object.
    explicit TubeCoresInPictures(Parts parts, QObject* parent = nullptr);

    /// What is drawn now; null if nothing is.
    [[nodiscard]] const std::shared_ptr<const TubeCoreMarks>& marks() const { return m_marks; }

signals:
    /// A click in a picture has chosen a tube core, perhaps the one that was chosen already.
    void clicked();

private:
    void follow();
    void choose(std::optional<int> number);
    [[nodiscard]] std::optional<int> in3dAt(const QPointF& pixel) const;

    Parts m_parts;
    std::shared_ptr<const ComputedOtf> m_drawn;  ///< whose marks m_marks are
    std::shared_ptr<const TubeCoreMarks> m_marks;
};

}  // namespace echolucent
