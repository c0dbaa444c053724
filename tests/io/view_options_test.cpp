// The view that the command line asks for, against that of the probe that a file states.
#include <gtest/gtest.h>
#include <CLI/CLI.hpp>

#include "app/cli/options/view_options.h"
#include "processing/beam/probe_view.h"

namespace echolucent {
namespace {

/// The view of a volume whose file states a probe that leans by 20 degrees.
Viewpoint viewWith(std::vector<std::string> arguments) {
    CLI::App program{"test"};
    cli::ViewOptions options;
    options.addTo(program);
    std::reverse(arguments.begin(), arguments.end());
    program.parse(arguments);
    VolumeGeometry geometry;
    geometry.size = {4, 4, 4};
    geometry.probe.emplace();
    geometry.probe->forward = rotationY(20) * Vec3(0, 0, 1);
    const auto view = options.get(Volume(geometry, std::vector<std::uint8_t>(64, 9)), {});
    EXPECT_TRUE(view) << view.error().sentence();
    return view.value_or(Viewpoint{});
}

TEST(ViewOptions, TheProbesViewIsTakenUnlessTheCommandLineTurnsTheView) {
    EXPECT_NEAR(viewWith({}).azimuthDegrees, 20, 1e-9);
    EXPECT_EQ(viewWith({"--view-azimuth", "0"}).azimuthDegrees, 0) << "0 degrees are an angle too";
    EXPECT_EQ(viewWith({"--view-elevation", "0"}).azimuthDegrees, 0);
    EXPECT_EQ(viewWith({"--view-azimuth", "5"}).azimuthDegrees, 5);
    EXPECT_EQ(viewWith({"--beam-axis", "+z"}).azimuthDegrees, 0);
}

}  // namespace
}  // namespace echolucent
