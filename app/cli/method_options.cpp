#include <cmath>

#include "app/cli/command.h"
#include "io/curve_file.h"

namespace echolucent::cli {

void MethodOptions::addTo(CLI::App& command) {
    command.add_option("--initial", initial, "Initial function: parabolic, quartic, linear or manual:FILE")
        ->type_name("NAME")
        ->capture_default_str();
    command
        .add_option("--opacity-scale", opacityScale,
                    "a of the initial function: opacity at full intensity; slope for linear; factor for manual")
        ->type_name("A");
    command.add_option("--tube-grid", tubeGrid, "Tube cores across and down the view (default 15x15)")
        ->type_name("NxM");
    command
        .add_option("--tube-spacing", config.tubeSpacing, "Units (smallest spacing) between tube cores; 0: automatic")
        ->type_name("UNITS")
        ->capture_default_str();
    command.add_option("--cell-size", config.cellSize, "Edge of a cell, units, 2 to 32")
        ->type_name("UNITS")
        ->capture_default_str();
    command.add_option("--strength", config.strength, "T * d_max: how far all tube cores together bend the curve")
        ->type_name("STRENGTH")
        ->capture_default_str();
    command.add_option("--coarsest-scale", config.coarsestScale, "Gaussian kernels of size 2^n from n = this ...")
        ->type_name("N")
        ->capture_default_str();
    command.add_option("--finest-scale", config.finestScale, "... down to n = this")
        ->type_name("N")
        ->capture_default_str();
    command.add_option("--sigma", config.sigmaPerKernelSize, "Standard deviation of a kernel, in kernel sizes")
        ->type_name("SHARE")
        ->capture_default_str();
    command.add_option("--kernel-cut", config.kernelCut, "Kernels end at this many standard deviations")
        ->type_name("SIGMAS")
        ->capture_default_str();
    command.add_option("--significance", config.significance, "A maximum counts from this share of the largest value")
        ->type_name("SHARE")
        ->capture_default_str();
    command
        .add_option("--floor-quantile", config.floorQuantile,
                    "Taken off the interface function before tracking; 0: nothing")
        ->type_name("SHARE")
        ->capture_default_str();
    command.add_option("--least-edge-to-noise", config.leastEdgeToNoise, "Weaker surfaces weigh nothing; 0: no test")
        ->type_name("RATIO")
        ->capture_default_str();
    command.add_option("--slope-half-step", config.slopeHalfStep, "Slope: central difference over +- this many units")
        ->type_name("UNITS")
        ->capture_default_str();
}

Result<AdaptiveOtfConfig> MethodOptions::get() const {
    AdaptiveOtfConfig chosen = config;
    if (!tubeGrid.empty()) {
        const auto grid = parseNumbers(tubeGrid, 2, "--tube-grid");
        if (!grid) return tl::unexpected<Failure>(grid.error());
        for (const double count : *grid)
            if (!(count >= 1 && count <= 4096) || count != std::floor(count))
                return fail(FailureKind::wrongUsage, "", "--tube-grid", "must be two whole numbers from 1 to 4096",
                            "Write it as 15x15.");
        chosen.tubeColumns = static_cast<int>((*grid)[0]);
        chosen.tubeRows = static_cast<int>((*grid)[1]);
    }
    const auto curve = curveFromName(initial, opacityScale);
    if (!curve) return tl::unexpected<Failure>(curve.error());
    chosen.initial = *curve;
    if (const std::string problem = problemOf(chosen); !problem.empty())
        return fail(FailureKind::wrongUsage, "", "", problem);
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

Result<OpacityCurve> curveFromName(const std::string& name, std::optional<double> opacityScale) {
    if (opacityScale && !(*opacityScale >= 0.0 && *opacityScale <= 1e6))
        return fail(FailureKind::wrongUsage, "", "--opacity-scale", "must be 0 to 1000000");
    const double scale = opacityScale.value_or(defaultOpacityScale);
    if (name == "parabolic") return OpacityCurve(PowerCurve{2, scale});
    if (name == "quartic") return OpacityCurve(PowerCurve{4, scale});
    if (name == "linear") {
        LinearCurve linear;
        linear.slope = opacityScale.value_or(linear.slope);
        return OpacityCurve(linear);
    }
    constexpr std::string_view manual = "manual:";
    if (name.starts_with(manual) && name.size() > manual.size())
        return manualCurve(name.substr(manual.size()), opacityScale.value_or(1.0));
    return fail(FailureKind::wrongUsage, "", "", "\"" + name + "\" is not an opacity curve",
                "Use linear, parabolic, quartic or manual:FILE.");
}

}  // namespace echolucent::cli
