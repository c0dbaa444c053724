// The caption in the picture: what was done to it, and by whom.
#pragma once

#include <QString>
#include <optional>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/document/document.h"
#include "processing/sides/side_search.h"
#include "processing/volume/reduction.h"

namespace echolucent {

/// What was done with the speckle in the picture.
enum class ShownSpeckle {
    asRead,        ///< the voxels are shown as they were read
    beingReduced,  ///< the voxels are shown as they were read, until their quiet voxels are made
    reduced,       ///< quiet voxels are shown, as the look asks
};

/// What the caption needs beside the document.
struct CaptionFacts {
    const Document& document;
    ShownSpeckle speckle = ShownSpeckle::asRead;
    bool curveOfAnotherView = false;      ///< as curveIsOfAnotherView()
    bool curveIsTold = true;              ///< whether the caption says for which phase or view the curve was computed
    bool designIsShown = true;            ///< if the first pane has a designer, whether that designer's OTF is shown
    const SidesFinding* sides = nullptr;  ///< of the document's beam; null until they are found
    /// Place of the side that opening took because a person took it last of such a scan.
    std::optional<std::size_t> remembered{};
    bool lengthsKnown = true;              ///< the volume's spacing is known, so lengths in mm may be told
    std::optional<Reduction> reduction{};  ///< of the volume, if the file holds more voxels than were kept
};

/// Whether the picture's curve was computed for another direction than that of the picture: the hand has turned the
/// view since. Only adaptive curves count, and those of designers that read tube cores, in direct rendering. Frames of
/// a motion do not count as views of their own. `otf` is the adaptive OTF that is shown; null if there is none yet. It
/// is not read if the first pane has a designer.
[[nodiscard]] bool curveIsOfAnotherView(const Document& document, const AdaptiveOtf* otf);
/// The answer if the picture's OTF, computed or to come, is that of the viewpoint `ofOtf`.
[[nodiscard]] bool curveIsOfAnotherView(const Document& document, const Viewpoint& ofOtf);

/// The caption has one or two lines. The first says the side, the front and the smoothing. The second says what else a
/// person has to know: that voxels are means of several; which designer made the OTF; which phase gave the one OTF of
/// all phases, and that the curve was computed for another view, if the curve is told.
[[nodiscard]] QString pictureCaption(const CaptionFacts& facts);

}  // namespace echolucent
