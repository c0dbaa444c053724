#include "widgets/compare/compare_rows.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>

namespace echolucent {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("compare", text); }

QString shown(const std::optional<double>& value, int decimals, double factor = 1.0) {
    if (!value) return QStringLiteral("–");
    QString text = QString::number(factor * *value, 'f', decimals);
    return text.replace(QLatin1Char('-'), QChar(0x2212));
}

QString exact(const std::optional<double>& value) {
    return value ? QString::number(*value, 'g', QLocale::FloatingPointShortest) : QString();
}

}  // namespace

QStringList compareColumns() {
    return {tr("Pane"), tr("CNR_S"), tr("Near %"), tr("Flicker"), tr("OTF ms"), tr("Pict. ms")};
}

QStringList cellsOf(const CompareRow& row) {
    return {row.name,
            shown(row.contrast, 2),
            shown(row.nearSurfaces, 0, 100.0),
            shown(row.flicker, 4),
            shown(row.designMilliseconds, 1),
            shown(row.pictureMilliseconds, 0)};
}

QString numbersOf(const CompareRow& row) {
    QStringList words;
    if (row.contrast) words << tr("CNR_S %1").arg(shown(row.contrast, 2));
    if (row.nearSurfaces) words << tr("%1 % near surfaces").arg(shown(row.nearSurfaces, 0, 100.0));
    if (row.flicker) words << tr("flicker %1").arg(shown(row.flicker, 4));
    if (row.designMilliseconds) words << tr("OTF %1 ms").arg(shown(row.designMilliseconds, 1));
    if (row.pictureMilliseconds) words << tr("picture %1 ms").arg(shown(row.pictureMilliseconds, 0));
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
    return text;
}

QString compareCsv(const std::vector<CompareRow>& rows) {
    QString text = QStringLiteral("pane,cnr_s,light_near_surfaces,flicker,otf_ms,picture_ms\n");
    for (const CompareRow& row : rows) {
        QString name = row.name;
        name.replace(QLatin1Char('"'), QStringLiteral("\"\""));
        text += QStringLiteral("\"%1\",").arg(name) +
                QStringList{exact(row.contrast), exact(row.nearSurfaces), exact(row.flicker),
                            exact(row.designMilliseconds), exact(row.pictureMilliseconds)}
                    .join(QLatin1Char(',')) +
                QLatin1Char('\n');
    }
    return text;
}

}  // namespace echolucent
