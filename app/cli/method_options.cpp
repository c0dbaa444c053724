#include <fmt/format.h>

#include <cmath>

#include "app/cli/command.h"
#include "io/curve_file.h"
#include "processing/method_names.h"

namespace echolucent::cli {

template <typename Value>
void MethodOptions::addField(CLI::App& command, const char* option, Value AdaptiveOtfConfig::*field, const char* type,
                             const char* help) {
    const CLI::Option* added = command.add_option(option, config.*field, help)->type_name(type)->capture_default_str();
    m_overrides.push_back([added, field](const AdaptiveOtfConfig& given, AdaptiveOtfConfig& chosen) {
        if (added->count() > 0) chosen.*field = given.*field;
    });
}

namespace {

/// "mirror or circular"
template <typename Names>
std::string listed(const Names& names) {
    std::string list;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) list += i + 1 < names.size() ? ", " : " or ";
        list += names[i].name;
    }
    return list;
}

}  // namespace

template <typename Value, typename Names>
void MethodOptions::addChoice(CLI::App& command, const char* option, Value AdaptiveOtfConfig::*field,
                              const Names& names, const char* help) {
    const auto parse = [this, option, field, &names](const std::string& word) {
        const auto value = valueIn(names, word);
        if (!value) throw CLI::ValidationError(option, fmt::format("is \"{}\". Use {}", word, listed(names)));
        config.*field = *value;
    };
    const CLI::Option* added =
        command.add_option_function<std::string>(option, parse, fmt::format("{}: {}", help, listed(names)))
            ->type_name("NAME")
            ->default_str(std::string(nameIn(names, config.*field)));
    m_overrides.push_back([added, field](const AdaptiveOtfConfig& given, AdaptiveOtfConfig& chosen) {
        if (added->count() > 0) chosen.*field = given.*field;
    });
}

void MethodOptions::addTo(CLI::App& command) {
    addReading(command);
    addCurveAndGrid(command);
    addDetection(command);
    addScaleSpace(command);
}

void MethodOptions::addReading(CLI::App& command) {
    command
        .add_option(
            "--reading", reading,
            "Reading of the paper, which sets all that follows but what is given: published, settled or default")
        ->type_name("NAME")
        ->capture_default_str();
}

void MethodOptions::addCurveAndGrid(CLI::App& command) {
    m_initialOption =
        command.add_option("--initial", initial, "Initial function: parabolic, quartic, linear or manual:FILE")
            ->type_name("NAME")
            ->capture_default_str();
    command
        .add_option("--opacity-scale", opacityScale,
                    "a of the initial function: opacity at full intensity; slope for linear; factor for manual")
        ->type_name("A");
    addField(command, "--strength", &AdaptiveOtfConfig::strength, "STRENGTH",
             "T * d_max: how far all tube cores together bend the curve");
    addChoice(command, "--form", &AdaptiveOtfConfig::form, curveFormNames,
              "What the tube cores make of the initial function");
    addField(command, "--ramp-begin", &AdaptiveOtfConfig::rampBegin, "SHARE",
             "Ramp: clear up to this share of the way from I_L to I_H");
    addField(command, "--clear-spreads", &AdaptiveOtfConfig::clearSpreads, "SIGMAS",
             "Ramp: ... and up to so many standard deviations of the fluid's voxels above I_L");
    addField(command, "--ramp-end", &AdaptiveOtfConfig::rampEnd, "SHARE", "Ramp: full from this share on");
    addField(command, "--ramp-opacity", &AdaptiveOtfConfig::rampOpacity, "A",
             "Ramp: opacity where all tubes say surface");
    addField(command, "--trusted-share", &AdaptiveOtfConfig::trustedShare, "SHARE",
             "Ramp: share of weighted tube cores from which the initial function has no say");
    command.add_option("--tube-grid", tubeGrid, "Tube cores across and down the view (default 15x15)")
        ->type_name("NxM");
    addField(command, "--tube-spacing", &AdaptiveOtfConfig::tubeSpacing, "UNITS",
             "Units (smallest spacing) between tube cores; 0: automatic");
    addField(command, "--cell-size", &AdaptiveOtfConfig::cellSize, "UNITS", "Edge of a cell, units, 2 to 32");
    addField(command, "--cell-stride", &AdaptiveOtfConfig::cellStride, "UNITS", "Units between the cells looked at");
    addChoice(command, "--sampling", &AdaptiveOtfConfig::sampling, tubeSamplingNames, "Samples that lie on no voxel");
    addChoice(command, "--precision", &AdaptiveOtfConfig::precision, precisionNames,
              "Arithmetic of samples, moments and interface function");
}

void MethodOptions::addDetection(CLI::App& command) {
    addChoice(command, "--interface-function", &AdaptiveOtfConfig::interfaceFunction, interfaceFunctionNames,
              "What tells tissue from fluid along a tube core");
    addField(command, "--significance", &AdaptiveOtfConfig::significance, "SHARE",
             "A maximum counts from this share of the largest value");
    addField(command, "--floor-quantile", &AdaptiveOtfConfig::floorQuantile, "SHARE",
             "Taken off the interface function before tracking; 0: nothing");
    addField(command, "--tracking-range", &AdaptiveOtfConfig::trackingRangeSigmas, "SIGMAS",
             "How far around a maximum the next scale looks; 0: from valley to valley");
    addChoice(command, "--coarsest-maximum", &AdaptiveOtfConfig::coarsestMustHaveMaximum, coarsestMaximumNames,
              "Which scale tracking may begin at, the coarsest only or any");
    addChoice(command, "--prior-cells", &AdaptiveOtfConfig::priorCellsMayOverlap, priorCellNames,
              "Cells prior to the surface cell");
    addField(command, "--slope-half-step", &AdaptiveOtfConfig::slopeHalfStep, "UNITS",
             "Slope: central difference over +- this many units");
    addField(command, "--least-edge-to-noise", &AdaptiveOtfConfig::leastEdgeToNoise, "RATIO",
             "Weaker surfaces weigh nothing; 0: no test");
    addField(command, "--low-reach", &AdaptiveOtfConfig::lowReach, "UNITS",
             "I_L: mean over so many of the last prior cells; 0: over all of them");
    addField(command, "--high-reach", &AdaptiveOtfConfig::highReach, "UNITS",
             "I_H: largest cell mean up to so many units behind the surface; 0: at the surface");
    addField(command, "--false-alarm", &AdaptiveOtfConfig::falseAlarm, "SIGMAS",
             "Ratio: least contrast, in standard deviations of the contrast where nothing is");
    addField(command, "--rank-bins", &AdaptiveOtfConfig::rankBins, "N",
             "Bins of the weights' histograms; 0: exact ranks");
}

void MethodOptions::addScaleSpace(CLI::App& command) {
    addField(command, "--coarsest-scale", &AdaptiveOtfConfig::coarsestScale, "N",
             "Gaussian kernels of size 2^n from n = this ...");
    addField(command, "--finest-scale", &AdaptiveOtfConfig::finestScale, "N", "... down to n = this");
    addField(command, "--sigma", &AdaptiveOtfConfig::sigmaPerKernelSize, "SHARE",
             "Standard deviation of a kernel, in kernel sizes");
    addField(command, "--kernel-cut", &AdaptiveOtfConfig::kernelCut, "SIGMAS",
             "Kernels end at this many standard deviations");
    addChoice(command, "--kernel-end", &AdaptiveOtfConfig::kernelEndsAtZero, kernelEndNames,
              "Kernels lowered to end at zero, or cut");
    addChoice(command, "--border", &AdaptiveOtfConfig::border, tubeBorderNames,
              "Beyond a tube core's ends: mirrored in front and zero behind, or the other end");
    addChoice(command, "--smoothing-route", &AdaptiveOtfConfig::smoothing, smoothingRouteNames,
              "How the interface function is smoothed");
}

Result<AdaptiveOtfConfig> MethodOptions::get() const {
    const auto base = methodReadingFromName(reading);
    if (!base)
        return fail(FailureKind::wrongUsage, "", "--reading", "is \"" + reading + "\"",
                    "Use published, settled or default.");
    AdaptiveOtfConfig chosen = configOf(*base);
    for (const Override& override : m_overrides) override(config, chosen);
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
    if (m_initialOption->count() > 0 || opacityScale) {
        const auto curve = curveFromName(initial, opacityScale);
        if (!curve) return tl::unexpected<Failure>(curve.error());
        chosen.initial = *curve;
    }
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

std::string curveFileOf(const std::string& name) {
    constexpr std::string_view manual = "manual:";
    return name.starts_with(manual) ? name.substr(manual.size()) : std::string();
}

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
    if (const std::string file = curveFileOf(name); !file.empty()) return manualCurve(file, opacityScale.value_or(1.0));
    return fail(FailureKind::wrongUsage, "", "", "\"" + name + "\" is not an opacity curve",
                "Use linear, parabolic, quartic or manual:FILE.");
}

}  // namespace echolucent::cli
