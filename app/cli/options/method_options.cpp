#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <utility>

#include "app/cli/options/method_options.h"
#include "app/cli/options/option_text.h"
#include "io/document/curve_file.h"
#include "processing/adaptive/method_parameters.h"
#include "processing/adaptive/method_reading.h"

namespace echolucent::cli {

namespace {

/// Short forms of parameters' options.
constexpr std::array<std::pair<std::string_view, const char*>, 1> shortOptions{{{"sigma_per_kernel_size", "--sigma"}}};

}  // namespace

void MethodOptions::addTo(CLI::App& command) {
    command
        .add_option(
            "--reading", reading,
            "Reading of the paper, which sets all that follows but what is given: published, settled, 0.1 or default")
        ->type_name("NAME")
        ->capture_default_str();
    m_initialOption =
        command.add_option("--initial", initial, "Initial function: parabolic, quartic, linear (eq. 1) or manual:FILE")
            ->type_name("NAME")
            ->capture_default_str();
    for (const auto& [row, standard] : defaultsOf(methodParameters())) {
        if (row->name == "opacity_scale") {  // belongs to the initial function, named beside it
            command.add_option(optionOf(row->name), opacityScale, helpOf(*row))
                ->type_name("A")
                ->default_str(wordOf(standard));
            continue;
        }
        CLI::Option& added = m_given.add(command, *row, standard);
        for (const auto& [name, shorter] : shortOptions)
            if (name == row->name) m_given.addShort(command, *row, shorter, added);
    }
    command
        .add_option("--tube-grid", tubeGrid, "Tube cores across and down the view, as --tube-columns and --tube-rows")
        ->type_name("NxM")
        ->excludes("--tube-columns")
        ->excludes("--tube-rows");
    command
        .add_option("--without-tube", withoutTubes,
                    "Tube cores that are never placed, by row * columns + column; may be given several times")
        ->type_name("N,...")
        ->delimiter(',')
        ->allow_extra_args(false);
}

Result<TubeGrid> tubeGridFrom(const std::string& text, TubeGrid grid) {
    const ParameterRange range = parameterNamed(methodParameters(), "tube_columns")->range;
    const auto counts =
        parseWholePair(text, static_cast<int>(range.least), static_cast<int>(range.largest), "--tube-grid", "15x15");
    if (!counts) return tl::unexpected<Failure>(counts.error());
    grid.columns = (*counts)[0];
    grid.rows = (*counts)[1];
    return grid;
}

Result<TubeGrid> gridWithout(const std::vector<std::int64_t>& tubes, TubeGrid grid) {
    const std::int64_t count = std::int64_t{grid.columns} * grid.rows;
    for (const std::int64_t tube : tubes)
        if (tube < 0 || tube >= count)
            return wrongUsage("--without-tube", fmt::format("must be 0 to {} in a grid of {}x{} tube cores, not {}",
                                                            count - 1, grid.columns, grid.rows, tube));
    grid.withoutTubes.assign(tubes.begin(), tubes.end());
    std::ranges::sort(grid.withoutTubes);
    grid.withoutTubes.erase(std::unique(grid.withoutTubes.begin(), grid.withoutTubes.end()), grid.withoutTubes.end());
    return grid;
}

Result<AdaptiveOtfConfig> MethodOptions::get() const {
    const auto base = methodReadingFromName(reading);
    if (!base) return wrongUsage("--reading", "is \"" + reading + "\"", "Use published, settled, 0.1 or default.");
    AdaptiveOtfConfig chosen = configOf(*base);
    if (auto overridden = m_given.override(methodParameters(), chosen); !overridden)
        return tl::unexpected<Failure>(overridden.error());
    if (!tubeGrid.empty()) {
        const auto grid = tubeGridFrom(tubeGrid, chosen.grid);
        if (!grid) return tl::unexpected<Failure>(grid.error());
        chosen.grid = *grid;
    }
    const auto without = gridWithout(withoutTubes, chosen.grid);
    if (!without) return tl::unexpected<Failure>(without.error());
    chosen.grid = *without;
    if ((m_initialOption != nullptr && m_initialOption->count() > 0) || opacityScale) {
        const auto curve = curveFromName(initial, opacityScale);
        if (!curve) return tl::unexpected<Failure>(curve.error());
        chosen.initial = *curve;
    }
    if (const std::string problem = problemOf(chosen); !problem.empty()) return wrongUsage("", problem);
    return chosen;
}

namespace {

Result<OpacityCurve> manualCurve(const std::string& path, double factor) {
    auto curve = readCurve(path);
    if (!curve) return tl::unexpected<Failure>(curve.error());
    for (CurveNode& node : curve->nodes) node.opacity *= factor;
    return OpacityCurve(*std::move(curve));
}

}  // namespace

std::string curveFileOf(const std::string& name) {
    constexpr std::string_view manual = "manual:";
    return name.starts_with(manual) ? name.substr(manual.size()) : std::string();
}

Result<OpacityCurve> curveFromName(const std::string& name, std::optional<double> opacityScale) {
    const AnyParameter& row = *parameterNamed(methodParameters(), "opacity_scale");
    if (opacityScale && !inRange(*opacityScale, row.range)) return wrongUsage(optionOf(row.name), mustBe(row));
    const double scale = opacityScale.value_or(defaultOpacityScale);
    if (name == "parabolic") return OpacityCurve(PowerCurve{2, scale});
    if (name == "quartic") return OpacityCurve(PowerCurve{4, scale});
    if (name == "linear") {
        LinearCurve linear;
        linear.slope = opacityScale.value_or(linear.slope);
        return OpacityCurve(linear);
    }
    if (const std::string file = curveFileOf(name); !file.empty()) return manualCurve(file, opacityScale.value_or(1.0));
    return wrongUsage("", "\"" + name + "\" is not an opacity curve", "Use linear, parabolic, quartic or manual:FILE.");
}

Result<std::optional<OpacityCurve>> namedCurve(const std::string& name, std::optional<double> opacityScale) {
    if (name == "adaptive") return std::optional<OpacityCurve>();
    auto curve = curveFromName(name, opacityScale);
    if (curve) return std::optional<OpacityCurve>(*std::move(curve));
    Failure failure = curve.error();
    if (failure.kind == FailureKind::wrongUsage)
        failure.remedy = "Use adaptive, linear, parabolic, quartic or manual:FILE.";
    return tl::unexpected<Failure>(std::move(failure));
}

}  // namespace echolucent::cli
