// The line in the picture that says what was done to it, and by whom.
#pragma once

#include <QString>
#include <optional>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/document/document.h"
#include "processing/volume/reduction.h"

namespace echolucent {

/// What has become of the speckle in the picture.
enum class ShownSpeckle {
    asRead,        ///< the voxels are shown as they were read
    beingReduced,  ///< so they are, until their quiet voxels are made
    reduced,       ///< quiet voxels are shown, as the look asks
};

/// What the caption tells beside the document.
struct CaptionFacts {
    const Document& document;
    ShownSpeckle speckle = ShownSpeckle::asRead;
    bool curveOfAnotherView = false;       ///< as curveIsOfAnotherView()
    bool designIsShown = true;             ///< where the view has a designer, it made the OTF that is shown
    bool lengthsKnown = true;              ///< the volume's spacing is known, so that lengths in mm may be told
    std::optional<Reduction> reduction{};  ///< of the volume, where the file holds more voxels than were kept
};

/// Whether the picture's curve is adaptive, or made by a designer that reads tube cores, and was computed for another
/// direction than the picture is seen along: the hand has turned the view since. The frames of a motion are no views of
/// their own in this. `otf` may be null.
[[nodiscard]] bool curveIsOfAnotherView(const Document& document, const AdaptiveOtf* otf);
/// The same of an OTF that was computed, or will be, for this viewpoint.
[[nodiscard]] bool curveIsOfAnotherView(const Document& document, const Viewpoint& ofOtf);

/// One line for each of these that is true: that voxels are means of several, which way round and how that is known,
/// what is cut off and who cut it, how much speckle was taken away, which light falls, which designer made the OTF,
/// which phase the one OTF of all phases is of, that the curve was computed for another view.
[[nodiscard]] QString pictureCaption(const CaptionFacts& facts);

}  // namespace echolucent
