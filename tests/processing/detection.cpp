// The share of the weight that lies on right tubes, on phantoms with known surfaces under method.md's conditions. The
// figures are printed, so that a change of the method shows what it brought.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

#include "processing/measures/detection_quality.h"

namespace echolucent {
namespace {

struct Shares {
    DetectionQuality pooled;
    double rightSum = 0.0, emptySum = 0.0;
    int count = 0;

    void add(const DetectionQuality& quality) {
        pooled.add(quality);
        rightSum += quality.rightShare();
        emptySum += quality.emptyShare();
        ++count;
    }
    /// Of all volumes' weight together, and the mean of the volumes' shares: the worse of the two.
    [[nodiscard]] double right() const { return std::min(pooled.rightShare(), rightSum / count); }
    [[nodiscard]] double empty() const { return std::max(pooled.emptyShare(), emptySum / count); }
};

/// Measures each condition along the beam and obliquely, and prints a line for each.
Shares measure(const std::vector<NamedPhantom>& conditions, const View& oblique) {
    Shares shares;
    for (const NamedPhantom& condition : conditions) {
        const Volume volume = *makePhantom(condition.config);
        const PhantomTruth truth(condition.config);
        for (const View& view : {View{}, oblique}) {
            const AdaptiveOtf otf = *adaptOpacity(volume, view, {});
            const DetectionQuality quality = detectionQuality(otf, truth, volume.geometry());
            std::printf(
                "%-6s seed %llu %-20s %3.0f/%3.0f deg: right %.3f, on tubes with none %.3f, found %.3f of %d tubes\n",
                std::string(nameOf(condition.config.scene)).c_str(),
                static_cast<unsigned long long>(condition.config.seed), condition.name.c_str(), view.azimuthDegrees,
                view.elevationDegrees, quality.rightShare(), quality.emptyShare(), quality.foundShare(),
                quality.tubesWithInterface);
            shares.add(quality);
        }
    }
    return shares;
}

Shares measureSeeds(std::vector<NamedPhantom> (*conditions)(const PhantomConfig&), const std::string& name) {
    Shares all;
    struct Run {
        PhantomScene scene;
        std::uint64_t seed;
        View oblique;
    };
    for (const Run& run : {Run{PhantomScene::shapes, 1, {.azimuthDegrees = 20, .elevationDegrees = -12}},
                           Run{PhantomScene::shapes, 2, {.azimuthDegrees = -15, .elevationDegrees = 8}},
                           Run{PhantomScene::fetus, 3, {.azimuthDegrees = 12, .elevationDegrees = 10}}}) {
        PhantomConfig base = defaultPhantom(run.scene);
        base.seed = run.seed;
        const Shares shares = measure(conditions(base), run.oblique);
        all.pooled.add(shares.pooled);
        all.rightSum += shares.rightSum;
        all.emptySum += shares.emptySum;
        all.count += shares.count;
    }
    std::printf("%s: right %.3f (mean of volumes %.3f), on tubes with none %.3f (%.3f), found %.3f\n", name.c_str(),
                all.pooled.rightShare(), all.rightSum / all.count, all.pooled.emptyShare(), all.emptySum / all.count,
                all.pooled.foundShare());
    return all;
}

TEST(Detection, OrdinaryConditions) {
    const Shares shares = measureSeeds(ordinaryConditions, "ordinary");
    EXPECT_GE(shares.right(), 0.95);
    EXPECT_LE(shares.empty(), 0.03);
    EXPECT_GE(shares.pooled.foundShare(), 0.85);
}

TEST(Detection, HardConditions) {
    const Shares shares = measureSeeds(hardConditions, "hard");
    EXPECT_GE(shares.right(), 0.80);
    EXPECT_LE(shares.empty(), 0.06);
    EXPECT_GE(shares.pooled.foundShare(), 0.55);
}

TEST(Detection, FrontWall) {
    const Shares shares = measureSeeds(frontWallConditions, "front wall");
    EXPECT_GE(shares.right(), 0.90);
    EXPECT_LE(shares.empty(), 0.05);
}

TEST(Detection, AVolumeWithoutFluidGivesNextToNothing) {
    // Ranks are relative: only the absolute test tells that nothing is there.
    PhantomConfig base = defaultPhantom(PhantomScene::empty);
    for (const std::uint64_t seed : {4u, 5u}) {
        base.seed = seed;
        const Volume volume = *makePhantom(emptyConditions(base).front().config);
        AdaptiveOtfConfig untested;
        untested.leastEdgeToNoise = 0;
        const auto sumOfD = [&](const AdaptiveOtfConfig& config) {
            const AdaptiveOtf otf = *adaptOpacity(volume, {}, config);
            double sum = 0.0;
            for (const TubeCore& tube : otf.tubes) sum += tube.d;
            return sum;
        };
        const double sum = sumOfD({}), sumUntested = sumOfD(untested);
        std::printf("empty  seed %llu: sum of d %.3f, without the absolute test %.3f\n",
                    static_cast<unsigned long long>(seed), sum, sumUntested);
        EXPECT_LE(sum, 0.05);
    }
}

}  // namespace
}  // namespace echolucent
