#include "processing/volume/black_level.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace echolucent {
namespace {

/// A view of these values, and what they reach.
struct Values {
    std::vector<double> all;
    [[nodiscard]] ValueExtent extent() const {
        ValueExtent reached;
        for (const double value : all) reached.add(value);
        return reached;
    }
    [[nodiscard]] ValueBlocks blocks() const {
        return [this](const std::function<void(std::span<const double>)>& take) { take(all); };
    }
    [[nodiscard]] BlackLevel black() const { return blackLevelOf(blocks(), false, extent()); }
    [[nodiscard]] ValueScale scale() const { return scaleFrom(black().level, blocks(), false, extent()); }
};

/// 1000 values from `low` to `high`, evenly.
Values between(double low, double high) {
    Values values;
    for (int i = 0; i < 1000; ++i) values.all.push_back(std::lerp(low, high, i / 999.0));
    return values;
}

TEST(BlackLevel, IsZeroWhereThatHidesLittle) {
    for (const auto& [low, high] : {std::pair{0.0, 255.0}, {5.0, 255.0}, {-20.0, 255.0}, {-1.0, 500.0}, {7.0, 7.0}}) {
        EXPECT_EQ(between(low, high).black().level, 0.0) << low << " " << high;
        EXPECT_TRUE(between(low, high).scale().isIdentity()) << low << " " << high;
    }
    EXPECT_FALSE(mayNeedWindow(between(0.0, 255.0).extent()));
    EXPECT_FALSE(mayNeedWindow(Values{{std::nan(""), HUGE_VAL}}.extent()));
    EXPECT_TRUE(mayNeedWindow(between(-1.0, 500.0).extent()));
}

TEST(BlackLevel, IsTheLowEndWhereZeroHidesMuch) {
    EXPECT_EQ(between(-40.0, 255.0).black().level, -40.0);
    EXPECT_EQ(between(-60.0, 0.0).black().level, -60.0);
    EXPECT_EQ(between(-1018.0, -794.0).black().level, -1018.0);
    EXPECT_EQ(between(1e6, 1e6 + 1).black().level, 1e6);
    EXPECT_EQ(between(-7.0, -7.0).black().level, -7.0);
    Values shallow = between(-0.5, 0.0);  // noise around 0
    for (int i = 0; i < 1000; ++i) shallow.all.push_back(100.0);
    EXPECT_EQ(shallow.black().level, 0.0);
}

TEST(BlackLevel, ColdVoxelsAndPaddingMoveNothing) {
    Values values = between(-60.0, -1.0);
    values.all[3] = -1e9;
    EXPECT_EQ(values.black().level, -60.0);
    EXPECT_EQ(values.black().below, 1);
    EXPECT_EQ(values.black().lowest, -1e9);
    Values padded = between(-60.0, -1.0);
    for (int i = 0; i < 500; ++i) padded.all.push_back(-32768.0);
    EXPECT_EQ(padded.black().level, -60.0);
    EXPECT_EQ(padded.black().padding, -32768.0);
    EXPECT_EQ(padded.black().below, 500);
    Values positive = between(1.0, 200.0);
    for (int i = 0; i < 500; ++i) positive.all.push_back(-32768.0);
    EXPECT_EQ(positive.black().level, 0.0);
    Values twoAlone{{}};
    for (int i = 0; i < 500; ++i) twoAlone.all.push_back(i % 2 == 0 ? -9.0 : 4.0);
    EXPECT_EQ(twoAlone.black().level, -9.0) << "one of two values is no padding";
    Values hot = between(-60.0, -1.0);
    hot.all[5] = 1e300;
    EXPECT_EQ(hot.black().level, -60.0);
    EXPECT_EQ(hot.scale().factor, 1.0);
}

/// A cube of 64 voxels an edge that holds `inside` of x/64 in a ball, and `outside` elsewhere.
Values paddedBall(double outside, const std::function<double(double)>& inside) {
    constexpr int edge = 64;
    Values values;
    for (int z = 0; z < edge; ++z)
        for (int y = 0; y < edge; ++y)
            for (int x = 0; x < edge; ++x)
                values.all.push_back(std::hypot(x - 31.5, y - 31.5, z - 31.5) < 31 ? inside(x / 64.0) : outside);
    return values;
}

/// The means of each voxel and its neighbours along all axes, `step` voxels apart.
Values neighbourMeans(const Values& values, int step) {
    constexpr int edge = 64;
    Values means;
    for (int z = 0; z < edge - 1; z += step)
        for (int y = 0; y < edge - 1; y += step)
            for (int x = 0; x < edge - 1; x += step) {
                double sum = 0.0;
                for (int corner = 0; corner < 8; ++corner) {
                    const int at = x + corner % 2 + edge * (y + corner / 2 % 2 + edge * (z + corner / 4));
                    sum += values.all[static_cast<std::size_t>(at)];
                }
                means.all.push_back(sum / 8);
            }
    return means;
}

TEST(BlackLevel, BordersBesidePaddingMoveNothing) {
    for (const double outside : {-32768.0, -1000.0, -2.0}) {
        const Values whole = paddedBall(outside, [](double x) { return 1 + 200 * x; });
        for (const Values& values : {whole, neighbourMeans(whole, 1), neighbourMeans(whole, 2)})
            EXPECT_EQ(values.black().level, 0.0) << outside << " " << values.all.size();
    }
    const auto decibels = [](double x) { return -60 * (1 - x); };
    const Values whole = paddedBall(-999.0, decibels);
    const double low = whole.black().level;
    EXPECT_NEAR(low, -60, 2);
    for (const Values& values : {neighbourMeans(whole, 1), neighbourMeans(whole, 2)}) {
        const BlackLevel black = values.black();
        EXPECT_NEAR(black.level, low, 9) << values.all.size();
        EXPECT_EQ(black.padding, -999.0);
    }
    const Values clipped = paddedBall(-60.0, decibels);
    EXPECT_EQ(clipped.black().level, -60.0) << "the outside is as low as the data begin";
    EXPECT_FALSE(clipped.black().padding);
}

TEST(ValueScale, IsZeroWithinTheRoundingOfFloats) {
    EXPECT_EQ((ValueScale{-60.000005349418, 1.0}).fileValue(60.0F), 0.0);
    EXPECT_EQ((ValueScale{-60.0, 1.0}).fileValue(59.9999), 59.9999 - 60.0);
    EXPECT_EQ((ValueScale{}).fileValue(1e-30), 1e-30);
}

TEST(ValueScale, GivesBackTheValuesWhateverTheirRange) {
    constexpr double least = std::numeric_limits<double>::denorm_min();
    for (const auto& [low, high] : {std::pair{0.0, 1e300},
                                    {0.0, 1e-300},
                                    {0.0, 1.7e308},
                                    {-1.7e308, 1.7e308},
                                    {-1.7e308, 0.0},
                                    {-1e-310, -1e-312},
                                    {0.0, 1000 * least},
                                    {-4.0, 4.0},
                                    {0.0, 255.0}}) {
        const Values values = between(low, high);
        const ValueScale scale = values.scale();
        EXPECT_TRUE(isSensible(scale));
        int exponent = 0;
        EXPECT_EQ(std::abs(std::frexp(scale.factor, &exponent)), 0.5) << "a power of two";
        const double white = scale.storedValue(high);
        EXPECT_TRUE(white >= 1.0 && white <= 1e3) << low << " " << high << " " << white;
        for (const double value : values.all) {
            const auto stored = static_cast<double>(static_cast<float>(scale.storedValue(value)));
            EXPECT_LE(std::abs(scale.fileValue(stored) / 2 - value / 2), 1e-7 * (high / 2 - low / 2) + least)
                << low << " " << high;
        }
    }
}

TEST(ValueScale, HoldsWholeNumbersFarFromAStatedBlack) {
    const Values values{{0.0, 1.0, 23.0}};
    for (const double black : {-1e308, -1.69e308, 1.69e308, -1e40, -1e30, 1e20, -0.5, 23.0}) {
        const ValueScale scale = scaleFrom(black, values.blocks(), true, values.extent());
        EXPECT_TRUE(isSensible(scale)) << black;
        const double reach = std::max(scale.storedValue(23.0), std::abs(black) / scale.factor);
        EXPECT_LE(reach, static_cast<double>(std::numeric_limits<float>::max())) << black;
        EXPECT_GT(reach, 0.0) << black;
    }
    EXPECT_EQ(scaleFrom(-1e30, values.blocks(), true, values.extent()).factor, 1.0);
}

TEST(ValueWindow, TurnsIntensitiesIntoValuesAndBack) {
    for (const ValueWindow& window : {ValueWindow{0.0, 255.0}, {-60.0, 0.0}, {-1e308, 1e308}, {1e6, 1e6 + 1}}) {
        EXPECT_EQ(window.valueAt(0.0), window.black);
        EXPECT_EQ(window.valueAt(1.0), window.white);
        EXPECT_NEAR(window.intensityOf(window.valueAt(0.42)), 0.42, 1e-9);
    }
    EXPECT_EQ((ValueWindow{-60.0, 0.0}).valueAt(0.79), std::lerp(-60.0, 0.0, 0.79));
    EXPECT_TRUE((ValueWindow{0.0, 1.0}).isNormalised());
}

TEST(BlackLevel, ADeclaredOneIsJudgedBesideTheValues) {
    const Values values = between(-100.0, -20.0);
    for (const double suits : {-100.0, -60.0, -30.0, -700.0})
        EXPECT_TRUE(suitsAsBlack(suits, values.black(), values.extent())) << suits;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double wrong : {-20.0, 5.0, -900.0, std::nan(""), -infinity})
        EXPECT_FALSE(suitsAsBlack(wrong, values.black(), values.extent())) << wrong;
}

}  // namespace
}  // namespace echolucent
