#include <nlohmann/json.hpp>
#include <string>

#include "program.h"

namespace echolucent {
namespace {

TEST(LongBench, ReportsBothViewsAndASweep) {
    const Outcome outcome = runProgram("bench otf \"" + shapesFile() + "\" --runs 1 --json - --threads 2");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    const auto report = nlohmann::json::parse(outcome.output);
    for (const std::string view : {"axis", "oblique"}) {
        for (const std::string key : {"total_ms", "touch_ms"}) EXPECT_GT(report[view][key].get<double>(), 0.0) << key;
        for (const std::string stage : {"sampling", "cells", "detection", "weights", "curve"})
            EXPECT_GE(report[view]["stages_ms"][stage].get<double>(), 0.0) << stage;
    }
    EXPECT_EQ(report["axis"]["azimuth"], 0.0);
    EXPECT_EQ(report["oblique"]["azimuth"], 20.0);
    EXPECT_EQ(report["sweep_views"], 91);
    EXPECT_GT(report["sweep_s"].get<double>(), 0.0);
}

TEST(Bench, NeedsAStage) { EXPECT_EQ(runProgram("bench").status, 2); }

}  // namespace
}  // namespace echolucent
