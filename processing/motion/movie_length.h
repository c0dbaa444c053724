// How long a movie of a motion is, and which frame each of its pictures shows.
#pragma once

#include <vector>

namespace echolucent {

/// In what the length of a movie is counted.
enum class MovieLengthUnit {
    loops,    ///< of its frames: beats of a heart, turns of a probe
    seconds,  ///< of the movie's own time
};

struct MovieLength {
    MovieLengthUnit unit = MovieLengthUnit::loops;
    double amount = 1.0;  ///< above 0; of loops a whole number
    friend bool operator==(const MovieLength&, const MovieLength&) = default;
};

/// The frame, counted from 0, that each picture of a movie shows. A frame has as many pictures as `held` says
/// (HeldFrames::pictures: each at least 1), and after the last frame comes the first one again. With
/// MovieLengthUnit::seconds there are as many pictures as come nearest to that time at `framesPerSecond` (above 0), at
/// least one, so that the last loop may end early. Throws std::invalid_argument if there are no frames, if the amount
/// is not above 0, or if loops are not whole.
[[nodiscard]] std::vector<int> framesOfPictures(const std::vector<int>& held, const MovieLength& length,
                                                double framesPerSecond);

}  // namespace echolucent
