// What the default reading makes of the picture: CNR_S under six conditions, beside fixed curves and the other
// readings. The figures are printed, so that a change of the method shows what it brought.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>

#include "app/measuring/measures/surface_contrast.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/adaptive/method_reading.h"

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

TEST(PictureContrast, OfTheDefaultReadingIsHighAndNeverBelowFixedCurves) {
    PhantomConfig base = defaultPhantom(PhantomScene::shapes);
    base.size = {128, 128, 128};
    base.seed = 3;
    const auto conditions = sixConditions(base);
    ASSERT_EQ(conditions.size(), 6u);
    constexpr std::size_t curveCount = 5;
    std::array<double, curveCount> sums{};
    std::printf("%-22s %8s %8s %9s %8s %8s\n", "CNR_S", "x^2", "eq. 1", "published", "settled", "default");
    for (const NamedPhantom& condition : conditions) {
        const Volume volume = *makePhantom(condition.config);
        const Viewpoint view;
        std::vector<OpacityCurve> curves{PowerCurve{2, 1.0}, LinearCurve{20.0 / 255.0, 0.5, 1.0}};
        for (const MethodReading reading :
             {MethodReading::asPublished, MethodReading::settled, MethodReading::standard})
            curves.emplace_back(adaptOpacity(volume, view, configOf(reading))->curve);
        const auto contrasts =
            surfaceContrasts(volume, objectRays(volume.geometry(), PhantomTruth(condition.config), view), view, curves);
        std::array<double, curveCount> values{};
        for (std::size_t c = 0; c < curveCount; ++c) {
            ASSERT_TRUE(contrasts[c].contrastToNoise());
            values[c] = *contrasts[c].contrastToNoise();
            sums[c] += values[c];
        }
        std::printf("%-22s %8.2f %8.2f %9.2f %8.2f %8.2f\n", condition.name.c_str(), values[0], values[1], values[2],
                    values[3], values[4]);
        EXPECT_GE(values[4], values[0]) << condition.name;
        EXPECT_GE(values[4], values[1]) << condition.name;
    }
    const double count = static_cast<double>(conditions.size());
    std::printf("%-22s %8.2f %8.2f %9.2f %8.2f %8.2f\n", "mean", sums[0] / count, sums[1] / count, sums[2] / count,
                sums[3] / count, sums[4] / count);
    EXPECT_GE(sums[4] / count, 4.6);
}

}  // namespace
}  // namespace echolucent
