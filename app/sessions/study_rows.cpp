#include "app/sessions/study_rows.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>

#include "widgets/controls/panel_controls.h"

namespace echolucent {

namespace {

QString rowText(const char* text) { return QCoreApplication::translate("study", text); }

/// How the probe looks, by the document. The fact of the import report says more, if it is of the same beam: how the
/// beam leans, or how sure a guess is.
StudyFactRow probeRow(const Beam& beam, const StudyFactRow& fact) {
    if (beam.source == BeamSource::assumed) return {};
    const QString name = rowText("probe looks along"),
                  axis = rowText("%1 of the voxel grid").arg(textOf(nameOf(beam.axis)));
    if (beam.source == BeamSource::person) return {name, axis, rowText("chosen by hand")};
    if (fact.value.startsWith(axis)) return {name, fact.value, fact.source};
    return {name, axis,
            beam.source == BeamSource::file ? rowText("the file")
                                            : rowText("guess from the %1").arg(textOf(nameOf(beam.source)))};
}

}  // namespace

QString withVolumesForPhases(QString sentence) {
    // Lower case alone is the reader's own word. Names of a file's entries have capitals.
    static const QRegularExpression phase(QStringLiteral("(?<![\\w/.\\-])phase(s?)(?![\\w/\\-])(?!\\.\\w)"));
    sentence.replace(phase, QStringLiteral("volume\\1"));
    return sentence.replace(QLatin1String("Phases with"), QLatin1String("Volumes with"));
}

QList<StudyFactRow> studyRows(QList<StudyFactRow> facts, const Study& study, const Beam& beam) {
    const auto taken = [&facts](const char* name) {
        const auto at = std::ranges::find(facts, QLatin1String(name), &StudyFactRow::name);
        return at == facts.end() ? StudyFactRow{} : facts.takeAt(at - facts.begin());
    };
    const VolumeGeometry& geometry = study.phases.front()->geometry();
    const auto edge = [&geometry](int axis) {
        return QString::number(static_cast<double>(geometry.size[axis]) * geometry.spacing[axis], 'f', 1);
    };
    QString size = rowText("%1 × %2 × %3 mm").arg(edge(0), edge(1), edge(2));
    if (!geometry.spacingKnown) size = rowText("%1 (guess)").arg(size);
    const auto volumes = study.phases.size();
    QList<StudyFactRow> rows{
        {rowText("scan"), volumes > 1 ? rowText("4D, %1 volumes in time").arg(volumes) : rowText("3D, one volume"), {}},
        {rowText("size"), size, {}}};
    taken("phases");
    if (const StudyFactRow time = taken("time between phases"); !time.name.isEmpty())
        rows << StudyFactRow{rowText("time between volumes"), time.value, time.source};
    if (const StudyFactRow probe = probeRow(beam, taken("beam")); !probe.name.isEmpty()) rows << probe;
    for (StudyFactRow& fact : facts)
        if (fact.name == QLatin1String("size")) fact.name = rowText("voxels");
    rows << StudyFactRow{rowText("of the file"), {}, {}} << facts;
    for (StudyFactRow& row : rows)
        for (QString* words : {&row.name, &row.value, &row.source}) *words = withVolumesForPhases(*words);
    return rows;
}

}  // namespace echolucent
