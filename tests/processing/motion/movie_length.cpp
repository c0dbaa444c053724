#include "processing/motion/movie_length.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace echolucent {
namespace {

constexpr MovieLength loops(double amount) { return {MovieLengthUnit::loops, amount}; }
constexpr MovieLength seconds(double amount) { return {MovieLengthUnit::seconds, amount}; }

TEST(MovieLength, LoopsRepeatAllFramesAsLongAsTheyAreHeld) {
    EXPECT_EQ(framesOfPictures({1, 1, 1}, loops(1), 20), (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(framesOfPictures({1, 2}, loops(3), 20), (std::vector<int>{0, 1, 1, 0, 1, 1, 0, 1, 1}));
    EXPECT_EQ(framesOfPictures(std::vector<int>(20, 1), loops(99), 0.5).size(), 1980u) << "whatever the rate";
}

TEST(MovieLength, SecondsCountAtTheMoviesOwnRate) {
    EXPECT_EQ(framesOfPictures({1, 1, 1}, seconds(0.5), 10), (std::vector<int>{0, 1, 2, 0, 1}));
    EXPECT_EQ(framesOfPictures({1, 1, 1}, seconds(0.2), 10), (std::vector<int>{0, 1})) << "shorter than a loop";
    EXPECT_EQ(framesOfPictures({1, 1, 1}, seconds(10), 29.97).size(), 300u) << "to the nearest picture";
    EXPECT_EQ(framesOfPictures({3, 1}, seconds(0.001), 10), std::vector<int>{0});
}

TEST(MovieLength, NoMovieIsWithoutFramesOrLength) {
    for (const MovieLength& length : {loops(0), loops(1.5), loops(-1), seconds(0), seconds(-2)})
        EXPECT_THROW((void)framesOfPictures({1}, length, 10), std::invalid_argument) << length.amount;
    EXPECT_THROW((void)framesOfPictures({}, loops(1), 10), std::invalid_argument);
}

}  // namespace
}  // namespace echolucent
