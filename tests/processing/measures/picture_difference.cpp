// Errors of pictures: known differences, and SSIM against its formula written out.
#include "app/measuring/measures/picture_difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace echolucent {
namespace {

Picture noise(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> share(0.0f, 1.0f);
    Picture picture{width, height, {}, {}};
    for (int i = 0; i < width * height * 4; ++i) picture.rgba.push_back(i % 4 == 3 ? 1.0f : share(random));
    return picture;
}

TEST(PictureDifference, EqualPicturesHaveNone) {
    for (const auto& [width, height] : {std::pair(40, 30), std::pair(7, 3), std::pair(1, 1)}) {
        const Picture picture = noise(width, height, 1);
        const PictureError error = pictureError(picture, picture);
        EXPECT_EQ(error.rmse, 0.0);
        EXPECT_EQ(error.largest, 0.0);
        EXPECT_NEAR(error.ssim, 1.0, 1e-9);
    }
}

TEST(PictureDifference, IsInLevelsAndBelowARoundedByte) {
    Picture reference{4, 2, std::vector<float>(32, 0.25f), {}}, picture = reference;
    for (std::size_t i = 0; i < 32; ++i) picture.rgba[i] += i % 4 == 3 ? 0.5f : 0.001f;  // alpha does not count
    PictureError error = pictureError(picture, reference);
    EXPECT_NEAR(error.rmse, 0.255, 1e-5);
    EXPECT_NEAR(error.largest, 0.255, 1e-5);
    picture = reference;
    picture.rgba[9] -= 0.1f;
    error = pictureError(picture, reference);
    EXPECT_NEAR(error.largest, 25.5, 1e-4);
    EXPECT_NEAR(error.rmse, 25.5 / std::sqrt(24.0), 1e-4) << "one of 8 pixels' 24 values";
}

// A constant offset leaves contrast and structure as they are: SSIM is its luminance term, (2 a b + c1) / (a^2 + b^2 +
// c1).
TEST(PictureDifference, SsimOfAnOffsetIsItsLuminanceTerm) {
    const Picture reference{20, 20, std::vector<float>(1600, 0.5f), {}};
    const Picture picture{20, 20, std::vector<float>(1600, 0.25f), {}};
    const double a = 127.5, b = 63.75, c1 = 2.55 * 2.55;
    EXPECT_NEAR(pictureError(picture, reference).ssim, (2 * a * b + c1) / (a * a + b * b + c1), 1e-9);
}

/// SSIM is computed by Wang et al. 2004, eqs. 14 to 16 and 13, window by window.
double ssimWrittenOut(const Picture& x, const Picture& y) {
    const auto luminance = [](const Picture& picture, int column, int row) {
        const float* pixel = &picture.rgba[static_cast<std::size_t>(row * picture.width + column) * 4];
        return 255 * (0.2126 * static_cast<double>(pixel[0]) + 0.7152 * static_cast<double>(pixel[1]) +
                      0.0722 * static_cast<double>(pixel[2]));
    };
    double total = 0.0, weightSum = 0.0;
    for (int i = -5; i <= 5; ++i)
        for (int k = -5; k <= 5; ++k) weightSum += std::exp(-(i * i + k * k) / (2 * 1.5 * 1.5));
    int windows = 0;
    for (int row = 5; row + 5 < x.height; ++row)
        for (int column = 5; column + 5 < x.width; ++column) {
            double mx = 0, my = 0;
            const auto over = [&](auto term) {
                double sum = 0;
                for (int i = -5; i <= 5; ++i)
                    for (int k = -5; k <= 5; ++k)
                        sum += std::exp(-(i * i + k * k) / (2 * 1.5 * 1.5)) / weightSum *
                               term(luminance(x, column + k, row + i), luminance(y, column + k, row + i));
                return sum;
            };
            mx = over([](double p, double) { return p; });
            my = over([](double, double q) { return q; });
            const double vx = over([&](double p, double) { return (p - mx) * (p - mx); });
            const double vy = over([&](double, double q) { return (q - my) * (q - my); });
            const double vxy = over([&](double p, double q) { return (p - mx) * (q - my); });
            const double c1 = 0.01 * 255 * 0.01 * 255, c2 = 0.03 * 255 * 0.03 * 255;
            total += (2 * mx * my + c1) * (2 * vxy + c2) / ((mx * mx + my * my + c1) * (vx + vy + c2));
            ++windows;
        }
    return total / windows;
}

TEST(PictureDifference, SsimFollowsItsFormula) {
    const Picture reference = noise(17, 14, 1);
    Picture picture = reference;
    const Picture other = noise(17, 14, 2);
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
        picture.rgba[i] = 0.7f * picture.rgba[i] + 0.3f * other.rgba[i];
    const double expected = ssimWrittenOut(picture, reference);
    EXPECT_GT(expected, 0.3);
    EXPECT_LT(expected, 0.95);
    EXPECT_NEAR(pictureError(picture, reference).ssim, expected, 1e-9);
    EXPECT_NEAR(pictureError(reference, picture).ssim, expected, 1e-9);
}

TEST(PictureDifference, SignedDifferenceIsGreyWhereNothingDiffers) {
    Picture reference{2, 1, {0.2f, 0.2f, 0.2f, 0.4f, 0.2f, 0.2f, 0.2f, 0.4f}, {}}, picture = reference;
    picture.rgba[4] += 0.01f;
    picture.rgba[5] -= 0.01f;
    picture.rgba[6] = 0.9f;
    const Picture difference = signedDifference(picture, reference, 8.0);
    const std::vector<float> expected{0.5f, 0.5f, 0.5f, 1.0f, 0.58f, 0.42f, 1.0f, 1.0f};
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(difference.rgba[i], expected[i], 1e-6) << i;
}

TEST(PictureDifference, RefusesPicturesOfOtherSizes) {
    EXPECT_THROW((void)pictureError(noise(3, 4, 1), noise(4, 3, 1)), std::invalid_argument);
    EXPECT_THROW((void)signedDifference(noise(3, 4, 1), noise(4, 3, 1), 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace echolucent
