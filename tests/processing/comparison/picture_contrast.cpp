// What the default reading makes of the picture: CNR_S under six conditions, beside fixed curves and the other
// readings. The figures are printed, so that a change of the method shows what it brought.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <vector>

#include "app/measuring/measures/phantom_conditions.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/adaptive/method_reading.h"
#include "processing/comparison/classification_measures.h"
#include "processing/comparison/surface_rays.h"
#include "processing/sampling/gradient_magnitude.h"
#include "processing/volume/filled_volume.h"
#include "tests/processing/comparison/small_volumes.h"

namespace echolucent {
namespace {

std::vector<NamedPhantom> sixConditions(const PhantomConfig& base) {
    std::vector<NamedPhantom> chosen;
    const auto take = [&](const std::vector<NamedPhantom>& from, const std::string& name) {
        for (const NamedPhantom& phantom : from)
            if (phantom.name == name) chosen.push_back(phantom);
    };
    for (const char* name : {"base", "specular", "little_speckle", "attenuation_shadow"})
        take(ordinaryConditions(base), name);
    for (const char* name : {"hard_full_speckle", "hard_log_compressed"}) take(hardConditions(base), name);
    return chosen;
}

TEST(LongPictureContrast, OfTheDefaultReadingIsHighAndNeverBelowFixedCurves) {
    PhantomConfig base = defaultPhantom(PhantomScene::shapes);
    base.size = {128, 128, 128};
    base.seed = 3;
    const auto conditions = sixConditions(base);
    ASSERT_EQ(conditions.size(), 6u);
    constexpr std::size_t curveCount = 6;
    std::array<double, curveCount> sums{};
    std::printf("%-22s %8s %8s %9s %8s %8s %8s\n", "CNR_S", "x^2", "eq. 1", "published", "settled", "0.1", "default");
    for (const NamedPhantom& condition : conditions) {
        const Volume volume = *makePhantom(condition.config);
        const Viewpoint view;
        std::vector<Classification> curves{PowerCurve{2, 1.0}, LinearCurve{20.0 / 255.0, 0.5, 1.0}};
        for (const MethodReading reading :
             {MethodReading::asPublished, MethodReading::settled, MethodReading::firstVersion, MethodReading::standard})
            curves.emplace_back(OpacityCurve(adaptOpacity(volume, view, configOf(reading))->curve));
        const auto rays = trueSurfaces(volume.geometry(), PhantomTruth(condition.config), view, InterfaceInto::object);
        const auto measures = *measuresOf(volume, view, rays, curves);
        std::array<double, curveCount> values{};
        for (std::size_t c = 0; c < curveCount; ++c) {
            ASSERT_TRUE(measures[c].contrast.contrastToNoise());
            values[c] = *measures[c].contrast.contrastToNoise();
            sums[c] += values[c];
        }
        std::printf("%-22s %8.2f %8.2f %9.2f %8.2f %8.2f %8.2f\n", condition.name.c_str(), values[0], values[1],
                    values[2], values[3], values[4], values[5]);
        for (const std::size_t ramps : {4u, 5u}) {
            EXPECT_GE(values[ramps], values[0]) << condition.name;
            EXPECT_GE(values[ramps], values[1]) << condition.name;
        }
    }
    const double count = static_cast<double>(conditions.size());
    std::printf("%-22s %8.2f %8.2f %9.2f %8.2f %8.2f %8.2f\n", "mean", sums[0] / count, sums[1] / count,
                sums[2] / count, sums[3] / count, sums[4] / count, sums[5] / count);
    // The aim shows more walls, and so haze before bright surfaces: of objects alone it has the smaller CNR_S.
    EXPECT_GE(sums[4] / count, 4.6);
    EXPECT_GE(sums[5] / count, 4.0);
}

/// CNR_S with the true surfaces of objects, with all true surfaces, and with those that the tube cores found; and the
/// share of light near these.
struct FourMeasures {
    double objects, truth, tubes, share;
};

TEST(LongPictureContrast, WithTheTubeCoresSurfacesPraisesTheAdaptiveCurveAsTheTruthDoes) {
    PhantomConfig base = defaultPhantom(PhantomScene::shapes);
    base.size = {128, 128, 128};
    base.seed = 3;
    const std::array<const char*, 4> names{"x^2", "eq. 1", "opacity by g", "default"};
    std::array<FourMeasures, 4> sums{};
    const auto print = [](const char* name, const FourMeasures& one) {
        std::printf("  %-14s %8.2f %8.2f %8.2f %7.1f %%\n", name, one.objects, one.truth, one.tubes, 100 * one.share);
    };
    std::printf("%-16s %8s %8s %8s %9s\n", "CNR_S", "objects", "truth", "tubes", "light");
    for (const NamedPhantom& condition : sixConditions(base)) {
        const Volume volume = *makePhantom(condition.config);
        const AdaptiveOtf otf = *adaptOpacity(volume, {}, {});
        const double steep = gradientRange(volume, filledVoxels(volume))->quantile99;
        const std::vector<Classification> all{PowerCurve{2, 1.0}, LinearCurve{20.0 / 255.0, 0.5, 1.0},
                                              opacityOfGradient(steep), otf.curve};
        const PhantomTruth truth(condition.config);
        const auto measuresInto = [&](InterfaceInto into) {
            return *measuresOf(volume, {}, trueSurfaces(volume.geometry(), truth, {}, into), all);
        };
        const auto objects = measuresInto(InterfaceInto::object);
        const auto truths = measuresInto(InterfaceInto::objectOrTissue);
        const auto measures = *measuresOf(volume, {}, *foundSurfaces(volume, {}), all);
        std::printf("%s, %d rays\n", condition.name.c_str(), measures[0].contrast.rays);
        std::array<FourMeasures, 4> values{};
        for (std::size_t c = 0; c < all.size(); ++c) {
            ASSERT_TRUE(objects[c].contrast.contrastToNoise() && truths[c].contrast.contrastToNoise());
            ASSERT_TRUE(measures[c].contrast.contrastToNoise());
            values[c] = {*objects[c].contrast.contrastToNoise(), *truths[c].contrast.contrastToNoise(),
                         *measures[c].contrast.contrastToNoise(), measures[c].light.meanShare};
            print(names[c], values[c]);
            sums[c].objects += values[c].objects / 6;
            sums[c].truth += values[c].truth / 6;
            sums[c].tubes += values[c].tubes / 6;
            sums[c].share += values[c].share / 6;
        }
        for (const std::size_t fixed : {0u, 1u}) {
            EXPECT_GE(values[3].tubes, values[fixed].tubes) << condition.name << ' ' << names[fixed];
            EXPECT_GE(values[3].share, values[fixed].share) << condition.name << ' ' << names[fixed];
        }
    }
    std::printf("mean\n");
    for (std::size_t c = 0; c < names.size(); ++c) print(names[c], sums[c]);
}

}  // namespace
}  // namespace echolucent
