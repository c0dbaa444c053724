// One picture of all panes, or of the 3D view, in any size.
#pragma once

#include <QImage>
#include <QRect>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "processing/pane_picture/pane_caster.h"
#include "processing/progress.h"
#include "processing/sides/side_search.h"
#include "widgets/compare/pane_face.h"
#include "widgets/planes/grey_image.h"
#include "widgets/planes/plane_resampler.h"

namespace echolucent {

/// A plane's pane in the picture.
struct PlaneInPicture {
    QRect place;           ///< in pixels of the picture
    PlaneRequest request;  ///< in the size of `place`
    GreyScale greys;
    QImage drawings;  ///< as PlanePane::drawings()
};

/// A pane of the comparison in the picture.
struct ComparedInPicture {
    QRect place;           ///< in pixels of the picture
    std::size_t pane = 0;  ///< of the document
    PaneFace face;
    Classification classification{};  ///< that the pane shows: in a motion it may be smoothed
};

/// All that a picture of panes is made from, as values.
struct PanesInPicture {
    Document document{};
    StudyPhases phases{};
    std::shared_ptr<const SidesFinding> sides{};  ///< of the document's beam, for the caption; null until found
    QSize size{};                                 ///< of the picture, pixels
    bool curveIsTold;                             ///< as in CaptionFacts; each caller decides
    std::optional<std::size_t> remembered;        ///< as in CaptionFacts; each caller decides
    double scale = 1.0;                           ///< pixels of the picture in a pixel of the screen
    double words = 1.0;                           ///< how much larger letters and lines are than `scale` makes them
    std::optional<QRect> of3d{};                  ///< the place of the 3D view; no value if it is not in the picture
    std::vector<PlaneInPicture> planes{};
    std::vector<ComparedInPicture> compared{};
    QFont letters{};  ///< of the texts below compared panes, in pixels of the screen
};

/// The picture, over black. The 3D view is PaneCaster::picture() of the first pane in its size, with the measurements
/// of its phase and the labels of the screen. Planes are sampled in their size. A compared pane is
/// PaneCaster::pictureOf() of its pane, with its face, which says nothing of colours: these are the screen's. The
/// result is empty only if progress.cancel was raised. Any thread may call this. Throws std::bad_alloc if there is no
/// memory for the picture.
[[nodiscard]] std::optional<QImage> panesPicture(const PanesInPicture& panes, const Progress& progress = {});

}  // namespace echolucent
