// What the movie module offers, in plain C: it is loaded only when a movie is written (io/output/movie_file.h).
#pragma once

#include <cstdint>

extern "C" {

/// An encoder of Motion JPEG in AVI that writes to `path`, or null where it cannot be made. Its pictures have
/// `width` x `height` pixels of 8-bit red, green, blue, rows from the top.
[[nodiscard]] void* echolucentOpenMovie(const char* path, int width, int height, double framesPerSecond);
/// Adds a picture of width * height * 3 bytes. Any other result than 0 means that it could not be encoded.
[[nodiscard]] int echolucentAddPicture(void* encoder, const std::uint8_t* rgb);
/// Ends the file and frees the encoder.
void echolucentCloseMovie(void* encoder);
/// How many pictures can be read from the file at `path`; below 0 where it is no movie.
[[nodiscard]] int echolucentCountPictures(const char* path);

}  // extern "C"
