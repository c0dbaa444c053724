#include "processing/scan_conversion/polar_geometry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "polar_probes.h"

namespace echolucent {
namespace {

using testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

PolarGeometry wobbler() { return everyPolar()[3].polar; }

/// Whether a sample lies behind the axis about which the planes turn, or nearly in it.
bool liesBehindPlanesAxis(const PolarGeometry& polar, const Vec3& index) {
    if (polar.planes.spread == PolarSpread::positions) return false;
    PolarGeometry flat = polar;
    flat.planes.spread = PolarSpread::positions;
    return probeMmFromPolar(flat, index)[2] + polar.planes.radiusMm < 1e-3;
}

TEST(PolarGeometry, EveryIndexComesBackFromItsPosition) {
    for (const auto& [name, polar] : everyPolar()) {
        ASSERT_FALSE(problemOf(polar)) << name << ": " << problemOf(polar)->words;
        for (const double sample : {0.0, 0.4, 13.25, 29.0})
            for (const double line : {0.0, 0.5, 7.75, 16.0})
                for (const double plane : {0.0, 3.3, 11.9, 12.0}) {
                    const Vec3 mm = probeMmFromPolar(polar, {sample, line, plane});
                    // In the apex of a sector all lines and planes meet.
                    if (name == "sector" && sample == 0.0) continue;
                    // Parts of beams that lie behind the axis of the planes belong to no position.
                    if (liesBehindPlanesAxis(polar, {sample, line, plane})) continue;
                    const auto index = polarFromProbeMm(polar, mm);
                    ASSERT_TRUE(index) << name << " " << sample << " " << line << " " << plane;
                    EXPECT_NEAR((*index)[0], sample, 1e-9) << name;
                    EXPECT_NEAR((*index)[1], line, 1e-9) << name;
                    EXPECT_NEAR((*index)[2], plane, 1e-9) << name;
                }
    }
}

TEST(PolarGeometry, EveryPositionComesBackFromItsIndex) {
    for (const auto& [name, polar] : everyPolar())
        for (const Vec3& mm : {Vec3(3, -2, 20), Vec3(-8, 5, 35), Vec3(0, 0, 12), Vec3(12, 10, 30), Vec3(-1, -9, 9)}) {
            const auto index = polarFromProbeMm(polar, mm);
            EXPECT_LT(index ? length(probeMmFromPolar(polar, *index) - mm) : 0.0, 1e-9) << name;
        }
}

// The toroidal formulas as they are published for the GE Voluson, with R and r in mm.
TEST(PolarGeometry, WobblerFollowsTheToroidalFormulas) {
    const double bigR = 15, firstRadius = 40, step = 1.5;
    const PolarGeometry polar = wobbler();
    for (const std::size_t line : {0, 5, 16})
        for (const std::size_t plane : {0, 6, 12})
            for (const int sample : {0, 11, 29}) {
                const double r = firstRadius + sample * step;
                const double th = polar.lines.values[line], ph = -polar.planes.values[plane];
                const Vec3 toroidal(r * std::sin(th), -(r * std::cos(th) - bigR) * std::sin(ph),
                                    bigR * (1 - std::cos(ph)) + r * std::cos(th) * std::cos(ph));
                const Vec3 mm = probeMmFromPolar(
                    polar, {static_cast<double>(sample), static_cast<double>(line), static_cast<double>(plane)});
                EXPECT_LT(length(mm + Vec3(0, 0, firstRadius) - toroidal), 1e-9);
            }
}

TEST(PolarGeometry, OutsideOfTheSweepHasNoIndex) {
    const PolarGeometry polar = wobbler();
    EXPECT_TRUE(polarFromProbeMm(polar, {0, 0, 20}));
    EXPECT_FALSE(polarFromProbeMm(polar, {0, 0, -0.1}));
    EXPECT_FALSE(polarFromProbeMm(polar, {0, 0, 44}));
    EXPECT_FALSE(polarFromProbeMm(polar, {50, 0, 20}));
    EXPECT_FALSE(polarFromProbeMm(polar, {0, 30, 20}));
    EXPECT_FALSE(polarFromProbeMm(polar, {nan, 0, 20}));
}

TEST(PolarGeometry, ProblemsAreNamed) {
    const auto wordsOf = [](const std::function<void(PolarGeometry&)>& change) {
        PolarGeometry polar = wobbler();
        change(polar);
        const auto problem = problemOf(polar);
        if (!problem) return std::string("no problem");
        const char* part = problem->part == PolarPart::range   ? "range "
                           : problem->part == PolarPart::lines ? "lines "
                                                               : "planes ";
        return part + problem->words;
    };
    EXPECT_EQ(wordsOf([](PolarGeometry&) {}), "no problem");
    EXPECT_THAT(wordsOf([](PolarGeometry& p) { p.samples = 1; }), HasSubstr("range has 1 sample(s)"));
    EXPECT_THAT(wordsOf([](PolarGeometry& p) { p.samples = 1 << 25; }), HasSubstr("more than any scanner has"));
    EXPECT_THAT(wordsOf([](PolarGeometry& p) { p.rangeStepMm = 0; }), HasSubstr("step of 0 mm"));
    EXPECT_THAT(wordsOf([](PolarGeometry& p) { p.rangeStepMm = nan; }), HasSubstr("range has a step of nan mm"));
    EXPECT_THAT(wordsOf([](PolarGeometry& p) { p.rangeStartMm = nan; }), HasSubstr("starts at nan mm"));
    EXPECT_THAT(wordsOf([](PolarGeometry& p) { p.samples = 200000; }), HasSubstr("farther than any scanner reaches"));
    EXPECT_THAT(wordsOf([](PolarGeometry& p) { p.lines.values.clear(); }), HasSubstr("lines are 0, not two"));
    EXPECT_THAT(wordsOf([](PolarGeometry& p) { p.lines.values[3] = nan; }), HasSubstr("lines hold nan radians"));
    EXPECT_THAT(wordsOf([](PolarGeometry& p) { p.planes.values[3] = 3.2; }), HasSubstr("planes hold 3.2 radians"));
    EXPECT_THAT(wordsOf([](PolarGeometry& p) { p.lines.values[3] = p.lines.values[2]; }),
                HasSubstr("lines neither rise nor fall"));
    EXPECT_THAT(wordsOf([](PolarGeometry& p) { std::swap(p.planes.values[3], p.planes.values[4]); }),
                HasSubstr("planes neither rise nor fall"));
    EXPECT_THAT(wordsOf([](PolarGeometry& p) { p.lines.radiusMm = nan; }), HasSubstr("an axis nan mm from the face"));
    EXPECT_THAT(wordsOf([](PolarGeometry& p) { p.planes.radiusMm = -5; }), HasSubstr("behind the first sample"));
    EXPECT_THAT(wordsOf([](PolarGeometry& p) {
                    p.lines.spread = PolarSpread::positions;
                    p.lines.values[0] = -1e9;
                }),
                HasSubstr("lines hold -1e+09 mm"));
}

TEST(PolarGeometry, EvenGeometryComesBack) {
    for (const PolarKind kind : {PolarKind::linear, PolarKind::convex, PolarKind::linearWobbler, PolarKind::wobbler}) {
        const PolarGeometry polar = polarGeometry({kind, 1, 0.25, {-20, 30}, {-10, 15}, 41, 22}, {50, 40, 30});
        EXPECT_EQ(polar.size(), (std::array<std::int64_t, 3>{50, 40, 30}));
        const EvenPolar even = evenPolarOf(polar);
        EXPECT_EQ(even.kind, kind);
        EXPECT_DOUBLE_EQ(even.lines[0], -20);
        EXPECT_DOUBLE_EQ(even.planes[1], 15);
        EXPECT_EQ(polarKindFromName(nameOf(kind)), kind);
        const PolarGeometry again = polarGeometry(even, polar.size());
        for (std::size_t i = 0; i < 40; ++i) EXPECT_NEAR(again.lines.values[i], polar.lines.values[i], 1e-12);
    }
    // A person may type any size; the geometry says then that it makes no sense.
    EXPECT_EQ(polarGeometry({}, {50, std::int64_t{1} << 50, 0}).size()[1], mostPolarLines);
}

TEST(PolarGeometry, ApexLiesBetweenTheAxes) {
    EXPECT_EQ(apexMm(wobbler()), Vec3(0, 0, -32.5));
    EXPECT_FALSE(apexMm(everyPolar()[0].polar));
    EXPECT_FALSE(apexMm(everyPolar()[1].polar));
}

}  // namespace
}  // namespace echolucent
