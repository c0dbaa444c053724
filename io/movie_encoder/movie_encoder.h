// What the movie module offers, in plain C: it is loaded only when a movie is written (io/writers/movie_file.h).
#pragma once

#include <cstdint>

extern "C" {

/// How pictures are encoded, and what holds them; the file's name ends as the container does.
enum EcholucentMovieCodec : int {
    echolucentMotionJpeg,  ///< Motion JPEG in AVI
    echolucentH264,        ///< H.264 in MP4, or MPEG-4 part 2 where OpenCV has no encoder of H.264
    echolucentLossless,    ///< FFV1 in Matroska: pictures are read back to the bit
};

/// An encoder that writes to `path`, or null where it cannot be made. Its pictures have `width` x `height` pixels of
/// 8-bit red, green, blue, rows from the top; of an odd width or height OpenCV would leave out the last column or row.
[[nodiscard]] void* echolucentOpenMovie(const char* path, EcholucentMovieCodec codec, int width, int height,
                                        double framesPerSecond);
/// Adds a picture of width * height * 3 bytes. Any other result than 0 means that it could not be encoded.
[[nodiscard]] int echolucentAddPicture(void* encoder, const std::uint8_t* rgb);
/// Ends the file and frees the encoder.
void echolucentCloseMovie(void* encoder);
/// How many pictures can be read from the file at `path`; below 0 where it is no movie of `width` x `height` pixels, or
/// where `cancelled(context)`, which is asked before each, is not 0.
[[nodiscard]] int echolucentCountPictures(const char* path, int width, int height, int (*cancelled)(const void*),
                                          const void* context);

}  // extern "C"
