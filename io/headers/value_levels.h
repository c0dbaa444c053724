// The keys of this program for black and white in the headers of MetaImage and NRRD.
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "io/stored/stored_volume.h"

namespace echolucent {

/// The key that is wrong, and what is wrong with it, in lower case without full stop.
struct LevelProblem {
    std::string key;
    std::string problem;
};

/// Takes the texts of BlackLevel and WhiteLevel, each null if the header lacks it, into `stored`. Both are values of
/// the file. Fails if one is no finite number, or if white does not lie above black, which is 0 if it is not said.
[[nodiscard]] tl::expected<void, LevelProblem> readLevels(const std::string* black, const std::string* white,
                                                          StoredVolume& stored);

}  // namespace echolucent
