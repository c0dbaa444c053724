#include "processing/explanation/explanation_facts.h"

#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

#include "processing/parameters/parameter.h"

namespace echolucent {

namespace {

/// With three significant digits, as a person reads it.
std::string shortText(double value) {
    if (value == 0.0 || !std::isfinite(value)) return textOf(value == 0.0 ? 0.0 : value);
    const double step = std::pow(10.0, 2.0 - std::floor(std::log10(std::abs(value))));
    return textOf(std::round(value * step) / step);
}
std::string shortText(const std::optional<double>& value) { return value ? shortText(*value) : "none"; }

/// Builds the rows of one explanation.
class Rows {
public:
    explicit Rows(const TubeExplanation& explained)
        : m_of(explained), m_tube(explained.tube), m_found(explained.tube.status == TubeStatus::surface) {}

    std::vector<ExplanationFact> all() {
        addPlace();
        addIntensities();
        addTest();
        addWeights();
        addFactor();
        addChange();
        return std::move(m_rows);
    }

private:
    [[nodiscard]] std::string ifFound(const std::string& text) const { return m_found ? text : "none"; }
    [[nodiscard]] bool byRatio() const { return std::holds_alternative<RatioRule>(m_of.config.detection); }

    void addPlace();
    void addIntensities();
    void addTest();
    void addWeights();
    void addRank(const std::string& key, const std::string& symbol, const WeightRank& rank, const std::string& of);
    void addFactor();
    void addChange();

    const TubeExplanation& m_of;
    const TubeCore& m_tube;
    bool m_found;
    std::vector<ExplanationFact> m_rows;
};

void Rows::addPlace() {
    const int columns = m_of.config.grid.columns, number = m_of.number;
    m_rows.push_back({"number", "t", std::to_string(number), "",
                      "The tube core's number: it stands in column " + std::to_string(number % columns) + " and row " +
                          std::to_string(number / columns) + " of the grid, both counted from 0.",
                      "t = row · " + std::to_string(columns) + " + column", "Petersch 2005, section 4.1"});
    m_rows.push_back({"state", "state", std::string(nameOf(m_of.state)), "",
                      "Whether the tube core found a surface, and whether that has a weight.", "",
                      "docs/method.md, 4"});
    m_rows.push_back({"surface_cell", "s_t", ifFound(std::to_string(m_tube.surfaceCell)), "",
                      "The cell at which the surface lies, counted along the view from the first sample.", "",
                      byRatio() ? "Petersch 2005, section 4.2; docs/method.md, Detection by ratio"
                                : "Petersch 2005, section 4.1 and Fig. 4"});
}

void Rows::addIntensities() {
    const SurfaceRule& rule = m_of.config.surface;
    const bool paperLow = rule.lowReach == 0, paperHigh = rule.highReach == 0;
    const auto place = [](bool paper) {
        return std::string(paper ? "Petersch 2005, section 4.2" : "Petersch 2005, section 4.2; docs/method.md, 5");
    };
    const std::string low = paperLow
                                ? "I_L = mean I(C_i) of all prior cells"
                                : "I_L = mean I(C_i) of the last " + std::to_string(rule.lowReach) + " prior cells";
    const std::string high =
        paperHigh ? "I_H = I(C_s)" : "I_H = max I(C_i), s ≤ i ≤ s + " + std::to_string(rule.highReach);
    m_rows.push_back({"i_low", "I_L", shortText(m_tube.lowIntensity), "", "Mean intensity before the surface.", low,
                      place(paperLow)});
    m_rows.push_back({"i_high", "I_H", shortText(m_tube.highIntensity), "",
                      paperHigh ? "Mean intensity of the cell at the surface."
                                : "Largest mean intensity of a cell from the surface on: at the surface itself the "
                                  "mean is only halfway up.",
                      high, place(paperHigh)});
    if (m_of.reduction != SpeckleReduction::off) {
        const QuietInterface quiet = m_of.quiet.value_or(QuietInterface{});
        const std::string quietPlace = "docs/method.md, 7, Quiet voxels";
        m_rows.push_back({"quiet_i_low", "I_L quiet", shortText(quiet.low), "",
                          "I_L in the quiet voxels that the picture shows. The curve is made of it.", low, quietPlace});
        m_rows.push_back({"quiet_i_high", "I_H quiet", shortText(quiet.high), "",
                          "I_H in the quiet voxels that the picture shows. The curve is made of it.", high,
                          quietPlace});
    }
    m_rows.push_back({"i_low_max", "Î_L", shortText(m_tube.lowIntensityMax), "",
                      "Largest mean intensity of a prior cell. If it is high, bright tissue lies before the surface.",
                      rule.priorCellsMayOverlap ? "Î_L = max I(C_i), i < s"
                                                : "Î_L = max I(C_i), i ≤ s − " + std::to_string(m_of.config.cells.size),
                      "Petersch 2005, eq. 8"});
    m_rows.push_back({"slope", "S", shortText(m_tube.slope), "per unit", "Slope of intensity at the surface.",
                      "S = (I(C_s+h) − I(C_s−h)) / 2h, h = " + std::to_string(rule.slopeHalfStep),
                      "Petersch 2005, section 4.2"});
}

void Rows::addTest() {
    if (byRatio()) {
        const std::string place = "docs/method.md, Detection by ratio";
        m_rows.push_back({"contrast", "c", shortText(m_tube.contrast), "deviations",
                          "Contrast at the surface, in standard deviations of a slab's voxels.",
                          "c = mean behind − mean before, on the speckle's own scale", place});
        m_rows.push_back({"least_contrast", "c_min", shortText(m_of.leastContrast), "deviations",
                          "A boundary of less contrast counts for nothing. All tube cores of the view share it.", "",
                          place});
        m_rows.push_back({"fluid_intensity", "I_fluid", shortText(m_of.fluidIntensity), "",
                          "Means below this intensity count as fluid. All tube cores of the view share it.", "",
                          place});
        m_rows.push_back({"fluid_spread", "σ", shortText(m_tube.fluidSpread), "",
                          "Standard deviation of the voxels around I_L: the fluid's speckle.", "",
                          "docs/method.md, 3"});
        if (m_of.reduction != SpeckleReduction::off)
            m_rows.push_back({"quiet_fluid_spread", "σ quiet",
                              shortText(m_of.quiet ? m_of.quiet->fluidSpread : std::nullopt), "",
                              "The fluid's speckle in the quiet voxels that the picture shows.", "",
                              "docs/method.md, 7, Quiet voxels"});
        return;
    }
    const double least = std::get<VarianceRule>(m_of.config.detection).leastEdgeToNoise;
    m_rows.push_back({"edge_to_noise", "e", shortText(m_tube.edgeToNoise), "",
                      "Rise at the surface over the scatter of the prior cells' means.", "", "docs/method.md, 6"});
    m_rows.push_back({"least_edge_to_noise", "e_min", least > 0.0 ? shortText(least) : "no test", "",
                      "A surface with less edge to noise has no weight. The paper has no such test.", "",
                      "docs/method.md, 6"});
}

void Rows::addRank(const std::string& key, const std::string& symbol, const WeightRank& rank, const std::string& of) {
    const int bins = m_of.config.weights.rankBins;
    m_rows.push_back({key, symbol, ifFound(std::to_string(rank.rank) + " of " + std::to_string(rank.total)), "",
                      "How many tube cores have an equal or smaller " + of + ", of the N that meet data." +
                          (bins > 0 ? " Equal are those of one of " + std::to_string(bins) + " bins." : std::string()),
                      "", "Petersch 2005, eqs. 9 and 10"});
}

void Rows::addWeights() {
    addRank("i_low_max_rank", "rank of Î_L", m_of.intensityRank, "Î_L");
    m_rows.push_back({"w_intensity", "w_I", ifFound(shortText(m_tube.intensityWeight)), "",
                      "Weight by what lies before the surface: the darker, the more.", "w_I = 1 − rank of Î_L / N",
                      "Petersch 2005, eq. 9"});
    addRank("slope_rank", "rank of S", m_of.slopeRank, "slope above 0");
    m_rows.push_back({"w_slope", "w_S", ifFound(shortText(m_tube.slopeWeight)), "",
                      "Weight by the surface itself: the steeper, the more. 0 if S is not above 0.",
                      "w_S = rank of S / N", "Petersch 2005, eq. 10"});
    m_rows.push_back({"w_extra", "w_extra", ifFound(shortText(m_tube.extraWeight)), "",
                      byRatio() ? "0 if I_H is not above I_L, else 1."
                                : "0 if I_H is not above I_L, or the surface fails the test of edge to noise; else 1.",
                      "", "docs/method.md, 6"});
    m_rows.push_back({"tubes_meeting_volume", "N = T", std::to_string(m_of.tubesMeetingVolume), "",
                      "Tube cores that meet data.", "", "Petersch 2005, eqs. 4 and 9"});
    m_rows.push_back({"d_max", "d_max", shortText(m_of.dMax), "", "The largest weight that a tube core can have.",
                      "d_max = strength / T", "Petersch 2005, eq. 11; docs/method.md, 6"});
    m_rows.push_back({"d", "d_t", ifFound(shortText(m_tube.d)), "", "The tube core's weight in the curve.",
                      "d_t = d_max · w_I · w_S · w_extra", "Petersch 2005, eq. 11"});
    m_rows.push_back({"share_of_d", "d_t / Σd", m_of.sumOfD > 0.0 ? shortText(100.0 * m_tube.d / m_of.sumOfD) : "none",
                      m_of.sumOfD > 0.0 ? "%" : "", "The tube core's share of all weights.", "", "docs/method.md, 7"});
}

void Rows::addFactor() {
    const bool weighs = m_of.factor.has_value();
    if (std::holds_alternative<RampRule>(m_of.config.curve)) {
        const std::string place = "docs/method.md, 7";
        m_rows.push_back({"ramp_begin", "x_0", m_of.ramp ? shortText(m_of.ramp->begin) : "none", "",
                          "Up to this intensity the tube core's ramp is clear.",
                          "x_0 = I_L + max(begin · (I_H − I_L), spreads · σ)", place});
        m_rows.push_back({"ramp_full", "x_1", m_of.ramp ? shortText(m_of.ramp->full) : "none", "",
                          "From this intensity on the tube core's ramp is full.",
                          "x_1 = max(I_L + end · (I_H − I_L), x_0 + 0.3 · (I_H − I_L))", place});
        return;
    }
    m_rows.push_back({"factor_least", "f_t(I_L)", weighs ? shortText(1.0 / (1.0 + m_tube.d)) : "none", "",
                      "The factor at I_L, its least: fluid becomes clearer.", "f_t(I_L) = 1 / (1 + d_t)",
                      "Petersch 2005, eqs. 5 and 7"});
    m_rows.push_back({"factor_most", "f_t(I_H)", weighs ? shortText(1.0 + m_tube.d) : "none", "",
                      "The factor at I_H, its largest: the surface becomes more opaque.", "f_t(I_H) = 1 + d_t",
                      "Petersch 2005, eqs. 5 and 7"});
}

void Rows::addChange() {
    const std::vector<double>&full = m_of.full.curve.opacities, &without = m_of.without.curve.opacities;
    std::size_t most = 0;
    const auto changeAt = [&](std::size_t i) { return without[i] - full[i]; };
    for (std::size_t i = 0; i < full.size(); ++i)
        if (std::abs(changeAt(i)) > std::abs(changeAt(most))) most = i;
    m_rows.push_back({"change_without", "max Δα", shortText(changeAt(most)), "",
                      "The largest change of the curve if the tube core is never placed and all is computed again.",
                      "Δα = α without it − α", "docs/explain.md"});
    const bool changes = changeAt(most) != 0.0;
    m_rows.push_back({"change_without_at", "x of max Δα", changes ? shortText(AdaptiveOtf::intensityOf(most)) : "none",
                      "", "The intensity at which the curve changes most.", "", "docs/explain.md"});
}

std::string whyNoWeight(const TubeExplanation& explained) {
    const TubeCore& tube = explained.tube;
    if (!(*tube.highIntensity > *tube.lowIntensity)) return "it is not brighter at the surface than before it";
    if (tube.extraWeight == 0.0) return "the surface stands out too little from the tube core's own speckle";
    if (!(*tube.slope > 0.0)) return "the slope at the surface is not above 0";
    if (explained.dMax == 0.0) return "the strength is 0";
    return "no tube core has a brighter cell before its surface";
}

std::string whyNoSurface(const TubeExplanation& explained) {
    if (explained.cells.tube.empty()) return "too few of its voxels hold data to fill a cell";
    if (std::holds_alternative<VarianceRule>(explained.config.detection))
        return explained.tube.trackedCells.empty() ? "no local maximum of its interface function counts"
                                                   : "no complete cell lies before the maximum found";
    if (!explained.fluidIntensity) return "the view shows no boundary of fluid";
    if (explained.unreadSurface) return "no complete cell lies before the boundary found";
    const IndexRange cells = explained.contrastCells;
    const auto counts = [&](int cell) {
        return explained.tube.interfaceFunction[static_cast<std::size_t>(cell)] > explained.leastContrast.value_or(0.0);
    };
    for (int cell = cells.first; cell <= cells.last; ++cell)
        if (counts(cell)) return "no boundary of enough contrast on it leads from enough fluid to tissue";
    return "no boundary on it has a contrast above " + shortText(explained.leastContrast);
}

}  // namespace

std::vector<ExplanationFact> explanationFacts(const TubeExplanation& explanation) { return Rows(explanation).all(); }

std::string explanationSentence(const TubeExplanation& explanation) {
    const std::string name = "Tube core " + std::to_string(explanation.number);
    const std::string initial =
        explanation.surfacesWhereDataBegin
            ? " No surface of this view stands behind fluid: the curve stays the initial function."
            : "";
    switch (explanation.state) {
        case TubeState::weighs:
            return name + " found a surface at its cell " + std::to_string(explanation.tube.surfaceCell) +
                   " and weighs " + shortText(explanation.tube.d) + " of at most " + shortText(explanation.dMax) + "." +
                   initial;
        case TubeState::weighsNothing:
            return name + " found a surface at its cell " + std::to_string(explanation.tube.surfaceCell) +
                   ", but weighs nothing: " + whyNoWeight(explanation) + "." + initial;
        case TubeState::noSurface: return name + " found no surface: " + whyNoSurface(explanation) + "." + initial;
        case TubeState::outside: return name + " meets no data.";
        case TubeState::neverPlaced: return name + " is never placed.";
    }
    return {};
}

}  // namespace echolucent
