#include "app/cli/report/explanation_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <span>

#include "processing/explanation/explanation_facts.h"
#include "processing/explanation/tube_factors.h"

namespace echolucent::cli {

namespace {

Json numbers(std::span<const double> values) {
    Json list = Json::array();
    for (const double value : values) list.push_back(finiteJson(value));
    return list;
}

/// Both ends; null without an index.
Json rangeJson(const IndexRange& range) {
    return range.empty() ? Json(nullptr) : Json::array({range.first, range.last});
}

Json cellJson(int cell) { return cell < 0 ? Json(nullptr) : Json(cell); }

Json factsJson(const TubeExplanation& explanation) {
    Json facts = Json::array();
    for (const ExplanationFact& fact : explanationFacts(explanation))
        facts.push_back({{"key", fact.key},
                         {"symbol", fact.symbol},
                         {"value", fact.value},
                         {"unit", fact.unit},
                         {"meaning", fact.meaning},
                         {"equation", fact.equation},
                         {"place", fact.place}});
    return facts;
}

Json cellsJson(const TubeExplanation& explanation) {
    const TubeCore& tube = explanation.tube;
    const CellsRead& cells = explanation.cells;
    return {{"size", explanation.config.cells.size},
            {"means", Json(tube.cellMeans)},
            {"tube", rangeJson(cells.tube)},
            {"prior", rangeJson(cells.prior)},
            {"low", rangeJson(cells.low)},
            {"high", rangeJson(cells.high)},
            {"slope", rangeJson(cells.slope)},
            {"surface", cellJson(tube.surfaceCell)},
            {"i_low_max", cellJson(cells.lowMaxCell)},
            {"i_high", cellJson(cells.highCell)}};
}

Json scalesJson(const TubeExplanation& explanation) {
    Json scales = Json::array();
    for (const TrackedScale& scale : explanation.scales)
        scales.push_back({{"sigma", scale.sigma ? Json(*scale.sigma) : Json(nullptr)},
                          {"function", numbers(scale.function)},
                          {"searched", rangeJson(scale.searched)},
                          {"cell", scale.cell ? Json(*scale.cell) : Json(nullptr)}});
    return scales;
}

Json rankJson(const WeightRank& rank) {
    return {{"values", numbers(rank.values)},
            {"value", rank.value ? finiteJson(*rank.value) : Json(nullptr)},
            {"rank", rank.rank},
            {"total", rank.total},
            {"weight", rank.weight}};
}

Json curveJson(const ExplainedCurve& curve) {
    return {{"opacity", numbers(curve.curve.opacities)},
            {"tubes_with_weight", curve.tubesWithWeight},
            {"trust", curve.trust},
            {"message", curve.message}};
}

Json factorsJson(const AdaptiveOtf& otf) {
    Json factors = Json::array();
    for (const TubeFactor& factor : allFactors(otf))
        factors.push_back({{"number", factor.number}, {"d", factor.d}, {"values", numbers(factor.values)}});
    return factors;
}

}  // namespace

Json explanationJson(const TubeExplanation& explanation, const AdaptiveOtf& otf) {
    Json all{{"number", explanation.number},
             {"sentence", explanationSentence(explanation)},
             {"facts", factsJson(explanation)},
             {"axis",
              {{"voxels", numbers(explanation.axis.read)},
               {"quiet_voxels", numbers(explanation.axis.shown)},
               {"slab_means", numbers(explanation.axis.slabMeans)}}},
             {"cells", cellsJson(explanation)},
             {"interface_function", Json(explanation.tube.interfaceFunction)}};
    if (std::holds_alternative<VarianceRule>(explanation.config.detection))
        all["scales"] = scalesJson(explanation);
    else
        all["contrast_cells"] = rangeJson(explanation.contrastCells);
    all["ranks"] = {{"i_low_max", rankJson(explanation.intensityRank)}, {"slope", rankJson(explanation.slopeRank)}};
    if (explanation.ramp) all["ramp"] = {{"begin", explanation.ramp->begin}, {"full", explanation.ramp->full}};
    all["curves"] = {{"initial", numbers(explanation.initial)},
                     {"full", curveJson(explanation.full)},
                     {"without", curveJson(explanation.without)},
                     {"alone", curveJson(explanation.alone)}};
    all["factors"] = factorsJson(otf);
    return all;
}

std::string summary(const TubeExplanation& explanation) {
    std::string text = explanationSentence(explanation) + "\n";
    for (const ExplanationFact& fact : explanationFacts(explanation))
        text += fmt::format("{} {}{}{}\n", fact.symbol, fact.value, fact.unit.empty() ? "" : " ", fact.unit);
    return text;
}

}  // namespace echolucent::cli
