// The curve depends on what the tubes see, not on how many they are: d_max = strength / T.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "plane_detection.h"
#include "processing/adaptive/method_reading.h"
#include "processing/phantom/phantom.h"
#include "processing/tube_core/basis_function.h"
#include "tests/processing/tube_core/signals.h"

namespace echolucent {
namespace {

/// Intensities that are seen at all on a display of 8 bits.
int visible(const SampledCurve& curve) {
    return static_cast<int>(std::count_if(curve.opacities.begin(), curve.opacities.end(),
                                          [](double opacity) { return opacity > 1.0 / 255.0; }));
}

TEST(LongTubeCount, TheCurveIsTheSameFor225And100000TubesOfOnePhantom) {
    PhantomConfig phantom = defaultPhantom(PhantomScene::shapes);
    phantom.size = {100, 98, 100};
    phantom.seed = 3;
    const Volume volume = *makePhantom(phantom);
    struct Row {
        std::string name;
        AdaptiveOtfConfig config;
        double tolerance;  ///< what other tubes see of the same object: sampling, not degeneration
    };
    AdaptiveOtfConfig product;
    product.curve = ProductRule{};
    for (Row row : {Row{"settled", configOf(MethodReading::settled), 0.01}, Row{"ratio, product", product, 0.03},
                    Row{"default", {}, 0.05}}) {
        const AdaptiveOtf few = adapted(volume, {}, row.config);
        row.config.grid.columns = row.config.grid.rows = 316;
        row.config.grid.spacing = few.tubeSpacingUnits[0] * 15 / 316;
        const AdaptiveOtf many = adapted(volume, {}, row.config);
        const double difference = largestDifference(few.curve.opacities, many.curve.opacities);
        std::printf("%-15s T = %d and %d: opacities differ by at most %.4f; visible intensities %d and %d\n",
                    row.name.c_str(), few.tubesMeetingVolume, many.tubesMeetingVolume, difference, visible(few.curve),
                    visible(many.curve));
        EXPECT_EQ(few.tubesMeetingVolume, 225);
        EXPECT_GT(many.tubesMeetingVolume, 99000);
        EXPECT_LE(difference, row.tolerance) << row.name;
        auto* rule = std::get_if<ProductRule>(&row.config.curve);
        if (rule == nullptr) continue;
        // What the rule is for: a d_max that stays what it is for 225 tube cores, as eq. 11 may be read.
        rule->strength *= 99856.0 / 225.0;
        const AdaptiveOtf fixedMaximum = adapted(volume, {}, row.config);
        const double degeneration = largestDifference(few.curve.opacities, fixedMaximum.curve.opacities);
        std::printf("%-15s with d_max fixed: %.4f, visible intensities %d\n", "", degeneration,
                    visible(fixedMaximum.curve));
        EXPECT_GT(degeneration, 0.5);
    }
}

TEST(LongTubeCount, TheSameTubesManyTimesOverGiveTheSameCurve) {
    // (1 + s / T)^T grows to e^s: from T = 225 to 1e5 by a factor of 1 + s / 450 at most, s the strength.
    PhantomConfig phantom = defaultPhantom(PhantomScene::shapes);
    phantom.size = {90, 90, 90};
    const AdaptiveOtf otf = adapted(*makePhantom(phantom), {}, configOf(MethodReading::settled));
    constexpr int times = 444;
    std::vector<TubeCore> copies;
    for (const TubeCore& tube : otf.tubes)
        for (int i = 0; i < times; ++i) {
            copies.push_back({});
            copies.back().d = tube.d / times;
            copies.back().lowIntensity = tube.lowIntensity;
            copies.back().highIntensity = tube.highIntensity;
        }
    const auto logOpacity = adaptedLogOpacity(otf.config.initial, copies, 256);
    double largest = 0.0;
    for (std::size_t i = 1; i < 256; ++i) largest = std::max(largest, std::abs(logOpacity[i] - otf.logOpacity[i]));
    const double opacities = largestDifference(curveFromLogOpacity(logOpacity).opacities, otf.curve.opacities);
    std::printf("225 tubes, each %d times: log opacity differs by at most %.4f, opacity by %.4f\n", times, largest,
                opacities);
    EXPECT_LE(largest, strengthOf(otf.config.curve) * otf.dMax / 2);
    EXPECT_LE(opacities, 0.02);
}

}  // namespace
}  // namespace echolucent
