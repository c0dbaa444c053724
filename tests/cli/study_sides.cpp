// `study sides` through the real program: what it prints and writes, and what files say of their scan planes.
#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "program.h"

namespace echolucent {
namespace {

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::string fetusDicom() { return phantomFile("sides.dcm", "--scene fetus --size 64 --seed 5"); }

TEST(StudySides, PrintsSixSidesAndWhichComesFirst) {
    const Outcome outcome = runProgram("study sides \"" + fetusDicom() + "\"");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    const auto lines = linesOf(outcome.output);
    ASSERT_GE(lines.size(), 8U) << outcome.output;
    EXPECT_NE(lines[0].find("sides.dcm: beam +z, "), std::string::npos) << lines[0];
    EXPECT_NE(lines[0].find("The file says how the scan planes lay."), std::string::npos) << lines[0];
    EXPECT_NE(lines[0].find("\"From the probe\" comes first"), std::string::npos) << lines[0];
    for (std::size_t side = 1; side <= 6; ++side) {
        EXPECT_TRUE(lines[side + 1].starts_with(std::to_string(side) + " ")) << lines[side + 1];
        EXPECT_EQ(lines[side + 1].ends_with("first"), side == 1) << lines[side + 1];
    }
    EXPECT_NE(lines[4].find("Onto the scan plane"), std::string::npos) << lines[4];
}

TEST(StudySides, WritesPicturesAndATable) {
    const Folder folder;
    const std::string walled = phantomFile("walled.mha", "--scene shapes --size 110x100x120 --seed 5 --front-wall");
    const Outcome outcome =
        runProgram("study sides \"" + walled + "\" --beam-axis +z --picture-size 24 -o \"" + folder / "s" + "\"");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    const std::string png = contentsOf(folder / "s/sides-1.png");
    ASSERT_GT(png.size(), 24U);
    const auto edgeAt = [&](std::size_t place) {
        return 256 * static_cast<unsigned char>(png[place + 2]) + static_cast<unsigned char>(png[place + 3]);
    };
    EXPECT_EQ(edgeAt(16), 6 * 24) << "the width in the PNG's header";
    EXPECT_EQ(edgeAt(20), 24);
    const auto rows = linesOf(contentsOf(folder / "s/sides.csv"));
    ASSERT_EQ(rows.size(), 7U);
    EXPECT_TRUE(rows[0].starts_with("scan,side,name,answer,front_mm,confidence,")) << rows[0];
    EXPECT_TRUE(rows[1].starts_with("walled.mha,1,From the probe,wall before fluid,")) << rows[1];
    EXPECT_TRUE(rows[1].ends_with(",1")) << "the probe's side comes first: " << rows[1];
    EXPECT_EQ(std::ranges::count_if(rows, [](const std::string& row) { return row.ends_with(",1"); }), 1);
}

TEST(StudySides, WantsSomethingToLookInto) {
    const Outcome outcome = runProgram("study sides");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.errors.find("--phantoms"), std::string::npos) << outcome.errors;
    EXPECT_EQ(runProgram("study sides --phantoms --beam-axis up").status, 2);
}

}  // namespace
}  // namespace echolucent
