// The designer that carries a curve from one volume to another.
#include "processing/designers/template/template_curve.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "processing/phantom/phantom.h"
#include "processing/speckle_reduction/speckle_reduction.h"
#include "tests/inputs.h"
#include "tests/processing/designers/designer_volumes.h"

namespace echolucent {
namespace {

using Mapping = std::function<double(double)>;

const Volume& quietFetus() {
    static const Volume volume = *quietVolume(*makePhantom(fetusTemplateConfig()), defaultSpeckleReduction);
    return volume;
}

/// The same bytes with other intensities, as another gain would store them.
Volume mapped(const Volume& volume, const Mapping& mapping) {
    std::vector<std::uint8_t> bytes;
    for (std::int64_t i = 0; i < volume.geometry().voxelCount(); ++i)
        bytes.push_back(static_cast<std::uint8_t>(
            std::lround(255.0 * std::clamp(mapping(volume.normalisedIntensity(i)), 0.0, 1.0))));
    return {volume.geometry(), std::move(bytes)};
}

/// The slices [first, last).
Volume slices(const Volume& volume, std::int64_t first, std::int64_t last) {
    VolumeGeometry geometry = volume.geometry();
    geometry.size[2] = last - first;
    const auto& bytes = std::get<VoxelArray<std::uint8_t>>(volume.voxels());
    return {geometry, std::vector<std::uint8_t>(bytes.begin() + volume.geometry().offset(0, 0, first),
                                                bytes.begin() + volume.geometry().offset(0, 0, last))};
}

struct Known {
    std::string name;
    Mapping mapping;
};

std::vector<Known> knownMappings() {
    std::vector<Known> all;
    for (const double gamma : {0.6, 0.8, 1.25, 1.6})
        all.push_back({"gamma " + std::to_string(gamma), [gamma](double x) { return std::pow(x, gamma); }});
    for (const int shift : {-20, 20, 60})
        all.push_back({"shift " + std::to_string(shift), [shift](double x) { return x + shift / 255.0; }});
    for (const double gain : {0.4, 1.8})
        all.push_back({"gain " + std::to_string(gain), [gain](double x) { return gain * x; }});
    all.push_back({"all", [](double x) { return 0.8 * std::pow(x, 0.7) + 15.0 / 255.0; }});
    return all;
}

/// Intensities of which there are fewer voxels than a thousandth say nothing and are skipped.
TEST(TemplateCurve, AKnownGammaShiftOrGainIsFoundWithinTwoLevels) {
    const std::vector<double>& shares = fetusTemplate()->histogram;
    for (const TemplateComparison comparison : allTemplateComparisons)
        for (const Known& known : knownMappings()) {
            if (takesSomeInputs && known.name != "all") continue;
            TemplateConfig config;
            config.comparison = comparison;
            const Design found = designed(config, mapped(quietFetus(), known.mapping));
            const DesignPlot& warp = plotOf(found, "warp");
            int compared = 0;
            for (std::size_t level = 0; level < 256; ++level) {
                const double expected = 255.0 * known.mapping(static_cast<double>(level) / 255.0);
                if (shares[level] < 1e-3 || expected < 0.5 || expected > 254.5) continue;
                EXPECT_NEAR(255.0 * warp.values[level], expected, 2.0)
                    << nameOf(comparison) << ", " << known.name << ", level " << level;
                ++compared;
            }
            EXPECT_GT(compared, 100) << known.name;
        }
}

TEST(TemplateCurve, TheCurveFollowsTheVoxels) {
    const Mapping gamma = [](double x) { return std::pow(x, 0.7); };
    const OpacityCurve carried = designed(TemplateConfig{}, mapped(quietFetus(), gamma)).classification.curve();
    const OpacityCurve& reference = fetusTemplate()->curve;
    for (std::size_t level = 0; level < 256; ++level) {
        if (fetusTemplate()->histogram[level] < 1e-3) continue;
        const double intensity = static_cast<double>(level) / 255.0;
        EXPECT_NEAR(opacityAt(carried, gamma(intensity)), opacityAt(reference, intensity), 0.02) << level;
    }
}

TEST(TemplateCurve, TheReferenceItselfKeepsItsCurve) {
    const Design found = designed(TemplateConfig{}, quietFetus());
    EXPECT_TRUE(found.message.empty());
    EXPECT_LT(std::abs(factOf(found, "largest_shift")), 1.5 / 255.0);
    EXPECT_NEAR(factOf(found, "mean_slope"), 1.0, 0.01);
    for (int i = 0; i < 256; ++i)
        EXPECT_NEAR(opacityAt(found.classification.curve(), i / 255.0), opacityAt(fetusTemplate()->curve, i / 255.0),
                    0.01);
    // A reference that is made of the volume is the same to the bit.
    TemplateConfig own;
    own.reference = templateFrom(quietFetus(), LinearCurve{}, "own");
    const Design same = designed(own, quietFetus());
    EXPECT_EQ(factOf(same, "distance"), 0.0);
    EXPECT_EQ(factOf(same, "largest_shift"), 0.0);
}

/// The far half of the scene holds far less fluid: the default finds fluid and tissue where they were all the same.
TEST(TemplateCurve, ByLogarithmsAPartOfTheSceneIsEnough) {
    const Volume part = slices(quietFetus(), 64, 128);
    const auto shiftAt = [&](TemplateComparison comparison, std::size_t level) {
        TemplateConfig config;
        config.comparison = comparison;
        const Design found = designed(config, part);
        const DesignPlot& warp = plotOf(found, "warp");
        return std::abs(255.0 * (warp.values[level] - warp.intensities[level]));
    };
    for (const std::size_t level : {14U, 80U}) EXPECT_LT(shiftAt(TemplateComparison::logarithm, level), 3.0) << level;
    EXPECT_GT(shiftAt(TemplateComparison::cumulative, 14), 10.0);
}

TEST(TemplateCurve, FactsArePlottedAndTheDistanceFalls) {
    const Design found = designed(TemplateConfig{}, mapped(quietFetus(), [](double x) { return x + 40.0 / 255.0; }));
    EXPECT_LT(factOf(found, "distance"), 0.2 * factOf(found, "distance_before"));
    EXPECT_NEAR(factOf(found, "largest_shift"), 40.0 / 255.0, 3.0 / 255.0);
    ASSERT_EQ(found.plots.size(), 3U);
    EXPECT_EQ(plotOf(found, "reference_histogram").values, fetusTemplate()->histogram);
    EXPECT_EQ(found.explanation.size(), 2U);
    // What is white already is cut off when it becomes brighter.
    EXPECT_TRUE(std::isnan(plotOf(found, "warp").values[255]));
}

TEST(TemplateCurve, WhereNothingCanBeComparedTheCurveStaysAsItWas) {
    VolumeGeometry geometry;
    geometry.size = {3, 3, 3};
    const Volume constant(geometry, std::vector<std::uint8_t>(27, 9)), zero(geometry, std::vector<std::uint8_t>(27, 0));
    const Volume none = constant.withDataMask(std::vector<std::uint8_t>(27, std::uint8_t{0}));
    const Volume single(VolumeGeometry{}, std::vector<float>{0.3f}, 1.0);
    const Volume unknown(VolumeGeometry{}, std::vector<float>{std::nanf("")}, 1.0);
    for (const Volume* volume : {&constant, &zero, &none, &single, &unknown}) {
        const Design found = designed(TemplateConfig{}, *volume);
        EXPECT_FALSE(found.message.empty());
        EXPECT_EQ(found.classification, Classification(fetusTemplate()->curve));
    }
    TemplateConfig empty;
    empty.reference = templateFrom(none, PowerCurve{2, 0.5}, "nothing");
    const Design found = designed(empty, quietFetus());
    EXPECT_FALSE(found.message.empty());
    EXPECT_EQ(found.classification, Classification(PowerCurve{2, 0.5}));
}

TEST(TemplateCurve, AReferenceThatShowsNothingIsNotUsed) {
    TemplateConfig config;
    config.reference = templateFrom(quietFetus(), ManualCurve{}, "clear");
    const Design found = designed(config, quietFetus());
    EXPECT_FALSE(found.message.empty());
    EXPECT_EQ(found.classification, Classification(PowerCurve{2, 1.0}));
}

TEST(TemplateCurve, AFewVoxelsOfAnyTypeGiveASoundCurve) {
    VolumeGeometry geometry;
    geometry.size = {2, 1, 1};
    for (const Volume& volume :
         {Volume(geometry, std::vector<std::uint8_t>{0, 255}), Volume(geometry, std::vector<std::uint16_t>{100, 60000}),
          Volume(geometry, std::vector<float>{-2.0f, 7.0f}, 5.0)}) {
        const Design found = designed(TemplateConfig{}, volume);
        EXPECT_TRUE(found.message.empty());
        double last = 0.0;
        for (const double opacity : sampledOpacities(found.classification.curve(), 256)) {
            EXPECT_TRUE(opacity >= last && opacity <= 1.0) << "the reference's curve rises, and t is monotone";
            last = opacity;
        }
    }
}

TEST(TemplateCurve, BrokenContractsThrow) {
    VolumeGeometry other;
    const Volume another(other, std::vector<std::uint8_t>{1});
    EXPECT_THROW((void)design(TemplateConfig{}, DesignerInput{quietFetus(), another}), std::invalid_argument);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double slope : {0.0, -1.0, 20.0, nan}) {
        TemplateConfig least, largest;
        least.leastSlope = largest.largestSlope = slope;
        EXPECT_THROW((void)designed(least, another), std::invalid_argument);
        EXPECT_THROW((void)designed(largest, another), std::invalid_argument);
    }
    TemplateReference few = *fetusTemplate(), negative = few, unknown = few, more = few;
    few.histogram.pop_back();
    negative.histogram[1] = -1.0;
    unknown.histogram[1] = nan;
    more.histogram[1] = 0.5;
    for (const TemplateReference& bad : {few, negative, unknown, more}) {
        TemplateConfig config;
        config.reference = bad;
        EXPECT_THROW((void)designed(config, another), std::invalid_argument);
    }
}

TEST(TemplateCurve, IsEmptyWhereItWasCancelled) {
    const std::atomic<bool> cancel = true;
    Progress progress;
    progress.cancel = &cancel;
    EXPECT_FALSE(design(TemplateConfig{}, DesignerInput{quietFetus(), quietFetus()}, progress).has_value());
}

TEST(TemplateCurve, ConfigsAreValuesAndRowsReadAndSetThem) {
    TemplateConfig config, other;
    EXPECT_EQ(config, other);
    EXPECT_EQ(&*config.reference, &*other.reference) << "copies share";
    const auto table = parametersOf(config);
    EXPECT_TRUE(problemIn(table, config).empty());
    EXPECT_TRUE(parameterNamed(table, "comparison")->set(config, std::string("cumulative")));
    EXPECT_FALSE(parameterNamed(table, "comparison")->set(config, std::string("nonsense")));
    EXPECT_TRUE(parameterNamed(table, "least_slope")->set(config, 0.5));
    EXPECT_TRUE(parameterNamed(table, "largest_slope")->set(config, std::int64_t{2}));
    EXPECT_EQ(config.comparison, TemplateComparison::cumulative);
    EXPECT_EQ(config.leastSlope, 0.5);
    EXPECT_EQ(config.largestSlope, 2.0);
    EXPECT_NE(config, other);
    other.reference = templateFrom(quietFetus(), PowerCurve{2, 1.0}, "mine");
    EXPECT_NE(other, TemplateConfig{});
}

}  // namespace
}  // namespace echolucent
