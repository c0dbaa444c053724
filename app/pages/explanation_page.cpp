#include "app/pages/explanation_page.h"

#include <fmt/format.h>

#include <utility>
#include <variant>

#include "app/pages/html_page.h"
#include "processing/adaptive/method_parameters.h"
#include "processing/adaptive/method_reading.h"
#include "processing/explanation/explanation_facts.h"
#include "processing/explanation/explanation_plots.h"
#include "processing/parameters/parameter.h"

namespace echolucent {

namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string turnText(const Viewpoint& view) {
    std::string text = fmt::format("along {}", nameOf(view.beamAxis));
    if (view.azimuthDegrees != 0.0 || view.elevationDegrees != 0.0)
        text +=
            fmt::format(", turned by {} and {} degrees", textOf(view.azimuthDegrees), textOf(view.elevationDegrees));
    if (view.rollDegrees != 0.0) text += fmt::format(", rolled by {} degrees", textOf(view.rollDegrees));
    return text;
}

std::string frontText(const Viewpoint& view) {
    if (view.cutSurface) return "bowed";
    return view.frontPlane ? textOf(frontDepthMm(view)) + " mm behind the volume's foremost point" : "none";
}

std::string boxText(const OrientedBox& box) {
    const Vec3 &size = box.sizeMm, &centre = box.centreMm;
    return fmt::format("{:.1f} x {:.1f} x {:.1f} mm around ({:.1f}, {:.1f}, {:.1f}) mm of the grid", size[0], size[1],
                       size[2], centre[0], centre[1], centre[2]);
}

std::string initialText(const OpacityCurve& initial) {
    if (const auto* power = std::get_if<PowerCurve>(&initial))
        return fmt::format("a x^{}, a = {}", power->exponent, textOf(power->scale));
    if (const auto* linear = std::get_if<LinearCurve>(&initial))
        return fmt::format("a (x - L_L) from L_L to L_H, a = {}, L_L = {:.3f}, L_H = {:.3f}", textOf(linear->slope),
                           linear->lower, linear->upper);
    if (const auto* manual = std::get_if<ManualCurve>(&initial))
        return fmt::format("{} nodes of a person", manual->nodes.size());
    return fmt::format("{} samples", std::get<SampledCurve>(initial).opacities.size());
}

Rows madeWithRows(const ExplanationPage& page, const TubeExplanation& explanation, const AdaptiveOtf& otf) {
    const auto reading = readingOf(otf.config);
    Rows rows;
    if (!page.scan.empty()) rows.push_back({"Scan", page.scan});
    if (page.phases > 1) rows.push_back({"Phase", fmt::format("{} of {}", page.phase + 1, page.phases)});
    rows.push_back({"View", turnText(otf.view)});
    rows.push_back({"Front", frontText(otf.view)});
    if (otf.view.box) rows.push_back({"Render box", boxText(*otf.view.box)});
    rows.push_back({"Speckle reduction", std::string(nameOf(otf.reduction))});
    rows.push_back({"Reading of the paper", reading ? std::string(nameOf(*reading)) : "its parameters were changed"});
    if (otf.lengthsHalved)
        rows.push_back({"Lengths", "halved, because the volume has few voxels: those below are the halved ones"});
    rows.push_back({"Initial function", initialText(explanation.config.initial)});
    const std::vector<int>& never = explanation.config.grid.withoutTubes;
    if (!never.empty()) rows.push_back({"Never placed", fmt::format("{}", fmt::join(never, ", "))});
    if (!page.pictures.empty()) rows.push_back({"Light", std::string(nameOf(page.lighting))});
    rows.push_back({"Program", page.program});
    for (const auto& row : methodParameters()) {
        const auto value = row.get(explanation.config);
        if (!value) continue;
        // Units of numbers alone: "share" says nothing behind one.
        const std::string unit = row.unit.empty() || row.unit == "share" ? "" : " " + std::string(row.unit);
        rows.push_back({std::string(row.label), shownValue(row, *value) + unit});
    }
    return rows;
}

Rows factRows(const TubeExplanation& explanation) {
    Rows rows;
    for (const ExplanationFact& fact : explanationFacts(explanation))
        rows.push_back({fact.symbol, fact.value + (fact.unit.empty() ? "" : " " + fact.unit), fact.meaning,
                        fact.equation, fact.place});
    return rows;
}

void addPlots(HtmlPage& html, const TubeExplanation& explanation, const AdaptiveOtf& otf) {
    html.heading("What it sees");
    html.paragraph("Figs. 2 and 4 of Petersch et al. 2005, for this tube core.");
    html.plot(intensityProfilePlot(explanation));
    html.plot(interfaceFunctionPlot(explanation));
    html.heading("How surely");
    html.paragraph("Eqs. 9 and 10: its place among all tube cores with a surface.");
    for (const Plot& plot : rankPlots(explanation)) html.plot(plot);
    html.heading("What it does to the curve");
    const bool ramps = std::holds_alternative<RampRule>(otf.config.curve);
    html.paragraph(ramps
                       ? "In the place of the paper's basis functions (Fig. 5) each tube core gives a ramp. The curve "
                         "is their mean, weighted by d."
                       : "Figs. 5 and 6: each tube core gives a basis function. The curve is their product with the "
                         "initial function.");
    html.plot(factorsPlot(explanation, allFactors(otf)));
    html.plot(curvesPlot(explanation));
    html.plot(curveChangePlot(explanation));
    html.paragraph(
        "Without it: all is computed again, as if the tube core had never been placed. It alone: what the rule of the "
        "curve makes of this tube core and no other.");
}

}  // namespace

std::string explanationPage(const ExplanationPage& page, const TubeExplanation& explanation, const AdaptiveOtf& otf) {
    HtmlPage html("Tube core " + std::to_string(explanation.number), HtmlPage::anyBytes);
    html.paragraph(explanationSentence(explanation));
    if (!explanation.full.message.empty()) html.paragraph(explanation.full.message);
    for (const auto& [picture, caption] : page.pictures) html.picture(picture, caption);
    addPlots(html, explanation, otf);
    html.heading("Its numbers");
    html.table({"", "value", "meaning", "equation", "place"}, factRows(explanation),
               "Intensities are normalised by the white level. A unit is the volume's smallest spacing.");
    html.heading("How it was made");
    html.table({"", ""}, madeWithRows(page, explanation, otf));
    return html.text();
}

}  // namespace echolucent
