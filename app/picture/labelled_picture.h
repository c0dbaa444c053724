// A pane's picture as it leaves the window: with its measurements and labels.
#pragma once

#include <QImage>
#include <QString>
#include <cstddef>
#include <optional>

#include "processing/pane_picture/pane_caster.h"
#include "processing/sides/side_search.h"

namespace echolucent {

/// What only the caller knows of the labels.
struct LabelFacts {
    bool curveOfAnotherView;  ///< as curveIsOfAnotherView()
    bool curveIsTold;         ///< as in CaptionFacts
    const SidesFinding* sides;
    std::optional<std::size_t> remembered;  ///< as in CaptionFacts
    QString frame{};                        ///< which frame of a motion it is
};

/// The first pane's picture over black, with the measurements of the phase that `shown` shows and the labels of the
/// screen. `scale`: pixels of the picture in a pixel of a plain screen, for letters and lines. Any thread may call
/// this. Throws std::bad_alloc if there is no memory for the picture.
[[nodiscard]] QImage labelledPicture(const PanePicture& picture, const Document& shown, const LabelFacts& facts,
                                     double scale);

}  // namespace echolucent
