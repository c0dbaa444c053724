#include "widgets/compare/compare_rows.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "widgets/compare/surface_legend.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/surface_colours.h"

namespace echolucent {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("compare", text); }

QString shown(const std::optional<double>& value, int decimals, double factor = 1.0) {
    if (!value) return QStringLiteral("–");
    QString text = QString::number(factor * *value, 'f', decimals);
    if (text.toDouble() == 0.0) text.remove(QLatin1Char('-'));
    return text.replace(QLatin1Char('-'), QChar(0x2212));
}

QString exact(const std::optional<double>& value) {
    return value ? QString::number(*value, 'g', QLocale::FloatingPointShortest) : QString();
}

std::optional<double> times(const std::optional<double>& value, double factor) {
    return value ? std::optional(factor * *value) : std::nullopt;
}

constexpr double whiteLevels = 255.0;

std::optional<double> percentOf(const CompareRow& row, ShownSurface shown) {
    return row.depth ? times(row.depth->share(shown), 100.0) : std::nullopt;
}

/// Two digits, for that is what the time of a short run is worth; none behind the point from 10 ms on.
QString shownTime(const std::optional<double>& milliseconds) {
    if (!milliseconds || *milliseconds < 10.0) return shown(milliseconds, 1);
    double tens = 1.0;
    while (*milliseconds / tens >= 100.0) tens *= 10.0;
    return QString::number(std::round(*milliseconds / tens) * tens, 'f', 0);
}

}  // namespace

QStringList compareColumns() {
    return {tr("Pane"),  tr("Right %"), tr("Early %"),        tr("Late %"), tr("Never %"),
            tr("CNR_S"), tr("Near %"),  tr("Flicker levels"), tr("OTF ms"), tr("Picture ms")};
}

QStringList compareTips() {
    return {
        {},
        tr("Right: the share of rays on which the picture stands at the surface. Half of the light is held back within "
           "2 units of it. This favours OTFs that are clear before surfaces and opaque from them on."),
        tr("Early: the share of rays on which half of the light is held back more than 2 units before the surface. "
           "Haze "
           "or a wall hides it. This favours clear OTFs."),
        tr("Late: the share of rays on which half of the light is held back more than 2 units behind the surface. It "
           "is "
           "washed through. This favours opaque OTFs."),
        tr("Never: the share of rays on which less than half of the light is held back. The ray shows little or "
           "nothing. This favours opaque OTFs."),
        tr("CNR_S: whether surfaces are equally bright on all rays, and brighter than the light from elsewhere. This "
           "favours OTFs that show few surfaces evenly. It says nothing of where the picture stands."),
        tr("Near: the mean share of a ray's light that comes from within 3 units of the surface. This favours thin, "
           "hard "
           "surfaces, however dark."),
        tr("Flicker of the picture, not of the curve, while the view turns from −10° to +10°: RMS in levels of 255. "
           "This favours OTFs that stay the same in every view. They have 0."),
        tr("OTF: wall time of the designer on this machine, the median of three runs, or a single run from 50 ms on. A "
           "curve that needs no designer has none. This favours designers that read little of the scan."),
        tr("Picture: wall time of the picture that is shown, once. This favours opaque OTFs, whose rays end early.")};
}

QString flickerSentences() {
    return tr(
        "For the flicker the view turns from −10° to +10°. An OTF that follows the tube cores, such as the adaptive "
        "one, is computed anew for each frame, also if the motion keeps one; the motion's smoothing applies. But if a "
        "pane sets its own OTF in the motion, each pane has what it shows in the motion.");
}

QString surfacesSentence(const std::vector<CompareRow>& rows) {
    for (const CompareRow& row : rows)
        if (row.surfaces) return textOf(surfacesSentence(*row.surfaces));
    return {};
}

QStringList cellsOf(const CompareRow& row) {
    return {row.name,
            shown(percentOf(row, ShownSurface::right), 0),
            shown(percentOf(row, ShownSurface::early), 0),
            shown(percentOf(row, ShownSurface::late), 0),
            shown(percentOf(row, ShownSurface::never), 0),
            shown(row.contrast, 2),
            shown(row.nearSurfaces, 0, 100.0),
            shown(row.flicker, 2, whiteLevels),
            shownTime(row.designMilliseconds),
            shown(row.pictureMilliseconds, 0)};
}

QString numbersOf(const CompareRow& row) {
    QStringList words;
    for (const SurfaceLegendEntry& entry : surfaceLegend(row.depth))
        if (entry.percent && (entry.shown == ShownSurface::right || *entry.percent > 0))
            words << tr("%1 %2 %").arg(wordOf(entry.shown)).arg(*entry.percent);
    return words.join(QStringLiteral(" · "));
}

QString compareText(const std::vector<CompareRow>& rows) {
    std::vector<QStringList> lines{compareColumns()};
    for (const CompareRow& row : rows) lines.push_back(cellsOf(row));
    QString text;
    for (const QStringList& line : lines) {
        QString joined;
        for (qsizetype i = 0; i < line.size(); ++i) {
            qsizetype wide = 0;
            for (const QStringList& each : lines) wide = std::max(wide, each[i].size());
            joined += i == 0 ? line[i].leftJustified(wide) : QStringLiteral("  ") + line[i].rightJustified(wide);
        }
        text += joined + QLatin1Char('\n');
    }
    const QString sentence = surfacesSentence(rows);
    return sentence.isEmpty() ? text : text + sentence + QLatin1Char('\n');
}

QString compareCsv(const std::vector<CompareRow>& rows) {
    QString text = QStringLiteral(
        "pane,surfaces,right_percent,early_percent,late_percent,never_percent,cnr_s,light_near_surfaces,flicker_levels,"
        "otf_ms,picture_ms\n");
    for (const CompareRow& row : rows) {
        QString name = row.name;
        name.replace(QLatin1Char('"'), QStringLiteral("\"\""));
        QStringList cells{QStringLiteral("\"%1\"").arg(name)};
        cells << (!row.surfaces                          ? QString()
                  : *row.surfaces == SurfacesFrom::truth ? QStringLiteral("truth")
                                                         : QStringLiteral("tube cores"));
        for (const ShownSurface one :
             {ShownSurface::right, ShownSurface::early, ShownSurface::late, ShownSurface::never})
            cells << exact(percentOf(row, one));
        cells << exact(row.contrast) << exact(row.nearSurfaces) << exact(times(row.flicker, whiteLevels))
              << exact(row.designMilliseconds) << exact(row.pictureMilliseconds);
        text += cells.join(QLatin1Char(',')) + QLatin1Char('\n');
    }
    return text;
}

}  // namespace echolucent
