// Tables of parameters as pages of docs/ have them, and as JSON.
#pragma once

#include <string>
#include <vector>

#include "app/cli/report/report_json.h"
#include "processing/parameters/parameter.h"

namespace echolucent::cli {

/// A value as people write it on the command line.
[[nodiscard]] std::string wordOf(const ParameterValue& value);

/// One row a parameter, in the table's order, as a table in Markdown; ends with a newline.
[[nodiscard]] std::string parameterPage(const std::vector<ParameterDefault>& rows);

/// Every row of the method, of each designer, of the look and of what else a person sets, with all that it says.
[[nodiscard]] std::string allParametersJson();

}  // namespace echolucent::cli
