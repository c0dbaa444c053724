// Words in a picture that is written to a file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "processing/volume/volume.h"

namespace echolucent::cli {

/// The words that every picture of a volume must show: "spacing unknown", "reduced 2 x 2 x 2", both, or none.
[[nodiscard]] std::string pictureWordsOf(const VolumeGeometry& geometry);

/// The same as sentences for stderr. `picture` is "picture" or "movie".
[[nodiscard]] std::string pictureNotesOf(const VolumeGeometry& geometry, const std::string& picture);

/// Writes words into the lower left corner, as large as a sixteenth of the picture's height allows. rgb: width * height
/// * 3 bytes. Empty words change nothing.
void writeWords(std::vector<std::uint8_t>& rgb, int width, int height, const std::string& words);

}  // namespace echolucent::cli
