// What the real echolucent-cli says of the OTF of a volume.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include <gtest/gtest.h>

#include "tests/cli/program.h"

namespace echolucent {

/// The OTF, where no option says otherwise for the voxels as they are: that is what follows from the tubes it reports.
inline nlohmann::json otfOf(const std::string& volume, const std::string& options = {}) {
    const std::string reduction = options.find("--reduction") == std::string::npos ? "--reduction off " : "";
    const Outcome outcome = runProgram("otf \"" + volume + "\" --json - " + reduction + options);
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    return nlohmann::json::parse(outcome.output);
}

}  // namespace echolucent
