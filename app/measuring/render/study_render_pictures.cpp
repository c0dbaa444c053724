#include <algorithm>

#include "app/measuring/render/study_render.h"

namespace echolucent::cli {

namespace {

/// The two pixels beside a place between pixel centres, and the share of the second.
struct Neighbours {
    std::size_t first, second;
    float share;
};

std::vector<Neighbours> neighboursOf(int from, int to) {
    std::vector<Neighbours> all;
    for (int pixel = 0; pixel < to; ++pixel) {
        const double place = std::clamp((pixel + 0.5) * from / to - 0.5, 0.0, static_cast<double>(from - 1));
        const auto first = static_cast<std::size_t>(place);
        all.push_back({first, std::min(first + 1, static_cast<std::size_t>(from - 1)),
                       static_cast<float>(place - static_cast<double>(first))});
    }
    return all;
}

const float* pixelOf(const Picture& picture, std::size_t column, std::size_t row) {
    return &picture.rgba[(row * static_cast<std::size_t>(picture.width) + column) * 4];
}

}  // namespace

Picture enlarged(const Picture& picture, int width, int height) {
    if (picture.width == width && picture.height == height) return picture;
    const auto columns = neighboursOf(picture.width, width), rows = neighboursOf(picture.height, height);
    Picture large = emptyPicture(width, height);
    float* pixel = large.rgba.data();
    for (const Neighbours& row : rows)
        for (const Neighbours& column : columns)
            for (std::size_t channel = 0; channel < 4; ++channel) {
                const auto along = [&](std::size_t y) {
                    const float left = pixelOf(picture, column.first, y)[channel];
                    return left + column.share * (pixelOf(picture, column.second, y)[channel] - left);
                };
                const float above = along(row.first);
                *pixel++ = above + row.share * (along(row.second) - above);
            }
    return large;
}

Picture middleOf(const Picture& picture, int width, int height) {
    const int across = std::min(width, picture.width), down = std::min(height, picture.height);
    Picture middle = emptyPicture(across, down);
    float* pixel = middle.rgba.data();
    for (int row = 0; row < down; ++row) {
        const float* first = pixelOf(picture, static_cast<std::size_t>((picture.width - across) / 2),
                                     static_cast<std::size_t>((picture.height - down) / 2 + row));
        pixel = std::copy_n(first, static_cast<std::size_t>(across) * 4, pixel);
    }
    return middle;
}

Picture overviewOf(const Picture& picture, int edge) {
    const int square = std::max(1, (std::max(picture.width, picture.height) + edge - 1) / edge);
    Picture overview = emptyPicture(std::max(1, picture.width / square), std::max(1, picture.height / square));
    const float share = 1.0f / static_cast<float>(square * square);
    for (int row = 0; row < overview.height * square && row < picture.height; ++row)
        for (int column = 0; column < overview.width * square && column < picture.width; ++column) {
            const float* from = pixelOf(picture, static_cast<std::size_t>(column), static_cast<std::size_t>(row));
            float* to = &overview.rgba[static_cast<std::size_t>(row / square * overview.width + column / square) * 4];
            for (int channel = 0; channel < 4; ++channel) to[channel] += share * from[channel];
        }
    return overview;
}

Picture inGrey(Picture picture) {
    for (std::size_t i = 0; i + 3 < picture.rgba.size(); i += 4) {
        float* pixel = &picture.rgba[i];
        const float luminance = 0.2126f * pixel[0] + 0.7152f * pixel[1] + 0.0722f * pixel[2];
        std::fill_n(pixel, 3, luminance);
    }
    return picture;
}

}  // namespace echolucent::cli
