// The ray caster's picture of a volume of two intensities, against eqs. 2 and 3.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/theory/contrast_course.h"
#include "processing/theory/two_intensity_volume.h"

namespace echolucent {
namespace {

constexpr double halfPercent = 0.005;

TEST(TheoryPicture, IsEquation3WithinHalfAPercentOfWhite) {
    for (const double ratio : {0.05, 14.0 / 85.0, 0.5, 1.0})
        for (const std::int64_t units : {0, 1, 7, 30, 90})
            for (const double background : {0.0, 1.0}) {
                TheorySetting setting;
                setting.model.fluid = ratio * setting.model.tissue;
                setting.model.fluidUnits = units;
                setting.model.background = background;
                const Volume volume = makeTwoIntensityVolume({.model = setting.model, .edge = 8});
                for (const TheoryCurve& named : curvesOf(setting)) {
                    const ModelPixels theory = pixelsOf(setting.model, named.curve);
                    const MeasuredPixels picture = measuredPixels(volume, named.curve, background);
                    for (const double pixel : {picture.fluid.least, picture.fluid.most})
                        EXPECT_NEAR(pixel, theory.fluid, halfPercent) << named.name << ", " << units << " units";
                    for (const double pixel : {picture.tissue.least, picture.tissue.most})
                        EXPECT_NEAR(pixel, theory.tissue, halfPercent) << named.name << ", " << units << " units";
                }
            }
}

TEST(TheoryPicture, UncorrelatedSpeckleBrightensAsItsMomentsSay) {
    const TwoIntensities model;
    for (const double speckle : {0.5, 1.0}) {
        const Volume volume =
            makeTwoIntensityVolume({.model = model, .edge = 64, .speckle = speckle, .speckleSize = 0.0});
        for (const OpacityCurve& curve : {OpacityCurve(PowerCurve{1, 1.0}), OpacityCurve(PowerCurve{2, 1.0}),
                                          OpacityCurve(PowerCurve{4, 1.0}), OpacityCurve(LinearCurve{})}) {
            const MeasuredPixels picture = measuredPixels(volume, curve, 0.0);
            const ModelPixels mean = speckledPixelsOf(model, curve, speckle);
            // 2048 pixels in each half: five standard errors, and what the table of quantiles leaves of the tail.
            const double count = std::sqrt(2048.0);
            EXPECT_NEAR(picture.tissue.mean, mean.tissue, 5.0 * picture.tissue.spread / count + 2e-4);
            EXPECT_NEAR(picture.fluid.mean, mean.fluid, 5.0 * picture.fluid.spread / count + 2e-4);
        }
    }
    const OpacityCurve parabola = PowerCurve{2, 1.0};
    EXPECT_NEAR(speckledPixelsOf(model, parabola, 0.0).tissue, pixelsOf(model, parabola).tissue, 1e-12);
    EXPECT_GT(speckledPixelsOf(model, parabola, 1.0).tissue, pixelsOf(model, parabola).tissue + 0.05)
        << "full speckle brightens tissue by more than the half percent that theory is right to without it";
    // A voxel of a Rayleigh field of mean 1 and variance 4 / pi - 1 has a mean square of 4 / pi.
    EXPECT_NEAR(speckledLayer({0.1, 0.01, 1}, parabola, 1.0).opacity, 0.01 * 4.0 / std::numbers::pi, 1e-5);
}

TEST(TheoryPicture, TheMethodReadsTheModelsIntensitiesInItsVolume) {
    const TwoIntensities model;
    const Volume volume = makeTwoIntensityVolume({.model = model, .edge = 96});
    const AdaptiveOtf otf = adaptOpacity(volume, Viewpoint{}, {}).value();
    ASSERT_GT(otf.tubesWithWeight, 0) << otf.message;
    const MeanInterface mean = meanInterfaceOf(otf);
    EXPECT_NEAR(mean.low, model.fluid, 1e-3);
    EXPECT_NEAR(mean.high, model.tissue, 0.005) << "tube cores across the edge of the halves read less";
    const SampledCurve own = adaptiveCurveOf(model);
    for (std::size_t i = 0; i < own.opacities.size(); ++i)
        EXPECT_NEAR(otf.curve.opacities[i], own.opacities[i], 0.05) << i;
}

TEST(TheoryPicture, VolumesOutOfRangeAreRefused) {
    const TwoIntensityVolume wanted;
    TwoIntensityVolume changed = wanted;
    changed.model.tissue = std::nan("");
    EXPECT_THROW(static_cast<void>(makeTwoIntensityVolume(changed)), std::invalid_argument);
    changed = wanted;
    changed.model.fluidUnits = changed.model.tissueUnits = 0;
    EXPECT_THROW(static_cast<void>(makeTwoIntensityVolume(changed)), std::invalid_argument) << "no voxel";
    changed = wanted;
    changed.speckle = 1.5;
    EXPECT_THROW(static_cast<void>(makeTwoIntensityVolume(changed)), std::invalid_argument);
}

}  // namespace
}  // namespace echolucent
