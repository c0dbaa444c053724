#include "io/document/curve_file.h"

#include <nlohmann/json.hpp>

#include "io/files/input_file.h"
#include "io/json/json_values.h"
#include "io/output/atomic_file.h"

namespace echolucent {

namespace {

constexpr const char* remedyOfCurve = "Correct the file, or save the curve again from the program.";

}  // namespace

Result<ManualCurve> readCurve(const std::string& path) {
    const auto text = readWholeFile(path, std::size_t{1} << 20);
    if (!text) return tl::unexpected(text.error());
    const auto object = jsonObject(*text, path, curveFormatName.data(), remedyOfCurve);
    if (!object) return tl::unexpected(object.error());
    JsonProblems problems{path, std::nullopt};
    JsonFields fields(*object, {}, problems);
    ManualCurve curve = manualCurveIn(fields, "nodes");
    if (problems.first) return problems.refused(remedyOfCurve);
    return curve;
}

Result<void> writeCurve(const std::string& path, const ManualCurve& curve) {
    const nlohmann::ordered_json object{{"format", curveFormatName}, {"version", 1}, {"nodes", manualCurveJson(curve)}};
    return writeFileAtomically(path, object.dump(2) + "\n", OutputKind::curve);
}

}  // namespace echolucent
