#include <string>
#include <vector>

#include "program.h"

namespace echolucent {
namespace {

TEST(Render, WritesAPictureOfTheAskedSizeThatDependsOnTheCurve) {
    const Folder folder;
    std::vector<std::string> pictures;
    for (const std::string otf : {"linear", "parabolic", "quartic", "adaptive"}) {
        const std::string path = folder / (otf + ".png");
        const Outcome outcome =
            runProgram("render \"" + shapesFile() + "\" --otf " + otf + " --size 64x48 -o \"" + path + "\"");
        ASSERT_EQ(outcome.status, 0) << outcome.errors;
        pictures.push_back(contentsOf(path));
        ASSERT_EQ(pictures.back().substr(0, 8), "\x89PNG\r\n\x1a\n");
        EXPECT_EQ(pictures.back().substr(16, 8), std::string("\0\0\0\x40\0\0\0\x30", 8)) << "width and height";
        for (std::size_t i = 0; i + 1 < pictures.size(); ++i) EXPECT_NE(pictures[i], pictures.back()) << otf;
    }
}

TEST(Render, SaysWhatItCannotDo) {
    const Folder folder;
    EXPECT_EQ(runProgram("render \"" + shapesFile() + "\" --otf nonsense -o \"" + folder / "p.png" + "\"").status, 2);
    EXPECT_EQ(runProgram("render \"" + folder / "missing.mha" + "\" -o \"" + folder / "p.png" + "\"").status, 3);
    EXPECT_EQ(runProgram("render \"" + shapesFile() + "\" --size 16x16 -o \"" + folder / "none/p.png" + "\"").status,
              4);
}

}  // namespace
}  // namespace echolucent
