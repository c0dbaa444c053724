// Why the picture on the screen looks as it does, in words.
#pragma once

#include <QString>

#include "app/otf/pane_otfs.h"
#include "app/picture/picture_caption.h"
#include "io/study/study.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/document/document.h"

namespace echolucent {

/// What the picture is made of.
struct PictureFacts {
    const Study& study;
    const Volume& volume;
    const AdaptiveOtf* otf;  ///< null where it is not computed yet
    const Document& document;
    ShownSpeckle speckle = ShownSpeckle::asRead;
    /// What the designer of the view made; null where the view has none, or it is not computed yet.
    const ComputedOtf* design = nullptr;
    bool designIsNewest = true;  ///< else it is computed anew, or that was cancelled
};

/// A few plain sentences: what is shown, from where, which OTF decides what is seen, how it was found
/// (interface function, form and reading of the method), what becomes of it in a motion, what is assumed.
[[nodiscard]] QString explainPicture(const PictureFacts& facts);

}  // namespace echolucent
