#include "widgets/dialogs/polar_controls.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include "widgets/controls/panel_controls.h"
#include "widgets/controls/short_spin_box.h"

namespace echolucent {
namespace {

/// Whether an axis differs from the even one between the same ends by more than rounding.
bool isUneven(const PolarAxis& given, const PolarAxis& even) {
    const double step = std::abs(even.values.back() - even.values.front()) / static_cast<double>(even.values.size());
    return !std::equal(given.values.begin(), given.values.end(), even.values.begin(), even.values.end(),
                       [&](double a, double b) { return std::abs(a - b) <= 1e-6 * step; });
}

}  // namespace

PolarControls::PolarControls(QWidget* parent) : QWidget(parent) {
    named(this, "rawLayout.polar", tr("Geometry of the beams"));
    const EvenPolar usual;
    m_rangeStart =
        createField("rangeStart", tr("Distance of the first sample from the probe's face, mm"), usual.rangeStartMm);
    m_rangeStep = createField("rangeStep", tr("Distance from sample to sample, mm"), usual.rangeStepMm);
    m_lines = {createField("linesFirst", tr("First line"), usual.lines[0]),
               createField("linesLast", tr("Last line"), usual.lines[1])};
    m_linesRadius = createField("linesRadius", tr("Radius of the lines, mm"), usual.lineRadiusMm);
    m_planes = {createField("planesFirst", tr("First plane"), usual.planes[0]),
                createField("planesLast", tr("Last plane"), usual.planes[1])};
    m_planesRadius = createField("planesRadius", tr("Radius of the planes, mm"), usual.planeRadiusMm);

    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    m_linesLabel = labelFor(m_lines[0], {});
    m_planesLabel = labelFor(m_planes[0], {});
    grid->addWidget(labelFor(m_rangeStart, tr("First sample, mm")), 0, 0);
    grid->addWidget(m_rangeStart, 0, 1);
    grid->addWidget(labelFor(m_rangeStep, tr("Sample to sample, mm")), 0, 2, 1, 2);
    grid->addWidget(m_rangeStep, 0, 4);
    const auto addRow = [&](int row, QLabel* label, const std::array<QDoubleSpinBox*, 2>& ends,
                            QDoubleSpinBox* radius) {
        grid->addWidget(label, row, 0);
        grid->addWidget(ends[0], row, 1);
        grid->addWidget(ends[1], row, 2);
        grid->addWidget(labelFor(radius, tr("Radius, mm")), row, 3);
        grid->addWidget(radius, row, 4);
    };
    addRow(1, m_linesLabel, m_lines, m_linesRadius);
    addRow(2, m_planesLabel, m_planes, m_planesRadius);
    for (const int column : {1, 2, 4}) grid->setColumnStretch(column, 1);
    setKind(m_kind);
}

QDoubleSpinBox* PolarControls::createField(const QString& name, const QString& accessibleName, double value) {
    auto* field = named(new ShortSpinBox, "rawLayout." + name, accessibleName);
    wheelNeedsFocus(field);
    field->setDecimals(9);
    field->setRange(-10000, 10000);
    field->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    field->setMinimumWidth(80);
    field->setValue(value);
    connect(field, &QDoubleSpinBox::valueChanged, this, &PolarControls::changed);
    return field;
}

void PolarControls::setKind(PolarKind kind) {
    m_kind = kind;
    m_linesLabel->setText(turnsLines(kind) ? tr("First, last line, °") : tr("First, last line, mm"));
    m_planesLabel->setText(turnsPlanes(kind) ? tr("First, last plane, °") : tr("First, last plane, mm"));
    m_linesRadius->setEnabled(turnsLines(kind));
    m_planesRadius->setEnabled(turnsPlanes(kind));
    emit changed();
}

EvenPolar PolarControls::even() const {
    EvenPolar even;
    even.kind = m_kind;
    even.rangeStartMm = m_rangeStart->value();
    even.rangeStepMm = m_rangeStep->value();
    even.lines = {m_lines[0]->value(), m_lines[1]->value()};
    even.planes = {m_planes[0]->value(), m_planes[1]->value()};
    even.lineRadiusMm = m_linesRadius->value();
    even.planeRadiusMm = m_planesRadius->value();
    return even;
}

void PolarControls::setGeometry(const PolarGeometry& geometry) {
    const EvenPolar shown = evenPolarOf(geometry);
    {
        const QSignalBlocker silent(this);
        setKind(shown.kind);
        m_rangeStart->setValue(shown.rangeStartMm);
        m_rangeStep->setValue(shown.rangeStepMm);
        for (std::size_t end = 0; end < 2; ++end) {
            m_lines[end]->setValue(shown.lines[end]);
            m_planes[end]->setValue(shown.planes[end]);
        }
        m_linesRadius->setValue(shown.lineRadiusMm);
        m_planesRadius->setValue(shown.planeRadiusMm);
    }
    m_given = geometry;
    m_shownOfGiven = even();
    emit changed();
}

bool PolarControls::keepsLines(std::int64_t count) const {
    const EvenPolar now = even();
    return m_given && m_given->size()[1] == count && turnsLines(now.kind) == turnsLines(m_shownOfGiven.kind) &&
           now.lines == m_shownOfGiven.lines;
}

bool PolarControls::keepsPlanes(std::int64_t count) const {
    const EvenPolar now = even();
    return m_given && m_given->size()[2] == count && turnsPlanes(now.kind) == turnsPlanes(m_shownOfGiven.kind) &&
           now.planes == m_shownOfGiven.planes;
}

PolarGeometry PolarControls::geometry(const std::array<std::int64_t, 3>& size) const {
    const EvenPolar now = even();
    PolarGeometry geometry = polarGeometry(now, size);
    if (!m_given) return geometry;
    // A field that nobody changed keeps the given value, with the digits that the field does not show.
    if (now.rangeStartMm == m_shownOfGiven.rangeStartMm) geometry.rangeStartMm = m_given->rangeStartMm;
    if (now.rangeStepMm == m_shownOfGiven.rangeStepMm) geometry.rangeStepMm = m_given->rangeStepMm;
    if (keepsLines(size[1])) {
        geometry.lines.values = m_given->lines.values;
        if (now.lineRadiusMm == m_shownOfGiven.lineRadiusMm) geometry.lines.radiusMm = m_given->lines.radiusMm;
    }
    if (keepsPlanes(size[2])) {
        geometry.planes.values = m_given->planes.values;
        if (now.planeRadiusMm == m_shownOfGiven.planeRadiusMm) geometry.planes.radiusMm = m_given->planes.radiusMm;
    }
    return geometry;
}

QString PolarControls::replacedSentence(const std::array<std::int64_t, 3>& size) const {
    if (!m_given || m_given->lines.values.empty() || m_given->planes.values.empty()) return {};
    const PolarGeometry evenly = polarGeometry(evenPolarOf(*m_given), m_given->size());
    const bool lines = !keepsLines(size[1]) && isUneven(m_given->lines, evenly.lines);
    const bool planes = !keepsPlanes(size[2]) && isUneven(m_given->planes, evenly.planes);
    if (lines && planes) return " " + tr("Even spacing replaces the uneven lines and planes.");
    if (lines) return " " + tr("Even spacing replaces the uneven lines.");
    return planes ? " " + tr("Even spacing replaces the uneven planes.") : QString();
}

}  // namespace echolucent
