// Words in a picture that is written to a file.
#pragma once

#include <cstdint>
#include <vector>

namespace echolucent::cli {

/// Words in the lower left corner, as large as a sixteenth of the picture's height allows. rgb: width * height * 3
/// bytes.
void writeWords(std::vector<std::uint8_t>& rgb, int width, int height, const char* words);

}  // namespace echolucent::cli
