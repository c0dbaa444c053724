#include "io/movie_encoder/movie_encoder.h"

#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

namespace {

/// The quality of JPEG at which speckle shows no blocks.
constexpr double quality = 95;

struct Encoder {
    cv::VideoWriter writer;
    cv::Size size;
};

}  // namespace

// No exception may leave a C function.
void* echolucentOpenMovie(const char* path, int width, int height, double framesPerSecond) {
    try {
        // What goes wrong is said in one sentence by the caller.
        cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
        auto encoder = std::make_unique<Encoder>();
        encoder->size = cv::Size(width, height);
        const int code = cv::VideoWriter::fourcc('M', 'J', 'P', 'G');
        if (!encoder->writer.open(path, cv::CAP_OPENCV_MJPEG, code, framesPerSecond, encoder->size)) return nullptr;
        encoder->writer.set(cv::VIDEOWRITER_PROP_QUALITY, quality);
        return encoder.release();
    } catch (...) {
        return nullptr;
    }
}

int echolucentAddPicture(void* encoder, const std::uint8_t* rgb) {
    try {
        auto& movie = *static_cast<Encoder*>(encoder);
        // OpenCV takes bytes it promises not to change through a pointer that could.
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
        // The pictures are counted afterwards: a file that is not whole is seen there.
    }
}

int echolucentCountPictures(const char* path) {
    try {
        cv::VideoCapture movie(path, cv::CAP_OPENCV_MJPEG);
        if (!movie.isOpened()) return -1;
        int count = 0;
        while (movie.grab()) ++count;
        return count;
    } catch (...) {
        return -1;
    }
}
