// What the real echolucent-cli reports about the OTF of a volume.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include <gtest/gtest.h>

#include "tests/cli/program.h"

namespace echolucent {

/// The OTF. Unless an option says otherwise, the voxels are used as they are, so that the OTF follows from the reported
/// tubes.
inline nlohmann::json otfOf(const std::string& volume, const std::string& options = {}) {
    const std::string reduction = options.find("--reduction") == std::string::npos ? "--reduction off " : "";
    const Outcome outcome = runProgram("otf \"" + volume + "\" --json - " + reduction + options);
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    return nlohmann::json::parse(outcome.output);
}

}  // namespace echolucent
