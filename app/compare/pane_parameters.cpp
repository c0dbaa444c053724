#include "app/compare/pane_parameters.h"

#include <QCoreApplication>
#include <QStringList>
#include <variant>

#include "processing/adaptive/method_parameters.h"
#include "processing/adaptive/method_reading.h"
#include "processing/designers/choice/designer.h"
#include "widgets/compare/pane_words.h"
#include "widgets/controls/panel_controls.h"

namespace echolucent {

namespace {

template <typename Values>
QString rowsOf(const ParameterTable<Values>& table, const Values& values) {
    QStringList rows;
    for (const Parameter<Values>& row : table) {
        if (!playsAPart(row, values)) continue;
        if (const auto value = row.get(values))
            rows << QStringLiteral("%1 %2").arg(textOf(row.label), textOf(shownValue(row, *value)));
    }
    return rows.isEmpty() ? QString() : rows.join(QStringLiteral("; ")) + QLatin1Char('.');
}

}  // namespace

QString parametersOfPane(const Document& document, std::size_t pane) {
    const Pane& shown = document.panes.at(pane);
    const DesignerConfig* designer = designerConfigOf(document, pane);
    const bool adaptive =
        designer != nullptr ? std::holds_alternative<AdaptiveConfig>(*designer) : shown.curve == CurveKind::adaptive;
    if (adaptive) {
        const AdaptiveOtfConfig config = configOf(document, pane);
        const auto reading = readingOf(config);
        const QString rows = rowsOf(methodParameters(), config);
        return reading ? QCoreApplication::translate("compare", "Reading: %1.").arg(wordsOf(*reading)) +
                             QLatin1Char(' ') + rows
                       : rows;
    }
    if (designer == nullptr) return {};
    return std::visit([](const auto& values) { return rowsOf(parametersOf(values), values); }, *designer);
}

std::optional<std::size_t> colourOfPane(const Pane& pane) {
    constexpr std::size_t behindTheCurves = allCurveKinds.size();
    if (pane.designer)
        return std::holds_alternative<AdaptiveConfig>(*pane.designer) ? std::optional(indexOf(CurveKind::adaptive))
                                                                      : std::nullopt;
    const bool own = pane.curve == CurveKind::linear && pane.linear && *pane.linear != LinearCurve{};
    return own ? behindTheCurves : indexOf(pane.curve);
}

}  // namespace echolucent
