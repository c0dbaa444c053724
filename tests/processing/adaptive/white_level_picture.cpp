// A volume that uses a small part of its range looks as the same volume in 8 bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/phantom/phantom.h"
#include "processing/picture/look.h"
#include "processing/ray_caster/ray_caster.h"

namespace echolucent {
namespace {

/// A phantom's voxels stretched to 0 ... 158.
std::vector<std::uint16_t> words(const Volume& phantom) {
    const auto& bytes = std::get<VoxelArray<std::uint8_t>>(phantom.voxels());
    const double most = *std::max_element(bytes.begin(), bytes.end());
    std::vector<std::uint16_t> made;
    for (const std::uint8_t byte : bytes) made.push_back(static_cast<std::uint16_t>(std::lround(byte * 158.0 / most)));
    return made;
}

std::vector<std::uint8_t> pictureOf(const Volume& volume) {
    const auto otf = adaptOpacity(volume, {}, {});
    RayCastSettings settings = rayCastSettings(Look{});
    settings.width = settings.height = 96;
    settings.camera = defaultCamera(volume.geometry(), {}, 1.0);
    return overBackground(*castRays(volume, otf->curve, settings), {0, 0, 0});
}

double rmse(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    double squares = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) squares += std::pow(static_cast<double>(a[i]) - b[i], 2);
    return std::sqrt(squares / static_cast<double>(a.size()));
}

TEST(WhiteLevelPicture, SixteenBitsInASmallRangeLookAsEightBits) {
    PhantomConfig config;
    config.size = {72, 70, 76};
    config.seed = 11;
    const Volume phantom = *makePhantom(config);
    auto stored = words(phantom);
    std::vector<std::uint8_t> bytes;
    for (const std::uint16_t word : stored)
        bytes.push_back(static_cast<std::uint8_t>(std::lround(word * 255.0 / 158.0)));
    const auto eightBit = pictureOf(Volume(phantom.geometry(), bytes));
    ASSERT_GT(*std::max_element(eightBit.begin(), eightBit.end()), 60) << "there is something to see";
    EXPECT_LE(rmse(pictureOf(Volume(phantom.geometry(), stored)), eightBit), 2.0);
    for (const std::uint16_t hot : {std::uint16_t{200}, std::uint16_t{3000}, std::uint16_t{65535}}) {
        stored[stored.size() / 2] = hot;
        const Volume spoilt(phantom.geometry(), stored);
        EXPECT_EQ(spoilt.whiteLevel(), 158.0) << hot;
        EXPECT_LE(rmse(pictureOf(spoilt), eightBit), 2.0) << hot;
    }
}

}  // namespace
}  // namespace echolucent
