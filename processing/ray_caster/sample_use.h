// Which samples a picture was made from.
#pragma once

namespace echolucent {

/// Where the samples of a picture came from.
enum class SampleUse {
    taken,    ///< they came from the volume; those of a view's second picture are kept on the way
    kept,     ///< they were kept from pictures of the same view before
    notKept,  ///< they came from the volume, and will again: they are too many to keep, or the mode keeps none
};

}  // namespace echolucent
