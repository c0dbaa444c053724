// The Python program of docs/cli-otf.md, which rebuilds a curve from its report.
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "otf_of.h"
#include "program.h"

namespace echolucent {
namespace {

/// The program, run by Python on reports of several aims, prints how far it is from the report.
TEST(OtfJson, TheProgramOfTheDocsRebuildsTheCurve) {
    const std::string page = contentsOf(ECHOLUCENT_SOURCE_DIR "/docs/cli-otf.md"), begins = "```python\n";
    const auto from = page.find(begins) + begins.size();
    const Folder folder;
    write(folder / "rebuild.py", page.substr(from, page.find("```", from) - from));
    for (const std::string options : {"--reading 0.1", "--reduction medium", "--aim 1 --reduction strong"}) {
        write(folder / "otf.json", otfOf(shapesFile(), options).dump());
        const std::string run =
            "python3 \"" + folder / "rebuild.py" + "\" \"" + folder / "otf.json" + "\" >\"" + folder / "error" + "\"";
        ASSERT_EQ(std::system(run.c_str()), 0) << options;
        EXPECT_LE(std::stod(contentsOf(folder / "error")), 1e-12) << options;
    }
}

}  // namespace
}  // namespace echolucent
