// Detection by ratio on profiles that know their boundaries, and on volumes that have none.
#include "processing/detection/ratio_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/phantom/phantom.h"
#include "profile_samples.h"

namespace echolucent {
namespace {

constexpr double fluidIntensity = 0.06, tissueIntensity = 0.4;
constexpr int profileLength = 120;

/// There are `profileLength` slabs, of which the first `boundary` are fluid.
std::vector<double> stepAt(int boundary, double before = fluidIntensity, double behind = tissueIntensity) {
    std::vector<double> levels(profileLength, behind);
    std::fill(levels.begin(), levels.begin() + boundary, before);
    return levels;
}

/// The ramp is linear in intensity over `width` slabs around the boundary.
std::vector<double> rampAround(double boundary, double width) {
    std::vector<double> levels;
    for (int k = 0; k < profileLength; ++k)
        levels.push_back(fluidIntensity +
                         (tissueIntensity - fluidIntensity) * std::clamp((k + 0.5 - boundary) / width + 0.5, 0.0, 1.0));
    return levels;
}

/// A view of tube cores, judged together.
struct Judged {
    TubeProfiles profiles;
    SpeckleScale scale{profiles};
    RatioRule rule;
    TubeContrasts contrasts{profiles, scale, rule};
    RatioThresholds thresholds = ratioThresholds(contrasts, scale, rule);

    explicit Judged(const std::vector<MadeProfile>& made) : profiles(profilesOf(made)) {}
    [[nodiscard]] std::optional<RatioSurface> surface(std::size_t tube) const {
        return firstFluidToTissue(profiles.means(tube), contrasts.scaled(tube), contrasts.contrasts(tube), thresholds,
                                  rule, madeCellSize);
    }
    /// Where the surface was found, slabs from the tube's first: the middle of its cell.
    [[nodiscard]] std::optional<double> place(std::size_t tube) const {
        const auto found = surface(tube);
        if (!found) return std::nullopt;
        return found->cell + madeCellSize / 2.0;
    }
};

/// 225 tube cores with a step each; the tubes under test come first.
std::vector<MadeProfile> amongSteps(SpeckledSlabs& slabs, std::vector<std::vector<double>> tested) {
    while (tested.size() < 225) tested.push_back(stepAt(slabs.drawn(20, 100)));
    std::vector<MadeProfile> made;
    for (const auto& levels : tested) made.push_back(slabs.around(levels));
    return made;
}

TEST(RatioContrasts, AreWhatASlowLoopGivesToTheEnds) {
    SpeckledSlabs slabs(1);
    for (const RatioRule& rule : {RatioRule{}, RatioRule{.slabsBefore = 14, .slabsBehind = 5, .leastFluid = 3},
                                  RatioRule{.slabsBefore = 4, .slabsBehind = 9, .leastFluid = 4}}) {
        const int least = (rule.slabsBehind + 1) / 2;
        for (const int size : {0, 1, 7, 8, 10, 11, 12, 13, 15, 16, 17, 25, 200}) {
            std::vector<float> scaled;
            for (int k = 0; k < size; ++k) scaled.push_back(static_cast<float>(slabs.drawn(0.0, 30.0)));
            const std::size_t count = contrastCount(scaled.size(), rule);
            ASSERT_EQ(static_cast<int>(count), std::max(0, size - least - rule.leastFluid + 1)) << size;
            std::vector<float> contrasts(count, 99.0f);
            contrastsAlong(scaled, rule, contrasts);
            for (int boundary = rule.leastFluid; boundary <= size - least; ++boundary) {
                double before = 0.0, behind = 0.0;
                int countBefore = 0, countBehind = 0;
                for (int k = std::max(0, boundary - rule.slabsBefore); k < boundary; ++k, ++countBefore)
                    before += static_cast<double>(scaled[static_cast<std::size_t>(k)]);
                for (int k = boundary; k < std::min(size, boundary + rule.slabsBehind); ++k, ++countBehind)
                    behind += static_cast<double>(scaled[static_cast<std::size_t>(k)]);
                // The bound is single precision of differences of up to 30.
                EXPECT_NEAR(contrasts[static_cast<std::size_t>(boundary - rule.leastFluid)],
                            behind / countBehind - before / countBefore, 4e-6)
                    << size << " " << boundary;
            }
        }
    }
}

TEST(RatioContrasts, OfAConstantAreZero) {
    std::vector<float> contrasts(contrastCount(90, {}), 99.0f);
    ASSERT_FALSE(contrasts.empty());
    contrastsAlong(std::vector<float>(90, 7.3f), {}, contrasts);
    for (const float contrast : contrasts) EXPECT_NEAR(contrast, 0.0f, 1e-12f);
}

TEST(RatioContrasts, OfAllTubesAreThoseOfEach) {
    SpeckledSlabs slabs(8);
    // The profiles are of all lengths, and one of them is empty.
    std::vector<MadeProfile> made(4);
    for (const std::size_t size : {3u, 10u, 11u, 12u, 40u, 119u, 0u, 77u})
        made.push_back(slabs.around(std::vector<double>(size, 0.3)));
    const TubeProfiles profiles = profilesOf(made);
    const SpeckleScale scale(profiles);
    const TubeContrasts tubes(profiles, scale, {});
    ASSERT_EQ(tubes.tubes(), made.size());
    for (std::size_t t = 0; t < made.size(); ++t) {
        ASSERT_EQ(tubes.scaled(t).size(), made[t].means.size());
        for (std::size_t k = 0; k < made[t].means.size(); ++k)
            EXPECT_FLOAT_EQ(tubes.scaled(t)[k], static_cast<float>(scale.scaled(profiles.means(t)[k])));
        std::vector<float> contrasts(contrastCount(made[t].means.size(), {}));
        contrastsAlong(tubes.scaled(t), {}, contrasts);
        EXPECT_EQ(std::vector<float>(tubes.contrasts(t).begin(), tubes.contrasts(t).end()), contrasts);
    }
}

TEST(RatioContrasts, DoNotDependOnTheGain) {
    SpeckledSlabs slabs(2);
    std::vector<MadeProfile> made;
    for (int t = 0; t < 225; ++t) {
        std::vector<double> levels;
        for (int k = 0; k < profileLength; ++k) levels.push_back(slabs.drawn(0.08, 0.4));
        made.push_back(slabs.around(levels));
    }
    const auto contrastsAtGain = [&](double gain) {
        auto amplified = made;
        for (MadeProfile& profile : amplified)
            for (std::size_t k = 0; k < profile.means.size(); ++k) {
                profile.means[k] *= gain;
                profile.spreads[k] *= gain;
            }
        const TubeProfiles profiles = profilesOf(amplified);
        const TubeContrasts tubes(profiles, SpeckleScale(profiles), {});
        std::vector<float> all;
        for (std::size_t t = 0; t < 20; ++t)
            all.insert(all.end(), tubes.contrasts(t).begin(), tubes.contrasts(t).end());
        return all;
    };
    const auto once = contrastsAtGain(1.0);
    for (const double gain : {0.6, 2.0}) {
        const auto amplified = contrastsAtGain(gain);
        double largest = 0.0, differing = 0.0;
        for (std::size_t i = 0; i < once.size(); ++i) {
            largest = std::max<double>(largest, std::abs(once[i]));
            differing = std::max<double>(differing, std::abs(amplified[i] - once[i]));
        }
        std::printf("gain %.1f: contrasts up to %.3f differ by at most %.4f\n", gain, largest, differing);
        EXPECT_LE(differing, 0.03 * largest);
    }
}

TEST(RatioSurface, FindsAStepWhereItIs) {
    SpeckledSlabs slabs(3);
    std::vector<int> boundaries;
    std::vector<std::vector<double>> tested;
    for (int t = 0; t < 225; ++t) {
        boundaries.push_back(slabs.drawn(10, profileLength - 8));
        tested.push_back(stepAt(boundaries.back()));
    }
    const Judged judged(amongSteps(slabs, tested));
    ASSERT_TRUE(judged.thresholds.mayHoldSurfaces);
    // The place halfway between both levels on a logarithm is the geometric mean.
    EXPECT_NEAR(judged.scale.intensityAt(judged.thresholds.fluidLevel), std::sqrt(fluidIntensity * tissueIntensity),
                0.03);
    for (std::size_t t = 0; t < tested.size(); ++t) {
        const auto place = judged.place(t);
        ASSERT_TRUE(place) << t;
        EXPECT_NEAR(*place, boundaries[t], 1.0) << t;
        EXPECT_NEAR(judged.surface(t)->contrast, std::log(tissueIntensity / fluidIntensity) / 0.25, 1.2) << t;
    }
}

TEST(RatioSurface, FindsTheMiddleOfAWideRamp) {
    SpeckledSlabs slabs(4, 0.25, 0.03);
    std::vector<std::vector<double>> tested;
    std::vector<double> middles;
    for (const double width : {2.0, 4.0, 8.0, 10.0})
        for (double middle = 30; middle < 33; middle += 0.25) {
            middles.push_back(middle);
            tested.push_back(rampAround(middle, width));
        }
    const Judged judged(amongSteps(slabs, tested));
    for (std::size_t t = 0; t < middles.size(); ++t) {
        const auto place = judged.place(t);
        ASSERT_TRUE(place) << t;
        EXPECT_NEAR(*place, middles[t], 1.0) << t;
    }
}

TEST(RatioSurface, TakesTheFirstOfTwoSurfaces) {
    SpeckledSlabs slabs(5);
    std::vector<double> levels = stepAt(30);
    std::fill(levels.begin() + 45, levels.begin() + 80, fluidIntensity);
    std::fill(levels.begin() + 80, levels.end(), 2 * tissueIntensity);
    const Judged judged(amongSteps(slabs, {levels}));
    ASSERT_TRUE(judged.place(0));
    EXPECT_NEAR(*judged.place(0), 30, 1.0);
}

TEST(RatioSurface, TissueBeforeBrighterTissueIsNoSurface) {
    SpeckledSlabs slabs(6);
    const auto bright = stepAt(60, 0.3, 0.9);
    auto behindFluid = stepAt(70, 0.3, 0.9);
    std::fill(behindFluid.begin(), behindFluid.begin() + 30, fluidIntensity);
    const Judged judged(
        amongSteps(slabs, {bright, bright, bright, behindFluid, stepAt(60, tissueIntensity, fluidIntensity)}));
    for (const std::size_t t : {0u, 1u, 2u}) EXPECT_FALSE(judged.surface(t)) << t;
    ASSERT_TRUE(judged.place(3));
    EXPECT_NEAR(*judged.place(3), 30, 1.0) << "the brighter tissue behind is stronger by accident at most";
    EXPECT_FALSE(judged.surface(4)) << "from tissue to fluid";
}

TEST(RatioSurface, AGapOfLittleFluidIsNoSurface) {
    // The mean of the slabs before must be fluid: a gap of under half of them amid tissue, or of under half of
    // leastFluid at the tube's beginning, is none; leastFluid and a ramp's width are one for sure.
    SpeckledSlabs slabs(7);
    const auto gapOf = [](int width) {
        auto levels = stepAt(0);
        std::fill(levels.begin() + 50 - width, levels.begin() + 50, fluidIntensity);
        return levels;
    };
    const Judged judged(amongSteps(slabs, {gapOf(1), gapOf(2), gapOf(3), gapOf(4), stepAt(1), stepAt(2), stepAt(3),
                                           gapOf(8), gapOf(10), gapOf(30), stepAt(8), stepAt(12)}));
    for (std::size_t t = 0; t < 7; ++t) EXPECT_FALSE(judged.surface(t)) << t;
    for (std::size_t t = 7; t < 10; ++t) {
        ASSERT_TRUE(judged.place(t)) << t;
        EXPECT_NEAR(*judged.place(t), 50, 1.0) << t;
    }
    ASSERT_TRUE(judged.place(10));
    EXPECT_NEAR(*judged.place(10), 8, 1.0);
    ASSERT_TRUE(judged.place(11));
    EXPECT_NEAR(*judged.place(11), 12, 1.0);
}

TEST(RatioSurface, FindsNothingInPureSpeckle) {
    for (std::uint32_t seed = 1; seed <= 100; ++seed) {
        SpeckledSlabs slabs(seed, 0.3, 0.1);
        std::vector<MadeProfile> made;
        for (int t = 0; t < 225; ++t) {
            // Gain changes slowly along and across.
            const double phase = slabs.drawn(0.0, 6.3);
            std::vector<double> levels;
            for (int k = 0; k < profileLength; ++k) levels.push_back(0.33 * (1 + 0.15 * std::sin(phase + k / 40.0)));
            made.push_back(slabs.around(levels));
        }
        const Judged judged(made);
        EXPECT_FALSE(judged.thresholds.mayHoldSurfaces) << seed;
        for (std::size_t t = 0; t < made.size(); ++t) ASSERT_FALSE(judged.surface(t)) << seed;
    }
}

/// Tissue without fluid, in the kinds of speckle of docs/experiments.md, "The conditions".
std::vector<NamedPhantom> emptyPhantoms(PhantomConfig base) {
    base.scene = PhantomScene::empty;
    PhantomConfig full = base, uncorrelated = base, compressed = base;
    full.speckle = 1;
    uncorrelated.speckle = 1;
    uncorrelated.speckleSize = 0;
    compressed.speckle = 1;
    compressed.logCompressDecibel = 50;
    return {{"base", base}, {"full", full}, {"uncorrelated", uncorrelated}, {"log-compressed", compressed}};
}

void expectNothingFound(const PhantomConfig& config, const Viewpoint& view, const std::string& what) {
    const AdaptiveOtf otf = *adaptOpacity(*makePhantom(config), view, {});
    EXPECT_EQ(otf.tubesWithWeight, 0) << what;
    EXPECT_EQ(otf.message, "No surface found: the initial function is used.") << what;
    EXPECT_EQ(otf.trust, 0.0) << what;
    EXPECT_FALSE(otf.fluidIntensity) << what;
    for (const TubeCore& tube : otf.tubes) ASSERT_EQ(tube.d, 0.0) << what;
    for (int i = 0; i < AdaptiveOtf::sampleCount; ++i) {
        const double x = static_cast<double>(i) / (AdaptiveOtf::sampleCount - 1);
        // The curve is the initial function in its own logarithm, without a mixture with anything.
        ASSERT_EQ(otf.logOpacity[static_cast<std::size_t>(i)], logOpacityAt(otf.config.initial, x)) << what;
        ASSERT_NEAR(otf.curve.opacities[static_cast<std::size_t>(i)], opacityAt(otf.config.initial, x), 4e-16) << what;
    }
}

TEST(LongRatioSurface, InventsNoSurfaceInVolumesWithoutFluid) {
    struct Run {
        std::int64_t edge;
        int seeds;
    };
    for (const Run& run : {Run{64, 10}, Run{96, 3}, Run{128, 2}})
        for (int seed = 1; seed <= run.seeds; ++seed) {
            PhantomConfig base;
            base.size = {run.edge, run.edge, run.edge};
            base.seed = static_cast<std::uint64_t>(100 * run.edge + seed);
            for (const NamedPhantom& phantom : emptyPhantoms(base)) {
                const std::string what = phantom.name + " " + std::to_string(run.edge) + " " + std::to_string(seed);
                expectNothingFound(
                    phantom.config,
                    seed % 2 == 0 ? Viewpoint{.azimuthDegrees = 17, .elevationDegrees = -9} : Viewpoint{}, what);
            }
        }
}

}  // namespace
}  // namespace echolucent
