#include "widgets/panels/look_controls.h"

#include <QCheckBox>
#include <QComboBox>
#include <QSignalBlocker>

#include "widgets/panels/panel_controls.h"
#include "widgets/panels/value_slider.h"

namespace echolucent {

namespace {

QString lookObjectName(const Parameter<Look>& row) { return "view." + textOf(camelCase(row.name)); }

QString lookToolTip(const Parameter<Look>& row) {
    const QString meaning = textOf(row.meaning);
    return row.name == "lighting" ? meaning + LookControls::tr(". Ctrl + left drag in the picture moves the light")
                                  : meaning;
}

}  // namespace

LookControls::LookControls(QObject* parent) : QObject(parent) {
    for (const Parameter<Look>& row : lookParameters()) {
        if (!chosenByPersons(row)) continue;
        const ParameterValue value = *row.get(m_look);
        m_controls.emplace(row.name, std::holds_alternative<bool>(value)          ? createFlag(row)
                                     : std::holds_alternative<std::string>(value) ? createChoice(row)
                                                                                  : createNumber(row));
    }
    setLook(m_look);
}

QString LookControls::label(const Parameter<Look>& row) { return textOf(row.label); }

LookControls::Control LookControls::createFlag(const Parameter<Look>& row) {
    auto* box = named(new QCheckBox(label(row)), lookObjectName(row), label(row), lookToolTip(row));
    connect(box, &QCheckBox::toggled, this, [this, &row](bool checked) { take(row, checked); });
    return {box, [box](const ParameterValue& value) {
                const QSignalBlocker blocker(box);
                box->setChecked(std::get<bool>(value));
            }};
}

LookControls::Control LookControls::createChoice(const Parameter<Look>& row) {
    auto* box = named(new QComboBox, lookObjectName(row), label(row), lookToolTip(row));
    for (const std::string_view choice : row.choices)
        box->addItem(QString::fromStdString(labelOfChoice(choice)), textOf(choice));
    wheelNeedsFocus(box);
    connect(box, &QComboBox::currentIndexChanged, this,
            [this, box, &row] { take(row, box->currentData().toString().toStdString()); });
    return {box, [box](const ParameterValue& value) {
                const QSignalBlocker blocker(box);
                box->setCurrentIndex(box->findData(textOf(std::get<std::string>(value))));
            }};
}

LookControls::Control LookControls::createNumber(const Parameter<Look>& row) {
    const bool degrees = row.unit == "degrees";
    auto* slider =
        degrees ? new ValueSlider(lookObjectName(row), label(row), 1, 0)
                : new ValueSlider(lookObjectName(row), label(row), (row.range.largest - row.range.least) / 100.0, 2);
    slider->setToolTip(lookToolTip(row));
    slider->setRange(row.range.least, row.range.largest);
    // The column of panels is narrow: units are signs.
    slider->setSuffix(degrees               ? QStringLiteral("°")
                      : row.unit == "times" ? QStringLiteral("×")
                      : row.unit.empty()    ? QString()
                                            : " " + textOf(row.unit));
    slider->setStandard(numberOf(*row.get(lookAtStart())).value());
    connect(slider, &ValueSlider::valueChanged, this, [this, &row](double value) { take(row, value); });
    return {slider, [slider](const ParameterValue& value) { slider->setValue(*numberOf(value)); }};
}

void LookControls::take(const Parameter<Look>& row, const ParameterValue& value) {
    row.set(m_look, value);
    updateEnabled();
    emit changed(m_look);
}

void LookControls::setLook(const Look& look) {
    m_look = look;
    for (const Parameter<Look>& row : lookParameters())
        if (const auto found = m_controls.find(row.name); found != m_controls.end())
            found->second.show(*row.get(m_look));
    updateEnabled();
}

QWidget* LookControls::control(std::string_view name) const {
    const auto found = m_controls.find(name);
    return found == m_controls.end() ? nullptr : found->second.widget;
}

void LookControls::updateEnabled() {
    for (const auto& [name, control] : m_controls) control.widget->setEnabled(playsAPart(name, m_look));
}

}  // namespace echolucent
