// Which samples a picture was made from.
#pragma once

namespace echolucent {

/// Where the samples of a picture came from.
enum class SampleUse {
    taken,    ///< from the volume; those of a view's second picture are kept on the way
    kept,     ///< kept from earlier pictures of the same view
    notKept,  ///< from the volume, and again the next time: they are too many to keep, or the mode keeps none
};

}  // namespace echolucent
