#include "processing/motion/movie_length.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace echolucent {

std::vector<int> framesOfPictures(const std::vector<int>& held, const MovieLength& length, double framesPerSecond) {
    const bool loops = length.unit == MovieLengthUnit::loops;
    if (held.empty() || !(length.amount > 0.0) || (loops && length.amount != std::floor(length.amount)))
        throw std::invalid_argument("framesOfPictures: a movie needs frames, and a length above 0 in whole loops");
    std::vector<int> loop;
    for (std::size_t frame = 0; frame < held.size(); ++frame)
        loop.insert(loop.end(), static_cast<std::size_t>(held[frame]), static_cast<int>(frame));
    const double pictures = loops ? length.amount * static_cast<double>(loop.size())
                                  : std::max(1.0, std::round(length.amount * framesPerSecond));
    std::vector<int> frames(static_cast<std::size_t>(pictures));
    for (std::size_t picture = 0; picture < frames.size(); ++picture) frames[picture] = loop[picture % loop.size()];
    return frames;
}

}  // namespace echolucent
