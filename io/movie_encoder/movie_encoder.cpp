#include "io/movie_encoder/movie_encoder.h"

#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <vector>

namespace {

struct Encoder {
    cv::VideoWriter writer;
    cv::Size size;
};

/// The four-letter codes to try, the best first.
std::vector<int> codesOf(EcholucentMovieCodec codec) {
    using cv::VideoWriter;
    switch (codec) {
        case echolucentMotionJpeg: return {VideoWriter::fourcc('M', 'J', 'P', 'G')};
        case echolucentH264: return {VideoWriter::fourcc('a', 'v', 'c', '1'), VideoWriter::fourcc('m', 'p', '4', 'v')};
        case echolucentLossless: return {VideoWriter::fourcc('F', 'F', 'V', '1')};
    }
    return {};
}

}  // namespace

// No exception may leave a C function.
void* echolucentOpenMovie(const char* path, EcholucentMovieCodec codec, int width, int height, double framesPerSecond) {
    try {
        // OpenCV stays silent: the caller reports a failure in one sentence.
        cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
        auto encoder = std::make_unique<Encoder>();
        encoder->size = cv::Size(width, height);
        for (const int code : codesOf(codec)) {
            if (!encoder->writer.open(path, cv::CAP_FFMPEG, code, framesPerSecond, encoder->size)) continue;
            return encoder.release();
        }
        return nullptr;
    } catch (...) {
        return nullptr;
    }
}

int echolucentAddPicture(void* encoder, const std::uint8_t* rgb) {
    try {
        auto& movie = *static_cast<Encoder*>(encoder);
        // OpenCV does not change these bytes, but takes no pointer to const.
        const cv::Mat picture(movie.size, CV_8UC3, const_cast<std::uint8_t*>(rgb));
        cv::Mat blueFirst;
        cv::cvtColor(picture, blueFirst, cv::COLOR_RGB2BGR);
        movie.writer.write(blueFirst);
        return 0;
    } catch (...) {
        return 1;
    }
}

void echolucentCloseMovie(void* encoder) {
    try {
        delete static_cast<Encoder*>(encoder);
    } catch (...) {
        // An incomplete file is found afterwards, when the pictures are counted.
    }
}

int echolucentCountPictures(const char* path, int width, int height, int (*cancelled)(const void*),
                            const void* context) {
    try {
        cv::VideoCapture movie(path, cv::CAP_FFMPEG);
        if (!movie.isOpened() || movie.get(cv::CAP_PROP_FRAME_WIDTH) != width ||
            movie.get(cv::CAP_PROP_FRAME_HEIGHT) != height)
            return -1;
        int count = 0;
        for (; movie.grab(); ++count)
            if (cancelled(context) != 0) return -1;
        return count;
    } catch (...) {
        return -1;
    }
}
