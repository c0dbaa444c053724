// The functions of the movie module, in plain C. It is loaded only when a movie is written (io/writers/movie_file.h).
#pragma once

#include <cstdint>

extern "C" {

/// Codec and container. The file's name must end as the container demands.
enum EcholucentMovieCodec : int {
    echolucentMotionJpeg,  ///< Motion JPEG in AVI
    echolucentH264,        ///< H.264 in MP4, or MPEG-4 part 2 if OpenCV has no encoder of H.264
    echolucentLossless,    ///< FFV1 in Matroska: the pictures read back are the same to the bit
};

/// An encoder that writes to `path`, or null if it cannot be made. Its pictures have `width` x `height` pixels of 8-bit
/// red, green, blue, rows from the top. Both must be even, or OpenCV leaves out the last column or row.
[[nodiscard]] void* echolucentOpenMovie(const char* path, EcholucentMovieCodec codec, int width, int height,
                                        double framesPerSecond);
/// Adds a picture of width * height * 3 bytes. Returns 0, or another number if it could not be encoded.
[[nodiscard]] int echolucentAddPicture(void* encoder, const std::uint8_t* rgb);
/// Ends the file and frees the encoder.
void echolucentCloseMovie(void* encoder);
/// How many pictures of the file at `path` can be read. Below 0 if it is no movie of `width` x `height` pixels, or if
/// `cancelled(context)`, which is asked after each picture, is not 0.
[[nodiscard]] int echolucentCountPictures(const char* path, int width, int height, int (*cancelled)(const void*),
                                          const void* context);

}  // extern "C"
