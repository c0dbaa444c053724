#include "app/cli/reduction_option.h"

#include <CLI/CLI.hpp>

#include "app/cli/option_text.h"

namespace echolucent::cli {

namespace {
std::string names() { return listed({speckleReductionNames.begin(), speckleReductionNames.end()}); }
}  // namespace

void ReductionOption::addTo(CLI::App& command, const std::string& what) {
    command.add_option("--reduction", name, what + ": " + names())->type_name("NAME")->capture_default_str();
}

Result<SpeckleReduction> ReductionOption::get() const {
    const auto reduction = speckleReductionFromName(name);
    if (!reduction)
        return fail(FailureKind::wrongUsage, "", "--reduction", "is \"" + name + "\"", "Use " + names() + ".");
    return *reduction;
}

}  // namespace echolucent::cli
