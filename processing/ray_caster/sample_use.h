// Which samples a picture was made from.
#pragma once

namespace echolucent {

/// Where the samples of a picture came from.
enum class SampleUse {
    taken,    ///< from the volume; those of a view's second picture are kept on the way
    kept,     ///< from the pictures before, of the same view
    notKept,  ///< from the volume, and so they will be again: they are too many to keep, or the mode keeps none
};

}  // namespace echolucent
