#include "io/writers/looped_pictures.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>

namespace echolucent {
namespace {

constexpr std::size_t pictureBytes = 3000;

/// A picture that cannot be packed, its own for each frame.
MoviePicture pictureOf(int frame) {
    std::mt19937 random(static_cast<unsigned>(frame));
    MoviePicture rgb(pictureBytes);
    for (std::uint8_t& byte : rgb) byte = static_cast<std::uint8_t>(random());
    return rgb;
}

struct Looped {
    std::map<int, int> made;  ///< how often, by frame
    std::vector<MoviePicture> added;
};

Looped looped(const std::vector<int>& frames, std::size_t mostBytes) {
    Looped loop;
    const auto make = [&](int frame) -> Result<MoviePicture> {
        ++loop.made[frame];
        return pictureOf(frame);
    };
    const auto add = [&](std::span<const std::uint8_t> rgb) -> Result<void> {
        loop.added.emplace_back(rgb.begin(), rgb.end());
        return {};
    };
    EXPECT_TRUE(addLooped(frames, make, add, mostBytes));
    return loop;
}

void expectPictures(const Looped& loop, const std::vector<int>& frames) {
    ASSERT_EQ(loop.added.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) EXPECT_EQ(loop.added[i], pictureOf(frames[i])) << i;
}

TEST(LoopedPictures, NoFrameIsMadeTwice) {
    const std::vector<int> frames{0, 1, 1, 2, 0, 1, 1, 2, 0, 1};
    const Looped loop = looped(frames, mostBytesOfLoop);
    expectPictures(loop, frames);
    EXPECT_EQ(loop.made, (std::map<int, int>{{0, 1}, {1, 1}, {2, 1}}));
}

TEST(LoopedPictures, WhatHasNoRoomIsMadeAnewAndTheSame) {
    const std::vector<int> frames{0, 1, 2, 0, 1, 2, 0, 1, 2};
    const Looped loop = looped(frames, 2 * pictureBytes + pictureBytes / 2);
    expectPictures(loop, frames);
    EXPECT_EQ(loop.made, (std::map<int, int>{{0, 1}, {1, 1}, {2, 3}}));
    const Looped none = looped(frames, 0);
    expectPictures(none, frames);
    EXPECT_EQ(none.made.at(0), 3);
}

TEST(LoopedPictures, AFrameThatIsOnlyHeldTakesNoRoom) {
    // Frame 0 comes once, though in three pictures: the room is for frame 1.
    const std::vector<int> frames{0, 0, 0, 1, 2, 1};
    const Looped loop = looped(frames, pictureBytes + pictureBytes / 2);
    expectPictures(loop, frames);
    EXPECT_EQ(loop.made, (std::map<int, int>{{0, 1}, {1, 1}, {2, 1}}));
}

TEST(LoopedPictures, AFailureEndsTheMovie) {
    int added = 0;
    const auto make = [](int frame) -> Result<MoviePicture> {
        if (frame == 1) return fail(FailureKind::cancelled, "m.mkv", "", "was cancelled");
        return pictureOf(frame);
    };
    const auto add = [&](std::span<const std::uint8_t>) -> Result<void> {
        if (++added == 3) return fail(FailureKind::unwritable, "m.mkv", "", "is full");
        return {};
    };
    EXPECT_EQ(addLooped({0, 1}, make, add).error().kind, FailureKind::cancelled);
    EXPECT_EQ(added, 1);
    EXPECT_EQ(addLooped({0, 0, 0}, make, add).error().kind, FailureKind::unwritable);
    EXPECT_EQ(added, 3);
}

}  // namespace
}  // namespace echolucent
