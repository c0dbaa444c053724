#include "processing/adaptive/method_parameters.h"

#include <array>
#include <utility>
#include <vector>

#include "processing/parameters/parameter_rows.h"
#include "processing/tube_core/cell_statistics.h"

namespace echolucent {

namespace {

namespace method_rows {

using namespace parameter_rows;
using Row = Parameter<AdaptiveOtfConfig>;

constexpr auto grid = &AdaptiveOtfConfig::grid;
constexpr auto cells = &AdaptiveOtfConfig::cells;
constexpr auto detection = &AdaptiveOtfConfig::detection;
constexpr auto surface = &AdaptiveOtfConfig::surface;
constexpr auto weights = &AdaptiveOtfConfig::weights;
constexpr auto curve = &AdaptiveOtfConfig::curve;

constexpr std::array samplings{Choice{Interpolation::trilinear, "trilinear"},
                               Choice{Interpolation::nearest, "nearest"}};
constexpr std::array precisions{Choice{Precision::single32, "single"}, Choice{Precision::double64, "double"}};
constexpr std::array borders{Choice{TubeBorder::mirrorThenZero, "mirror"}, Choice{TubeBorder::circular, "circular"}};
constexpr std::array routes{Choice{SmoothingRoute::direct, "direct"}, Choice{SmoothingRoute::fourier, "fourier"}};
constexpr std::array kernelEnds{Choice{true, "zero"}, Choice{false, "cut"}};
constexpr std::array coarsestMaxima{Choice{true, "needed"}, Choice{false, "any"}};
constexpr std::array priorCells{Choice{true, "overlapping"}, Choice{false, "apart"}};

/// How far a number's control moves in one step; a number without steps has no control in the panel.
constexpr ParameterSteps byOne{1, 0};
constexpr ParameterSteps bySteps(double step) { return {step, 2}; }

/// Sets how many tube cores lie across or down. If the number changes, each index means another tube core, so
/// TubeGrid::withoutTubes is emptied.
template <auto member>
bool setTubeCount(AdaptiveOtfConfig& config, const ParameterValue& value) {
    const int before = config.grid.*member;
    if (!setNumber<grid, member>(config, value)) return false;
    if (config.grid.*member != before) config.grid.withoutTubes.clear();
    return true;
}

template <auto member>
Row tubeCount(const Words& words) {
    Row row = number<grid, member>(words, {1, 4096}, {.steps = byOne});
    row.set = setTubeCount<member>;
    return row;
}

/// a of the initial function: a power's scale, or a linear curve's slope. Null for other curves.
template <typename Curve>
auto* scaleOf(Curve& initial) {
    auto* power = std::get_if<PowerCurve>(&initial);
    auto* linear = std::get_if<LinearCurve>(&initial);
    return power != nullptr ? &power->scale : linear != nullptr ? &linear->slope : nullptr;
}

Row opacityScale() {
    Row row = rowOf<AdaptiveOtfConfig>(
        {"opacity_scale", "Opacity scale a",
         "Opacity of the initial function at full intensity; of a linear one its slope, of a manual one a factor", "",
         "chosen by looking"},
        {.offered = ParameterRange{0, 10}, .steps = bySteps(0.05)});
    row.range = {0, 1e6};
    row.get = [](const AdaptiveOtfConfig& config) -> std::optional<ParameterValue> {
        const double* scale = scaleOf(config.initial);
        return scale == nullptr ? std::nullopt : std::optional<ParameterValue>(*scale);
    };
    row.set = [](AdaptiveOtfConfig& config, const ParameterValue& value) {
        double* scale = scaleOf(config.initial);
        const auto number = numberOf(value);
        if (scale == nullptr || !number) return false;
        *scale = *number;
        return true;
    };
    return row;
}

constexpr ParameterChoice ramp{"ramp", "Ramp"}, product{"product", "Product of basis functions"};
constexpr ParameterChoice ratio{"ratio", "Ratio of means"}, variance{"variance", "Variance in scale space"};

constexpr std::string_view published = "Petersch 2005, 4.1";
constexpr std::string_view withoutFluid =
    "scans without fluid, in which no surface may be found: docs/experiments.md, Detection by ratio";

std::vector<Row> gridAndCells() {
    return {
        tubeCount<&TubeGrid::columns>(
            {"tube_columns", "Tube columns", "Tube cores across the picture", "", "Petersch 2005, 6.1"}),
        tubeCount<&TubeGrid::rows>({"tube_rows", "Tube rows", "Tube cores down the picture", "", "Petersch 2005, 6.1"}),
        number<grid, &TubeGrid::spacing>(
            {"tube_spacing", "Tube spacing",
             "Distance of neighbouring tube cores; 0: automatic, the grid covers the volume", "units",
             "Petersch 2005, 6.1"},
            {0, 1e6}, {.offered = ParameterRange{0, 1000}, .steps = ParameterSteps{1, 1}}),
        number<cells, &CellRule::size>(
            {"cell_size", "Cell size", "Edge of the cells along a tube core", "units", published}, {2, largestCellSize},
            {.steps = byOne}),
        choice<samplings, cells, &CellRule::sampling>(
            {"sampling", "Sampling", "How samples that lie on no voxel are taken", "", "docs/cli-study.md, study otf"}),
        choice<precisions, cells, &CellRule::precision>({"precision", "Precision",
                                                         "Arithmetic of samples, moments and interface function", "",
                                                         "docs/cli-study.md, study otf"}),
    };
}

std::vector<Row> detectionByVariance() {
    std::vector<Row> rows{
        number<detection, &VarianceRule::coarsestScale>(
            {"coarsest_scale", "Coarsest scale",
             "The widest kernel in which a surface is looked for has a size of 2 to this power, in units", "",
             published},
            {0, 10}, {.offered = ParameterRange{1, 10}, .steps = byOne}),
        number<detection, &VarianceRule::finestScale>(
            {"finest_scale", "Finest scale",
             "The narrowest kernel to which a surface is followed has a size of 2 to this power, in units", "",
             published},
            {0, 10}, {.offered = ParameterRange{1, 10}, .steps = byOne}),
        number<detection, &VarianceRule::sigmaPerKernelSize>(
            {"sigma_per_kernel_size", "Sigma", "Standard deviation of a kernel, as a share of its size", "kernel sizes",
             "docs/experiments.md, What the paper leaves open"},
            {0.01, 4}),
        number<detection, &VarianceRule::kernelCut>(
            {"kernel_cut", "Kernel cut", "Kernels end at this many standard deviations and are renormalised",
             "standard deviations", "docs/experiments.md, What the paper leaves open"},
            {0.5, 10}),
        choice<kernelEnds, detection, &VarianceRule::kernelEndsAtZero>(
            {"kernel_end", "Kernel end", "Kernels are lowered so that they end at zero, or they are cut", "",
             "docs/experiments.md, What the paper leaves open"}),
        choice<borders, detection, &VarianceRule::border>(
            {"border", "Border", "Beyond a tube core's ends: mirrored in front and zero behind, or the other end", "",
             "docs/experiments.md, What the paper leaves open"}),
        choice<routes, detection, &VarianceRule::smoothing>(
            {"smoothing_route", "Smoothing route",
             "How the interface function is smoothed: sums of products, or a Fourier transform", "",
             "docs/experiments.md, What the paper leaves open"}),
        number<detection, &VarianceRule::significance>(
            {"significance", "Significance", "A local maximum counts from this share of the largest value in its range",
             "share", "docs/experiments.md, What the paper leaves open"},
            {0, 1}, {.steps = bySteps(0.05)}),
        number<detection, &VarianceRule::floorQuantile>(
            {"floor_quantile", "Floor quantile",
             "This quantile of a tube's interface function is taken off before tracking; 0: nothing is", "share",
             "docs/experiments.md, Three readings"},
            {0, 1}),
        number<detection, &VarianceRule::trackingRangeSigmas>(
            {"tracking_range", "Tracking range",
             "How far around a maximum the next scale looks; 0: from valley to valley", "standard deviations",
             "docs/experiments.md, What the paper leaves open"},
            {0, 1000}),
        choice<coarsestMaxima, detection, &VarianceRule::coarsestMustHaveMaximum>(
            {"coarsest_maximum", "Coarsest maximum",
             "Needed: there is no surface without a maximum at the coarsest scale; any: tracking begins at the "
             "coarsest scale that has one",
             "", "docs/experiments.md, Three readings"}),
        number<detection, &VarianceRule::leastEdgeToNoise>(
            {"least_edge_to_noise", "Least edge to noise",
             "A surface that stands out less from its tube's own speckle weighs nothing; 0: there is no test", "",
             "docs/experiments.md, Three readings"},
            {0, 1e6}),
    };
    return within({"interface_function", variance.name}, std::move(rows));
}

std::vector<Row> detectionByRatio() {
    constexpr ParameterRange slabs{1, 1000};
    std::vector<Row> rows{
        number<detection, &RatioRule::falseAlarm>(
            {"false_alarm", "Least contrast",
             "A surface counts from this contrast on, in standard deviations of the "
             "contrast where there is no boundary",
             "standard deviations", "docs/experiments.md, Detection by ratio"},
            {0, 1e6}, {.offered = ParameterRange{0, 20}, .steps = bySteps(0.25)}),
        number<detection, &RatioRule::contrastFloor>(
            {"contrast_floor", "Contrast floor", "The least contrast of a surface is never below this",
             "standard deviations of voxels",
             "docs/experiments.md, Detection by ratio: figures of other values were not kept"},
            {0, 1e6}),
        number<detection, &RatioRule::contrastCeiling>(
            {"contrast_ceiling", "Contrast ceiling", "The least contrast of a surface is never above this",
             "standard deviations of voxels",
             "docs/experiments.md, Detection by ratio: figures of other values were not kept"},
            {0, 1e6}),
        number<detection, &RatioRule::slabsBefore>(
            {"slabs_before", "Slabs before", "Slabs averaged before a boundary", "units",
             "docs/experiments.md, Detection by ratio: windows of 5 and 8, or 8 and 12, are within half "
             "a point"},
            slabs),
        number<detection, &RatioRule::slabsBehind>(
            {"slabs_behind", "Slabs behind", "Slabs averaged behind a boundary", "units",
             "docs/experiments.md, Detection by ratio: windows of 5 and 8, or 8 and 12, are within half "
             "a point"},
            slabs),
        number<detection, &RatioRule::rampSlabs>(
            {"ramp_slabs", "Ramp slabs", "Slabs on each side of a boundary that may lie on its ramp", "units",
             "docs/experiments.md, Detection by ratio"},
            {0, 1000}),
        number<detection, &RatioRule::leastFluid>(
            {"least_fluid", "Least fluid", "Slabs of fluid that must lie before a surface", "units",
             "docs/experiments.md, Detection by ratio"},
            slabs),
        number<detection, &RatioRule::leastDark>(
            {"least_dark", "Least dark", "Slabs before a surface that must be darker than the fluid level", "units",
             withoutFluid},
            {0, 1000}),
        number<detection, &RatioRule::leastStep>(
            {"least_step", "Least step", "A surface rises by at least this share of the view's bright mean", "share",
             withoutFluid},
            {0, 1}),
        number<detection, &RatioRule::certainty>(
            {"certainty", "Certainty",
             "A contrast of this many standard deviations is no accident even among "
             "thousands of boundaries",
             "standard deviations", withoutFluid},
            {0, 1e6}),
        number<detection, &RatioRule::certainShare>(
            {"certain_share", "Certain share",
             "A view holds surfaces only if this share of its tube cores, at least one, "
             "holds a certain contrast",
             "share", withoutFluid},
            {0, 1}),
        number<detection, &RatioRule::leastRatio>(
            {"least_ratio", "Least ratio",
             "Where echo is not compressed, tissue must typically be this many times as "
             "bright as fluid",
             "", withoutFluid},
            {1, 1000}),
    };
    return within({"interface_function", ratio.name}, std::move(rows));
}

std::vector<Row> surfacesAndWeights() {
    return {
        number<surface, &SurfaceRule::lowReach>(
            {"low_reach", "Low reach", "I_L is the mean over this many of the last prior cells; 0: over all of them",
             "units", "docs/method.md, 5. Read I_L, I_H and the slope; 0: Petersch 2005, 4.1"},
            {0, 1000}),
        number<surface, &SurfaceRule::highReach>(
            {"high_reach", "High reach",
             "I_H is the largest cell mean up to this far behind the surface; 0: the mean at the surface", "units",
             "docs/method.md, 5. Read I_L, I_H and the slope; 0: Petersch 2005, 4.1"},
            {0, 1000}),
        number<surface, &SurfaceRule::slopeHalfStep>(
            {"slope_half_step", "Slope half step",
             "The slope at a surface is a central difference over this far to either side", "units",
             "docs/experiments.md, What the paper leaves open"},
            {1, 1000}, {.offered = ParameterRange{1, 32}, .steps = byOne}),
        choice<priorCells, surface, &SurfaceRule::priorCellsMayOverlap>(
            {"prior_cells", "Prior cells",
             "Apart: cells that end before the surface cell; overlapping: all that begin before it", "",
             "docs/experiments.md, What the paper leaves open; overlapping: Petersch 2005, eq. 8"}),
        number<weights, &WeightRule::rankBins>(
            {"rank_bins", "Rank bins",
             "Bins of the histograms of eqs. 9 and 10, from 0 to the largest value; 0: exact "
             "ranks",
             "", "docs/experiments.md, What the paper leaves open"},
            {0, 1 << 20}),
    };
}

constexpr std::string_view triedCurves = "docs/experiments.md, The curve";

Row detectionRule() {
    return alternative<detection, RatioRule, ratio, VarianceRule, variance>(
        {"interface_function", "Interface function",
         "What tells tissue from fluid along a tube core. Ratio: how much brighter it is behind than before, which "
         "speckle does not disturb; variance: how much its cells vary, as published, with a surface at the first "
         "significant "
         "local maximum, tracked from coarse to fine scales",
         "", "docs/experiments.md, Detection by ratio"});
}

Row curveRule() {
    return alternative<curve, RampRule, ramp, ProductRule, product>(
        {"form", "Form",
         "Ramp: rises from ramp begin to ramp end about each surface's intensity, averaged over the tube cores; "
         "product: the initial function times one basis function for each tube core, as published with eq. 5 mended",
         "", triedCurves});
}

std::vector<Row> curveByProduct() {
    std::vector<Row> rows{number<curve, &ProductRule::strength>(
        {"strength", "Strength", "How far the found surfaces bend the initial function: T times d_max", "",
         "docs/experiments.md, What the paper leaves open: d_max 0.03 at 225 tube cores"},
        {0, 1e12}, {.offered = ParameterRange{0, 40}, .steps = bySteps(0.25)})};
    return within({"form", product.name}, std::move(rows));
}

std::vector<Row> curveByRamp() {
    std::vector<Row> rows{
        number<curve, &RampRule::begin>(
            {"ramp_begin", "Ramp begin", "An intensity is clear up to this share of the way from I_L to I_H", "share",
             triedCurves},
            {-10, 10}),
        number<curve, &RampRule::clearSpreads>(
            {"clear_spreads", "Clear spreads",
             "An intensity is clear up to this far above I_L, in deviations of the fluid's own voxels",
             "standard deviations", triedCurves},
            {0, 1000}),
        number<curve, &RampRule::end>(
            {"ramp_end", "Ramp end", "The ramp is full from this share of the way from I_L to I_H on", "share",
             triedCurves},
            {-9.999, 20}),
        number<curve, &RampRule::opacity>({"ramp_opacity", "Opacity", "Opacity where all tube cores say surface",
                                           "opacity per unit length", triedCurves},
                                          {1e-6, 1}, {.offered = ParameterRange{0.01, 1}, .steps = bySteps(0.01)}),
        number<curve, &RampRule::aim>(
            {"aim", "Aim", "0: bright surfaces alone; 1: every wall that the tube cores found, at its place", "share",
             "docs/experiments.md, The aim"},
            {0, 1}),
        number<curve, &RampRule::trustedShare>(
            {"trusted_share", "Trusted share",
             "Share of the tube cores that must have a weight for the initial function to "
             "have no say",
             "share", "no experiment on record; docs/method.md, 7. Curve"},
            {0, 1}),
    };
    return within({"form", ramp.name}, std::move(rows));
}

std::vector<Row> allRows() {
    std::vector<Row> all;
    const auto append = [&](const std::vector<Row>& rows) { all.insert(all.end(), rows.begin(), rows.end()); };
    append(gridAndCells());
    append({detectionRule()});
    append(detectionByVariance());
    append(detectionByRatio());
    append(surfacesAndWeights());
    append({curveRule()});
    append(curveByProduct());
    append(curveByRamp());
    append({opacityScale()});
    // The panel offers only the choices of rules and the parameters with steps, because all parameters would be too
    // many.
    for (Row& row : all) row.inPanels = row.steps.has_value() || row.name == "form" || row.name == "interface_function";
    return all;
}

}  // namespace method_rows

/// What is wrong with the list of tube cores that are never placed; empty if nothing is.
std::string problemWithLeftOut(const TubeGrid& grid) {
    const std::vector<int>& left = grid.withoutTubes;
    const int count = grid.columns * grid.rows;
    for (std::size_t i = 0; i < left.size(); ++i) {
        if (left[i] < 0 || left[i] >= count)
            return "the tube cores that are never placed must be 0 to " + std::to_string(count - 1) + ", not " +
                   std::to_string(left[i]);
        if (i > 0 && left[i] <= left[i - 1])
            return "the tube cores that are never placed must ascend, and each must stand there once";
    }
    return {};
}

/// What is wrong although each parameter is in its range; empty if nothing is.
std::string problemBetweenRows(const AdaptiveOtfConfig& config) {
    if (config.grid.columns * config.grid.rows > mostTubeCores)
        return "the tube grid must have at most " + std::to_string(mostTubeCores) + " tube cores";
    if (std::string problem = problemWithLeftOut(config.grid); !problem.empty()) return problem;
    if (const auto* variance = std::get_if<VarianceRule>(&config.detection))
        if (variance->finestScale > variance->coarsestScale)
            return "the coarsest of the scales must not be below the finest scale";
    if (const auto* ratio = std::get_if<RatioRule>(&config.detection))
        if (ratio->contrastFloor > ratio->contrastCeiling)
            return "the contrast floor must not be above the contrast ceiling";
    if (const auto* ramp = std::get_if<RampRule>(&config.curve))
        if (!(ramp->end >= ramp->begin + 1e-3)) return "the ramp must end at least 0.001 behind where it begins";
    return {};
}

}  // namespace

const ParameterTable<AdaptiveOtfConfig>& methodParameters() {
    static const ParameterTable<AdaptiveOtfConfig> table{method_rows::allRows(), {}, problemBetweenRows};
    return table;
}

std::string problemOf(const AdaptiveOtfConfig& config) { return problemIn(methodParameters(), config); }

}  // namespace echolucent
