// Words in a picture that is written to a file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "processing/volume/volume.h"

namespace echolucent::cli {

/// The words that every picture of a volume must show: "spacing unknown", "reduced 2 x 2 x 2", both, or none.
[[nodiscard]] std::string pictureWordsOf(const VolumeGeometry& geometry);

/// The facts of pictureWordsOf() as sentences for stderr, one a line. `picture` is "picture" or "movie".
[[nodiscard]] std::string pictureNotesOf(const VolumeGeometry& geometry, const std::string& picture);

/// Writes words into the lower left corner. Within limits, the letters grow with the picture's height. rgb: width *
/// height * 3 bytes. Empty words change nothing. Words that are too long for the width are cut off.
void writeWords(std::vector<std::uint8_t>& rgb, int width, int height, const std::string& words);

}  // namespace echolucent::cli
