// The OTF of Kindlmann and Durkin on boundaries of known width.
#include "processing/designers/gradients/kindlmann.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

#include "processing/phantom/phantom.h"
#include "tests/processing/designers/designer_volumes.h"
#include "tests/processing/designers/gradients/blurred_steps.h"
#include "tests/processing/speckle_reduction/noisy_volumes.h"

namespace echolucent {
namespace {

bool isParabola(const Classification& classification) {
    return !classification.isTwoDimensional() && classification.curve() == OpacityCurve(PowerCurve{2, 1.0});
}

struct Boundary {
    const char* name;
    VolumeGeometry geometry;
    BoundaryDistance distance;
    double leastSigma = 1.0;         ///< units, that the grid resolves
    double positionTolerance = 0.2;  ///< of sigma; larger where few intensities are known
};

std::vector<Boundary> boundaries() {
    const VolumeGeometry cube = gridOf({52, 52, 52}), flat = gridOf({56, 56, 40}, {0.5, 0.5, 0.8});
    return {{"plane along an axis", cube, planeAcross({1, 0, 0})},
            {"oblique plane", cube, planeAcross({3, 2, 1})},
            {"diagonal plane", cube, planeAcross({1, 1, 1})},
            {"sphere", cube, sphereOf(14.0)},
            {"small sphere", cube, sphereOf(9.0)},
            {"oblique plane, flat voxels", flat, planeAcross({1.0, 0.6, 1.0})},
            {"plane across flat voxels", flat, planeAcross({0, 0, 1}), 1.5, 0.3},
            {"sphere, flat voxels", flat, sphereOf(14.0)}};
}

template <typename Voxel>
void expectItsWidth(const Boundary& boundary, double sigma) {
    const Volume volume = steppedVolume<Voxel>(boundary.geometry, {.sigma = sigma}, boundary.distance);
    const Design found = designed(KindlmannConfig{}, volume);
    EXPECT_NEAR(factOf(found, "sigma"), sigma, 0.1 * sigma) << boundary.name << ", " << volume.typeName();
    EXPECT_TRUE(found.message.empty()) << found.message;
}

TEST(Kindlmann, ABlurredStepGivesBackItsWidth) {
    for (const Boundary& boundary : boundaries())
        for (const double sigma : {1.0, 1.5, 2.0, 3.0, 4.0}) {
            // A ball must hold the step that is blurred.
            if (sigma < boundary.leastSigma || (sigma > 2.5 && std::string_view(boundary.name) == "small sphere"))
                continue;
            expectItsWidth<std::uint8_t>(boundary, sigma);
            expectItsWidth<float>(boundary, sigma);
        }
    expectItsWidth<std::uint16_t>(boundaries()[1], 2.0);
}

TEST(Kindlmann, AnyPrefilterGivesTheSameWidth) {
    const Volume volume = steppedVolume<float>(gridOf({52, 52, 52}), {.sigma = 2.0}, planeAcross({3, 2, 1}));
    for (const double prefilter : {0.0, 0.7, 1.5, 2.0, 3.0}) {
        KindlmannConfig config;
        config.prefilter = prefilter;
        const Design found = designed(config, volume);
        EXPECT_NEAR(factOf(found, "sigma"), 2.0, 0.1) << prefilter;
        EXPECT_NEAR(factOf(found, "smoothed_sigma"), std::hypot(2.0, prefilter), 0.1) << prefilter;
    }
}

TEST(Kindlmann, ThePositionIsThatInTheStep) {
    for (const Boundary& boundary : boundaries()) {
        const BlurredStep step{.sigma = 2.0};
        const Volume volume = steppedVolume<float>(boundary.geometry, step, boundary.distance);
        KindlmannConfig config;
        config.threshold = 0.0;
        for (const double prefilter : {0.0, 1.0}) {
            config.prefilter = prefilter;
            const Design found = designed(config, volume);
            const DesignPlot& plot = plotOf(found, "position");
            for (std::size_t i = 0; i < plot.intensities.size(); ++i) {
                const double share = (plot.intensities[i] - step.low) / (step.high - step.low);
                if (share < 0.1 || share > 0.9) continue;
                EXPECT_NEAR(plot.values[i] * factOf(found, "sigma"), step.positionOf(plot.intensities[i]),
                            boundary.positionTolerance * step.sigma)
                    << boundary.name << ", prefilter " << prefilter << ", intensity " << plot.intensities[i];
            }
        }
    }
}

TEST(Kindlmann, OpacityPeaksInTheMiddleOfTheStep) {
    for (const double sigma : {1.0, 2.0, 4.0}) {
        const BlurredStep step{.sigma = sigma};
        const Volume volume = steppedVolume<std::uint8_t>(gridOf({52, 52, 52}), step, planeAcross({3, 2, 1}));
        const Design found = designed(KindlmannConfig{}, volume);
        const auto& opacities = std::get<SampledCurve>(found.classification.curve()).opacities;
        ASSERT_EQ(opacities.size(), 256U);
        const auto peak = std::ranges::max_element(opacities) - opacities.begin();
        EXPECT_NEAR(static_cast<double>(peak), 255.0 * 0.5 * (step.low + step.high), 4.0) << sigma;
        EXPECT_GT(opacities[static_cast<std::size_t>(peak)], 0.9);
        // It rises up to its peak and falls from there, and both sides of the step stay clear.
        EXPECT_TRUE(std::is_sorted(opacities.begin(), opacities.begin() + peak + 1));
        EXPECT_TRUE(std::is_sorted(opacities.begin() + peak, opacities.end(), std::greater<>()));
        for (const double share : {0.0, 0.1, 0.9, 1.0})
            EXPECT_EQ(opacityAt(found.classification, step.low + share * (step.high - step.low), 0.0), 0.0) << share;
    }
}

TEST(Kindlmann, WithTwoDimensionsVoxelsWithoutTheBoundarysGradientStayClear) {
    const BlurredStep step{.sigma = 2.0};
    const Volume volume = steppedVolume<std::uint8_t>(gridOf({52, 52, 52}), step, planeAcross({3, 2, 1}));
    KindlmannConfig config;
    config.dimensions = KindlmannDimensions::two;
    const Design found = designed(config, volume);
    ASSERT_TRUE(found.classification.isTwoDimensional());
    const TwoDimensionalOtf& otf = *found.classification.twoDimensional();
    EXPECT_EQ(otf.intensities, 256);
    EXPECT_EQ(otf.gradients, 64);
    const auto slopeAt = [&](double units) {
        return (step.high - step.low) / (2.0 * std::sqrt(2.0 * std::numbers::pi)) * std::exp(-units * units / 8.0);
    };
    EXPECT_GT(opacityAt(otf, step.at(0.0), slopeAt(0.0)), 0.8);
    for (const double gradient : {0.0, 0.3 * slopeAt(0.0)}) EXPECT_EQ(opacityAt(otf, step.at(0.0), gradient), 0.0);
    EXPECT_EQ(opacityAt(otf, step.low, 0.0), 0.0);
    EXPECT_EQ(opacityAt(otf, step.high, 0.0), 0.0);
    EXPECT_GT(opacityAt(otf, step.at(1.0), slopeAt(1.0)), 0.2) << "half a sigma from the middle";
    EXPECT_LT(opacityAt(otf, step.at(2.0), slopeAt(2.0)), 0.1) << "one sigma from the middle";
}

TEST(Kindlmann, NeitherTheEndOfTheDataNorWhatIsStoredBeyondItIsABoundary) {
    const VolumeGeometry geometry = gridOf({52, 52, 52});
    const BlurredStep step{.sigma = 2.0};
    const BoundaryDistance plane = planeAcross({3, 2, 1});
    const auto isData = [](const Vec3& place) { return place[1] + 0.5 * place[2] < 9.0; };
    const Volume stored = volumeOf<std::uint8_t>(
        geometry, [&](const Vec3& place) { return isData(place) ? step.at(plane(place)) : 1.0; });
    const Volume masked = stored.withDataMask(maskWithout(geometry, [&](auto x, auto y, auto z) {
        return !isData(Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)) -
                       Vec3(25.5, 25.5, 25.5));
    }));
    const Design found = designed(KindlmannConfig{}, masked);
    EXPECT_NEAR(factOf(found, "sigma"), 2.0, 0.2);
    EXPECT_LT(factOf(found, "voxels_used"), 1.0);
    EXPECT_EQ(opacityAt(found.classification, 0.95, 0.0), 0.0);
    // The same as floats, where no data is no number.
    const Volume floats = volumeOf<float>(geometry, [&](const Vec3& place) {
        return isData(place) ? step.at(plane(place)) : std::numeric_limits<double>::quiet_NaN();
    });
    EXPECT_NEAR(factOf(designed(KindlmannConfig{}, floats), "sigma"), factOf(found, "sigma"), 0.05);
}

TEST(Kindlmann, TheEmphasisMayBeMovedScaledAndDrawn) {
    KindlmannConfig config;
    EXPECT_EQ(emphasisAt(config, 0.0), 1.0);
    EXPECT_EQ(emphasisAt(config, -0.25), 0.75);
    EXPECT_EQ(emphasisAt(config, 1.5), 0.0);
    config.centre = 0.5;
    config.halfWidth = 2.0;
    config.peak = 0.6;
    EXPECT_DOUBLE_EQ(emphasisAt(config, 0.5), 0.6);
    EXPECT_DOUBLE_EQ(emphasisAt(config, -0.5), 0.3);
    config.emphasis = BoundaryEmphasis::drawn;
    for (const double position : {-2.0, -0.75, 0.0, 0.5, 3.0})
        EXPECT_DOUBLE_EQ(emphasisAt(config, position), emphasisAt({}, position)) << "the default drawing is the hat";
    config.drawn = {{-2.0, 0.2}, {0.0, 0.4}, {0.0, 1.0}, {1.0, 0.5}};
    EXPECT_DOUBLE_EQ(emphasisAt(config, -5.0), 0.2);
    EXPECT_DOUBLE_EQ(emphasisAt(config, -1.0), 0.3);
    EXPECT_DOUBLE_EQ(emphasisAt(config, 0.0), 1.0);
    EXPECT_DOUBLE_EQ(emphasisAt(config, 0.5), 0.75);
    EXPECT_DOUBLE_EQ(emphasisAt(config, 9.0), 0.5);

    // Only the brighter side of a step is shown.
    const BlurredStep step{.sigma = 2.0};
    const Volume volume = steppedVolume<float>(gridOf({52, 52, 52}), step, planeAcross({3, 2, 1}));
    config.drawn = {{0.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}, {1.0, 0.0}};
    config.threshold = 0.0;
    const Design found = designed(config, volume);
    EXPECT_EQ(opacityAt(found.classification, step.at(-0.5), 0.0), 0.0);
    EXPECT_EQ(opacityAt(found.classification, step.at(1.0), 0.0), 1.0);
    EXPECT_EQ(opacityAt(found.classification, step.at(3.0), 0.0), 0.0);
}

TEST(Kindlmann, ItsTableHoldsEveryNumberAndTheHatAloneWhereNothingIsDrawn) {
    KindlmannConfig config;
    const auto table = parametersOf(config);
    for (const Parameter<KindlmannConfig>& row : table) {
        const ParameterValue value = defaultOf(table, row);
        EXPECT_TRUE(row.set(config, value)) << row.name;
        EXPECT_EQ(row.get(config), value) << row.name;
        EXPECT_TRUE(inRange(numberOf(value).value_or(row.range.least), row.range)) << row.name;
    }
    EXPECT_EQ(config, KindlmannConfig{});
    ASSERT_TRUE(parameterNamed(table, "emphasis")->set(config, std::string("drawn")));
    EXPECT_FALSE(parameterNamed(table, "peak")->get(config));
    EXPECT_FALSE(parameterNamed(table, "peak")->set(config, 0.5));
    EXPECT_EQ(config.peak, 1.0);
    EXPECT_FALSE(parameterNamed(table, "emphasis")->set(config, std::string("round")));
    EXPECT_TRUE(parameterNamed(table, "dimensions")->set(config, std::string("two")));
    EXPECT_EQ(config.dimensions, KindlmannDimensions::two);
}

TEST(Kindlmann, AConfigThatMakesNoSenseIsRefused) {
    const Volume volume = steppedVolume<float>(gridOf({12, 12, 12}), {}, planeAcross({1, 0, 0}));
    const auto problem = [&](const KindlmannConfig& config) -> std::string {
        try {
            (void)design(config, DesignerInput{volume, volume});
        } catch (const std::invalid_argument& thrown) {
            EXPECT_EQ("KindlmannConfig: " + problemIn(parametersOf(config), config), thrown.what());
            return problemIn(parametersOf(config), config);
        }
        return "";
    };
    EXPECT_EQ(problem({.prefilter = -1.0}), "the prefilter must be 0 to 8");
    EXPECT_EQ(problem({.threshold = std::nan("")}), "the gradient threshold must be 0 to 0.9");
    EXPECT_EQ(problem({.halfWidth = 0.0}), "the half-width of the hat must be 0.05 to 8");
    EXPECT_EQ(problem({.drawn = {}}), "the drawn emphasis must have 2 to 64 nodes");
    EXPECT_EQ(problem({.drawn = {{1, 0}, {0, 1}}}), "the positions of the drawn emphasis must not descend");
    EXPECT_EQ(problem({.drawn = {{-9, 0}, {0, 1}}}), "the positions of the drawn emphasis must be -8 to 8");
    EXPECT_EQ(problem({.drawn = {{0, 0}, {1, 1.5}}}), "the opacities of the drawn emphasis must be 0 to 1");
    EXPECT_EQ(problem({}), "");
    const Volume other = steppedVolume<float>(gridOf({12, 12, 11}), {}, planeAcross({1, 0, 0}));
    EXPECT_THROW((void)design(KindlmannConfig{}, DesignerInput{volume, other}), std::invalid_argument);
}

TEST(Kindlmann, ReadsTheVoxelsThatAreShown) {
    const VolumeGeometry geometry = gridOf({52, 52, 52});
    const Volume shown = steppedVolume<float>(geometry, {.sigma = 2.0}, planeAcross({3, 2, 1}));
    const Volume raw = volumeOf<float>(geometry, [](const Vec3&) { return 0.5; });
    EXPECT_NEAR(factOf(*design(KindlmannConfig{}, DesignerInput{raw, shown}), "sigma"), 2.0, 0.2);
}

TEST(Kindlmann, WithoutABoundaryAMessageSaysSo) {
    const VolumeGeometry cube = gridOf({24, 24, 24});
    const Volume constant = volumeOf<std::uint8_t>(cube, [](const Vec3&) { return 0.4; });
    const Volume zero = volumeOf<std::uint16_t>(cube, [](const Vec3&) { return 0.0; });
    const Volume even = volumeOf<float>(cube, [](const Vec3& place) { return 0.5 + 0.01 * place[0]; });
    const Volume noData = constant.withDataMask(std::vector<std::uint8_t>(24 * 24 * 24, 0));
    const Volume one = volumeOf<std::uint8_t>(gridOf({1, 1, 1}), [](const Vec3&) { return 0.4; });
    const Volume nan = volumeOf<float>(cube, [](const Vec3&) { return std::numeric_limits<double>::quiet_NaN(); });
    for (const Volume* volume : {&constant, &zero, &even, &noData, &one, &nan})
        for (const KindlmannDimensions dimensions : {KindlmannDimensions::one, KindlmannDimensions::two}) {
            KindlmannConfig config;
            config.dimensions = dimensions;
            const Design found = designed(config, *volume);
            EXPECT_EQ(found.message, "No boundary was found in this volume; the parabola x² is shown in its place.");
            EXPECT_TRUE(isParabola(found.classification));
            EXPECT_TRUE(found.explanation.empty()) << "the message says all";
            for (const DesignFact& fact : found.facts) EXPECT_TRUE(std::isfinite(fact.value)) << fact.name;
        }
}

TEST(Kindlmann, WhereTheEmphasisLeavesNothingAMessageSaysSo) {
    const Volume volume = steppedVolume<float>(gridOf({40, 40, 40}), {}, planeAcross({3, 2, 1}));
    for (const KindlmannDimensions dimensions : {KindlmannDimensions::one, KindlmannDimensions::two}) {
        KindlmannConfig config;
        config.dimensions = dimensions;
        config.peak = 0.0;
        const Design found = designed(config, volume);
        EXPECT_TRUE(isParabola(found.classification));
        EXPECT_NE(found.message.find("emphasised"), std::string::npos) << found.message;
    }
}

PhantomConfig smallScan(PhantomScene scene) {
    PhantomConfig config = defaultPhantom(scene);
    config.size = {80, 79, 80};
    config.spacing = {1.25, 1.25, 1.25};
    return config;
}

TEST(Kindlmann, SpeckleWithoutABoundaryIsToldFromOne) {
    const Volume tissue = *makePhantom(smallScan(PhantomScene::empty));
    const Volume quiet = *quietVolume(tissue, SpeckleReduction::medium);
    for (const Volume* volume : {&tissue, &quiet}) {
        const Design found = *design(KindlmannConfig{}, DesignerInput{tissue, *volume});
        EXPECT_TRUE(isParabola(found.classification));
        EXPECT_NE(found.message.find("speckle"), std::string::npos) << found.message;
        EXPECT_LT(factOf(found, "smoothed_sigma"), 0.85);
    }
}

TEST(Kindlmann, ASpeckledScanGivesAWidthAndLeavesFluidAndTissueClear) {
    // Ramps of four units are as wide as a Gaussian of 1.15.
    for (const PhantomScene scene : {PhantomScene::shapes, PhantomScene::fetus}) {
        const PhantomConfig config = smallScan(scene);
        const Volume scan = *makePhantom(config), quiet = *quietVolume(scan, SpeckleReduction::medium);
        for (const KindlmannDimensions dimensions : {KindlmannDimensions::one, KindlmannDimensions::two}) {
            KindlmannConfig kindlmann;
            kindlmann.dimensions = dimensions;
            const Design found = *design(kindlmann, DesignerInput{scan, quiet});
            EXPECT_TRUE(found.message.empty()) << found.message;
            EXPECT_GT(factOf(found, "sigma"), 0.6);
            EXPECT_LT(factOf(found, "sigma"), 2.2);
            EXPECT_LT(opacityAt(found.classification, config.fluid / 255.0, 0.0), 0.01);
            EXPECT_LT(opacityAt(found.classification, config.tissue / 255.0, 0.0), 0.15);
            const double between = 0.5 * (config.fluid + config.tissue) / 255.0;
            EXPECT_GT(opacityAt(found.classification, between, 0.1), 0.4);
        }
    }
}

TEST(Kindlmann, HasTheSameBitsForAnyNumberOfThreads) {
    const Volume scan = *makePhantom(smallScan(PhantomScene::shapes));
    for (const KindlmannDimensions dimensions : {KindlmannDimensions::one, KindlmannDimensions::two}) {
        KindlmannConfig config;
        config.dimensions = dimensions;
        config.prefilter = 2.0;
        std::vector<Design> results;
        for (const std::size_t threads : {1, 2, 5}) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            results.push_back(designed(config, scan));
        }
        for (const Design& other : results) {
            EXPECT_EQ(other.classification, results[0].classification);
            EXPECT_EQ(other.facts, results[0].facts);
            EXPECT_EQ(other.explanation, results[0].explanation);
        }
        EXPECT_EQ(results[0].classification.isTwoDimensional(), dimensions == KindlmannDimensions::two);
    }
}

TEST(Kindlmann, IsCancelledBeforeAndWhileItRuns) {
    const Volume volume = steppedVolume<std::uint8_t>(gridOf({40, 40, 40}), {}, planeAcross({3, 2, 1}));
    for (const KindlmannDimensions dimensions : {KindlmannDimensions::one, KindlmannDimensions::two}) {
        KindlmannConfig config;
        config.dimensions = dimensions;
        const std::atomic<bool> raised = true;
        EXPECT_FALSE(design(config, DesignerInput{volume, volume}, {{}, &raised}));
    }
    // A volume of several slabs is left after the first one.
    const Volume large = volumeOf<std::uint8_t>(gridOf({520, 510, 20}),
                                                [](const Vec3& place) { return 0.5 + 0.4 * std::sin(0.2 * place[0]); });
    std::atomic<bool> cancel = false;
    std::vector<double> shares;
    const Progress progress{[&](double share) {
                                shares.push_back(share);
                                cancel = true;
                            },
                            &cancel};
    EXPECT_FALSE(design(KindlmannConfig{}, DesignerInput{large, large}, progress));
    ASSERT_EQ(shares.size(), 1U);
    EXPECT_LT(shares[0], 1.0);
}

}  // namespace
}  // namespace echolucent
