// Tables of parameters for the pages of docs/, and as JSON.
#pragma once

#include <string>
#include <vector>

#include "app/cli/report/report_json.h"
#include "processing/parameters/parameter.h"

namespace echolucent::cli {

/// A Markdown table: one row a parameter, in the table's order. Ends with a newline.
[[nodiscard]] std::string parameterPage(const std::vector<ParameterDefault>& rows);

/// All rows of the method, the initial function, the designers, the look and the curve's sliders, as JSON.
[[nodiscard]] std::string allParametersJson();

}  // namespace echolucent::cli
