// The same voxels on every instruction set.
#include "processing/scan_conversion/scan_conversion.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdio>
#include <cstring>
#include <map>

#include "polar_probes.h"

namespace echolucent {
namespace {

/// The bytes of all voxels that every kind of probe gives, in three types. The last plane of each volume is read where
/// nothing follows it (ConversionRow::endsHere).
std::map<std::string, std::string> convertedBytes() {
    std::map<std::string, std::string> all;
    for (const NamedPolar& named : everyPolar()) {
        const PolarGeometry& polar = named.polar;
        const ScanConversion conversion(polar, conversionGridOf(polar, 0.9));
        const auto add = [&](const Voxels& voxels) {
            const auto converted = conversion.convert(voxels);
            std::visit(
                [&](const auto& values) {
                    all[named.name + std::to_string(sizeof values[0])] = {reinterpret_cast<const char*>(values.data()),
                                                                          values.size() * sizeof values[0]};
                },
                *converted);
        };
        add(sampledValues<std::uint8_t>(polar, smoothAt));
        add(sampledValues<std::uint16_t>(polar, [](const Vec3& mm) { return 300 * smoothAt(mm); }));
        add(sampledValues<float>(polar, smoothAt));
    }
    return all;
}

/// How many voxels of a probe lie between the last two planes.
std::size_t voxelsBeforeTheLastPlane(const PolarGeometry& polar) {
    std::size_t count = 0;
    forEachVoxel(conversionGridOf(polar, 0.9), [&](std::size_t, const Vec3& mm) {
        const auto index = polarFromProbeMm(polar, mm);
        count += index && (*index)[2] >= static_cast<double>(polar.size()[2] - 2) ? 1 : 0;
    });
    return count;
}

TEST(ScanConversionTargets, EveryInstructionSetGivesTheSameBits) {
    for (const auto& [name, polar] : everyPolar()) EXPECT_GT(voxelsBeforeTheLastPlane(polar), 100U) << name;
    std::map<std::string, std::string> expected;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        const auto converted = convertedBytes();
        hwy::SetSupportedTargetsForTest(0);
        std::printf("[  target  ] %s\n", hwy::TargetName(target));
        if (expected.empty()) expected = converted;
        for (const auto& [name, bytes] : converted)
            EXPECT_TRUE(bytes == expected.at(name)) << name << " on " << hwy::TargetName(target);
    }
    EXPECT_EQ(expected.size(), 3 * everyPolar().size());
}

}  // namespace
}  // namespace echolucent
