#include "app/planes/measurement_controls.h"

#include <algorithm>
#include <optional>

#include "processing/scene/planes_holding.h"
#include "processing/scene/shown_measurement.h"
#include "widgets/controls/panel_controls.h"

namespace echolucent {

namespace {

QString rowText(const Measurement& measurement, const VolumeGeometry& geometry, bool phases) {
    const Result<std::string> value = measurementText(measurement, geometry);
    QString text = value ? QString::fromStdString(*value)
                         : MeasurementControls::tr("%1 without a value").arg(textOf(nameOf(measurement.kind)));
    if (!measurement.name.empty()) text.prepend(QString::fromStdString(measurement.name) + ' ');
    // A name may hold a placeholder that QString::arg() would replace.
    QStringList words{QString::number(measurement.id) + QStringLiteral(". ") + text};
    words << textOf(groundWords(measurement.ground));
    if (phases) words << MeasurementControls::tr("volume %1").arg(measurement.phase + 1);
    return words.join(QStringLiteral(", "));
}

}  // namespace

MeasurementControls::MeasurementControls(const Parts& parts, QObject* parent) : QObject(parent), m_parts(parts) {
    MeasurementsPanel* panel = &m_parts.panel;
    connect(panel, &MeasurementsPanel::toolChosen, &m_parts.hand, &MeasuringHand::setTool);
    connect(&m_parts.hand, &MeasuringHand::toolChanged, panel, [this] { m_parts.panel.setTool(m_parts.hand.tool()); });
    connect(panel, &MeasurementsPanel::chosen, this, &MeasurementControls::show);
    connect(panel, &MeasurementsPanel::nameTyped, this, &MeasurementControls::setName);
    connect(panel, &MeasurementsPanel::commentTyped, this, &MeasurementControls::setComment);
    connect(panel, &MeasurementsPanel::typingEnded, this, [this] { --m_typing; });
    connect(panel, &MeasurementsPanel::removed, this, &MeasurementControls::remove);
    connect(panel, &MeasurementsPanel::allRemoved, this, &MeasurementControls::removeAll);
    connect(&m_parts.model, &DocumentModel::measurementsChanged, this, &MeasurementControls::list);
    connect(&m_parts.openStudy, &OpenStudy::studyOpened, this, &MeasurementControls::list);
    list();
}

void MeasurementControls::list() {
    std::vector<MeasurementRow> rows;
    if (const std::shared_ptr<const Volume> volume = m_parts.openStudy.volume())
        for (const Measurement& each : m_parts.model.document().measurements)
            rows.push_back({each.id, rowText(each, volume->geometry(), m_parts.openStudy.study()->phases.size() > 1),
                            QString::fromStdString(each.name), QString::fromStdString(each.comment)});
    m_parts.panel.setRows(rows);
}

void MeasurementControls::show(int id) {
    // Copied, because showing the phase replaces the document that holds the measurement.
    std::optional<Measurement> measurement;
    for (const Measurement& each : m_parts.model.document().measurements)
        if (each.id == id) measurement = each;
    if (!measurement || !m_parts.openStudy.volume()) return;
    m_parts.player.pause();
    if (phaseOf(m_parts.model.document(), firstPane) != measurement->phase) m_parts.model.showPhase(measurement->phase);
    if (measurement->ground != MeasurementGround::plane) return;
    m_parts.model.change(tr("planes to %1 %2").arg(textOf(nameOf(measurement->kind))).arg(id), [&](Document& next) {
        Planes& planes = next.scene.planes;
        planes = planesHolding(planes, measurement->placesMm, next.beam.axis, m_parts.openStudy.volume()->dataBox());
    });
}

void MeasurementControls::setName(int id, const QString& typed) {
    setText(id, &Measurement::name, measurementNameOf(typed.toStdString()), tr("name %1 %2"));
}

void MeasurementControls::setComment(int id, const QString& typed) {
    setText(id, &Measurement::comment, measurementCommentOf(typed.toStdString()), tr("comment on %1 %2"));
}

void MeasurementControls::setText(int id, std::string Measurement::*member, const std::string& text,
                                  const QString& what) {
    Document next = m_parts.model.document();
    const auto found = std::ranges::find(next.measurements, id, &Measurement::id);
    if (found == next.measurements.end()) return;
    const QString step = what.arg(textOf(nameOf(found->kind))).arg(id);
    next.measurements.change(
        [&, place = found - next.measurements.begin()](auto& all) { (*(all.begin() + place)).*member = text; });
    m_parts.model.edit(next, step, m_typing);
}

void MeasurementControls::remove(int id) {
    Document next = m_parts.model.document();
    const auto found = std::ranges::find(next.measurements, id, &Measurement::id);
    if (found == next.measurements.end()) return;
    const QString what = tr("remove %1 %2").arg(textOf(nameOf(found->kind))).arg(id);
    next.measurements.change(
        [place = found - next.measurements.begin()](auto& all) { all.erase(all.begin() + place); });
    m_parts.model.edit(next, what);
}

void MeasurementControls::removeAll() {
    m_parts.model.change(tr("remove all measurements"), [](Document& next) { next.measurements.clear(); });
}

}  // namespace echolucent
