// Why the picture on the screen looks as it does, in words.
#pragma once

#include <QString>

#include "io/study.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/picture/look.h"
#include "processing/ray_caster.h"
#include "processing/viewpoint.h"
#include "processing/volume/volume.h"
#include "widgets/otf_editor/otf_editor.h"
#include "processing/motion/motion_mode.h"

namespace echolucent {

/// What the picture is made of.
struct PictureFacts {
    const Study& study;
    const Volume& volume;
    const AdaptiveOtf* otf;  ///< null: not computed yet
    MotionOtf motion;        ///< which OTF the frames of a motion show
    Viewpoint view;
    CurveKind active;
    Look look;
    bool simulated;
};

/// A few plain sentences: what is shown, from where, which OTF decides what is seen, how it was found
/// (interface function, form and reading of the method), what becomes of it in a motion, what is assumed.
[[nodiscard]] QString explainPicture(const PictureFacts& facts);

}  // namespace echolucent
