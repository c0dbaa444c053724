// The real program's `parameters`, and the page of docs/ that holds what it prints.
#include "tests/cli/program.h"

namespace echolucent {
namespace {

TEST(Parameters, ThePageHoldsWhatTheProgramPrints) {
    const Outcome outcome = runProgram("parameters");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_NE(outcome.output.find("| `--cell-size` |"), std::string::npos);
    const std::string page = contentsOf(std::string(ECHOLUCENT_SOURCE_DIR) + "/docs/cli-otf.md");
    EXPECT_NE(page.find("-->\n" + outcome.output + "<!-- End of the table. -->"), std::string::npos)
        << "put what `echolucent-cli parameters` prints into docs/cli-otf.md";
}

}  // namespace
}  // namespace echolucent
