// References of templates, and the numbers of the one that stands ready.
#include "processing/designers/template/template_reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/adaptive/method_reading.h"
#include "processing/phantom/phantom.h"
#include "processing/speckle_reduction/speckle_reduction.h"
#include "tests/processing/grids.h"

namespace echolucent {
namespace {

TEST(TemplateReference, HoldsTheSharesOfVoxelsWithData) {
    const Volume bytes(gridOf({5, 1, 1}), std::vector<std::uint8_t>{0, 10, 10, 255, 77});
    const TemplateReference reference =
        templateFrom(bytes.withDataMask(DataMask{1, 1, 1, 1, 0}), PowerCurve{2, 1.0}, "mine");
    EXPECT_EQ(reference.name, "mine");
    EXPECT_EQ(reference.curve, OpacityCurve(PowerCurve{2, 1.0}));
    ASSERT_EQ(reference.histogram.size(), 256U);
    EXPECT_EQ(reference.histogram[0], 0.25);
    EXPECT_EQ(reference.histogram[10], 0.5);
    EXPECT_EQ(reference.histogram[255], 0.25);
    EXPECT_EQ(reference.histogram[77], 0.0);
}

TEST(TemplateReference, VoxelsThatAreNotFiniteAreNoDataWhateverTheMaskSays) {
    const std::vector<float> values{0.5f, std::nanf(""), INFINITY, 0.25f};
    const Volume volume(gridOf({4, 1, 1}), values, 1.0);
    for (const Volume& each : {volume, volume.withDataMask(DataMask{1, 1, 1, 1})}) {
        const TemplateReference reference = templateFrom(each, {}, {});
        EXPECT_EQ(reference.histogram[128], 0.5);
        EXPECT_EQ(reference.histogram[64], 0.5);
    }
}

TEST(TemplateReference, OfNoDataHoldsNothing) {
    const Volume volume(gridOf({2, 1, 1}), std::vector<std::uint8_t>{1, 2});
    const TemplateReference reference = templateFrom(volume.withDataMask(DataMask{0, 0}), {}, {});
    EXPECT_EQ(std::accumulate(reference.histogram.begin(), reference.histogram.end(), 0.0), 0.0);
}

TEST(TemplateReference, SharedOnesAreEqualWhereTheReferencesAre) {
    TemplateReference reference = *fetusTemplate();
    const SharedTemplate shared = fetusTemplate();
    EXPECT_EQ(&*shared, &*fetusTemplate()) << "copies share";
    EXPECT_EQ(SharedTemplate(reference), fetusTemplate());
    reference.histogram[3] += 0.1;
    EXPECT_FALSE(SharedTemplate(reference) == fetusTemplate());
}

/// The stored numbers are those of the phantom: shares within a thousandth of their sum, the curve within 0.02.
TEST(TemplateReference, TheStoredFetusIsWhatThePhantomGives) {
    const Volume raw = *makePhantom(fetusTemplateConfig());
    const Volume quiet = *quietVolume(raw, defaultSpeckleReduction);
    const TemplateReference now = templateFrom(quiet, {}, {});
    const TemplateReference& stored = *fetusTemplate();
    ASSERT_EQ(stored.histogram.size(), 256U);
    double apart = 0.0;
    for (std::size_t bin = 0; bin < 256; ++bin) apart += std::abs(stored.histogram[bin] - now.histogram[bin]);
    EXPECT_LT(apart, 1e-3);
    EXPECT_NEAR(std::accumulate(stored.histogram.begin(), stored.histogram.end(), 0.0), 1.0, 1e-12);
    const AdaptiveOtf adaptive =
        *adaptOpacity(raw, {}, configOf(MethodReading::firstVersion), {}, {&quiet, defaultSpeckleReduction});
    for (int i = 0; i < 256; ++i) {
        const double intensity = i / 255.0;
        EXPECT_NEAR(opacityAt(stored.curve, intensity), opacityAt(adaptive.curve, intensity), 0.02) << i;
    }
}

}  // namespace
}  // namespace echolucent
