#include "processing/designers/fixed_presets.h"

#include <gtest/gtest.h>

#include "designer_volumes.h"
#include "processing/document/curve_set.h"

namespace echolucent {
namespace {

TEST(FetalPreset, HasTheOpacitiesOf3dSlicerAndIsTheManualCurveAtStart) {
    const Design design = designed(FetalPresetConfig{}, bytesOf({0, 60, 120, 255}));
    const auto opacityAtLevel = [&](double level) { return opacityAt(design.classification, level / 255.0, 0); };
    EXPECT_EQ(opacityAtLevel(0), 0.0);
    EXPECT_EQ(opacityAtLevel(60), 0.0);
    EXPECT_NEAR(opacityAtLevel(90), 0.3, 1e-12);
    EXPECT_NEAR(opacityAtLevel(120), 0.6, 1e-12);
    EXPECT_NEAR(opacityAtLevel(187.5), 0.7, 1e-12);
    EXPECT_NEAR(opacityAtLevel(255), 0.8, 1e-12);
    EXPECT_EQ(design.classification.curve(), OpacityCurve(CurveSet{}.manual));
    EXPECT_EQ(design.facts.at(0).value, 0.5) << "two voxels of four are above level 60";
    EXPECT_TRUE(parametersOf(FetalPresetConfig{}).empty());
}

/// The ramp as its definition says it, before anything is cut off.
double echoRampAt(double intensity, double threshold, double edge) {
    if (intensity <= threshold - edge) return 0.0;
    if (intensity <= threshold) return 0.2 * (intensity - (threshold - edge)) / edge;
    if (intensity <= threshold + edge) return 0.8 + 0.15 * (intensity - threshold) / edge;
    return 0.95;
}

TEST(EchoRamp, FollowsItsDefinitionAlsoWhereItIsCutOff) {
    const Volume volume = bytesOf({0, 100, 255});
    for (const double threshold : {0.0, 0.02, 0.2, 0.5, 0.97, 1.0})
        for (const double edge : {0.001, 0.05, 0.2, 1.0}) {
            const Design design = designed(EchoRampConfig{threshold, edge}, volume);
            for (int i = 0; i <= 1000; ++i) {
                const double intensity = i / 1000.0;
                // At the threshold itself the opacity jumps.
                if (std::abs(intensity - threshold) < 1e-9) continue;
                EXPECT_NEAR(opacityAt(design.classification, intensity, 0), echoRampAt(intensity, threshold, edge),
                            1e-9)
                    << threshold << " " << edge << " " << intensity;
            }
            for (const CurveNode& node : std::get<ManualCurve>(design.classification.curve()).nodes)
                EXPECT_TRUE(node.intensity >= 0.0 && node.intensity <= 1.0);
        }
}

TEST(EchoRamp, JumpsAtTheThreshold) {
    const Design design = designed(EchoRampConfig{}, bytesOf({0, 100, 255}));
    EXPECT_NEAR(opacityAt(design.classification, 0.15, 0), 0.0, 1e-12);
    EXPECT_NEAR(opacityAt(design.classification, 0.2, 0), 0.2, 1e-12);
    EXPECT_NEAR(opacityAt(design.classification, 0.2 + 1e-12, 0), 0.8, 1e-9);
    EXPECT_NEAR(opacityAt(design.classification, 0.25, 0), 0.95, 1e-12);
    EXPECT_NEAR(opacityAt(design.classification, 1.0, 0), 0.95, 1e-12);
    // Without an edge it is a step.
    const Design step = designed(EchoRampConfig{0.2, 0.0}, bytesOf({0, 100, 255}));
    EXPECT_EQ(opacityAt(step.classification, 0.1999, 0), 0.0);
    EXPECT_EQ(opacityAt(step.classification, 0.2001, 0), 0.95);
}

/// The same for every volume, whatever it holds; what no voxel can show is said.
TEST(FixedPresets, AreTheSameForEveryVolumeAndSayWhereTheyShowNothing) {
    const Design fetal = designed(FetalPresetConfig{}, bytesOf({0, 60, 120, 255}));
    const Design ramp = designed(EchoRampConfig{}, bytesOf({0, 60, 120, 255}));
    EXPECT_TRUE(fetal.message.empty() && ramp.message.empty());
    for (const Volume& volume : twoClassVolumes(1)) {
        EXPECT_EQ(designed(FetalPresetConfig{}, volume).classification, fetal.classification);
        EXPECT_EQ(designed(EchoRampConfig{}, volume).classification, ramp.classification);
    }
    for (const Volume& volume : volumesWithoutContrast()) {
        const bool dark = dataOf(volume).empty() || dataOf(volume).front() == 0.0;
        const Design one = designed(FetalPresetConfig{}, volume), other = designed(EchoRampConfig{}, volume);
        EXPECT_EQ(one.message.empty(), !dark);
        EXPECT_EQ(other.message.empty(), !dark);
        expectSound(one.classification);
        expectSound(other.classification);
    }
    expectContract(FetalPresetConfig{});
    expectContract(EchoRampConfig{});
}

}  // namespace
}  // namespace echolucent
