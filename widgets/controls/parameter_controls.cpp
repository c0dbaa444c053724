#include "widgets/controls/parameter_controls.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSignalBlocker>
#include <cmath>
#include <cstdint>
#include <utility>

#include "widgets/controls/number_box.h"
#include "widgets/controls/short_spin_box.h"
#include "widgets/controls/value_slider.h"

namespace echolucent {

namespace {

/// Receives the values that a person sets.
struct Listener {
    const QObject* object;
    std::function<void(const ParameterValue&)> taken;
};

/// The column of panels is narrow. Units are signs or short words; longer ones stand in the tool tip.
QString suffixOf(std::string_view unit) {
    if (unit == "degrees") return QStringLiteral("°");
    if (unit == "times") return QStringLiteral("×");
    constexpr std::size_t longest = 8;
    return unit.empty() || unit == "share" || unit.size() > longest ? QString() : " " + textOf(unit);
}

QString toolTipOf(const AnyParameter& row) {
    const QString meaning = textOf(row.meaning);
    if (row.unit == "units") return QObject::tr("%1. A unit is the smallest voxel spacing").arg(meaning);
    if (row.unit.empty() || row.unit == "share" || !suffixOf(row.unit).isEmpty()) return meaning;
    return QObject::tr("%1, in %2").arg(meaning, textOf(row.unit));
}

double spanOf(const AnyParameter& row) { return row.offeredRange().largest - row.offeredRange().least; }

ParameterSteps stepsOfSlider(const AnyParameter& row) {
    if (row.steps) return *row.steps;
    return row.unit == "degrees" ? ParameterSteps{1.0, 0} : ParameterSteps{spanOf(row) / 100.0, 2};
}

double stepOfSpinBox(const AnyParameter& row) {
    if (row.steps) return row.steps->step;
    const double span = spanOf(row);
    return span <= 2.0 ? 0.05 : span <= 20.0 ? 0.25 : 1.0;
}

/// Gives a combo box or spin box its name, its tool tip and its wheel. Check boxes and sliders do this themselves.
template <typename Widget>
Widget* dressed(Widget* widget, const AnyParameter& row, const QString& name) {
    named(widget, name, textOf(row.label), toolTipOf(row));
    wheelNeedsFocus(widget);
    return widget;
}

ParameterControl flagControl(const AnyParameter& row, const QString& name, const Listener& listener) {
    auto* box = named(new QCheckBox(textOf(row.label)), name, textOf(row.label), toolTipOf(row));
    QObject::connect(box, &QCheckBox::toggled, listener.object,
                     [taken = listener.taken](bool checked) { taken(checked); });
    return {box, nullptr, [box](const ParameterValue& value) {
                const QSignalBlocker blocker(box);
                box->setChecked(std::get<bool>(value));
            }};
}

ParameterControl choiceControl(const AnyParameter& row, const QString& name, const Listener& listener) {
    auto* box = dressed(new QComboBox, row, name);
    for (const ParameterChoice& choice : row.choices)
        box->addItem(QString::fromStdString(labelOf(choice)), textOf(choice.name));
    QObject::connect(box, &QComboBox::currentIndexChanged, listener.object,
                     [taken = listener.taken, box] { taken(box->currentData().toString().toStdString()); });
    return {box, labelFor(box, textOf(row.label)), [box](const ParameterValue& value) {
                const QSignalBlocker blocker(box);
                box->setCurrentIndex(box->findData(textOf(std::get<std::string>(value))));
            }};
}

template <typename SpinBox, typename Number>
ParameterControl spinBoxControl(SpinBox* box, const AnyParameter& row, const QString& name, const Listener& listener) {
    using Shown = decltype(box->value());
    dressed(box, row, name);
    const ParameterRange offered = row.offeredRange();
    box->setRange(static_cast<Shown>(offered.least), static_cast<Shown>(offered.largest));
    box->setSuffix(suffixOf(row.unit));
    QObject::connect(box, &SpinBox::valueChanged, listener.object,
                     [taken = listener.taken](Shown value) { taken(Number{value}); });
    return {box, labelFor(box, textOf(row.label)), [box](const ParameterValue& value) {
                const QSignalBlocker blocker(box);
                box->setValue(static_cast<Shown>(numberOf(value).value()));
            }};
}

ParameterControl spinBoxControl(const ParameterDefault& each, const QString& name, const Listener& listener) {
    const AnyParameter& row = *each.row;
    if (std::holds_alternative<std::int64_t>(each.standard))
        return spinBoxControl<QSpinBox, std::int64_t>(new WholeNumberBox, row, name, listener);
    constexpr int decimalsOfShort = 3;
    NumberBox* box = row.steps ? new NumberBox : new ShortSpinBox;
    box->setDecimals(row.steps ? row.steps->decimals : decimalsOfShort);
    box->setSingleStep(stepOfSpinBox(row));
    return spinBoxControl<QDoubleSpinBox, double>(box, row, name, listener);
}

ParameterControl sliderControl(const ParameterDefault& each, const QString& name, const Listener& listener,
                               bool resetting) {
    const AnyParameter& row = *each.row;
    const auto [step, decimals] = stepsOfSlider(row);
    auto* slider = new ValueSlider(name, textOf(row.label), step, decimals);
    slider->setToolTip(toolTipOf(row));
    slider->setRange(row.offeredRange().least, row.offeredRange().largest);
    slider->setSuffix(suffixOf(row.unit));
    if (resetting) slider->setStandard(numberOf(each.standard).value());
    const bool whole = std::holds_alternative<std::int64_t>(each.standard);
    QObject::connect(
        slider, &ValueSlider::valueChanged, listener.object, [taken = listener.taken, whole](double value) {
            taken(whole ? ParameterValue(static_cast<std::int64_t>(std::llround(value))) : ParameterValue(value));
        });
    return {slider, labelFor(slider, textOf(row.label)),
            [slider](const ParameterValue& value) { slider->setValue(numberOf(value).value()); }};
}

}  // namespace

QString whyGreyed(const AnyParameter& row) {
    return QObject::tr("It plays a part only %1.").arg(QString::fromStdString(whenOf(row)));
}

ParameterControl parameterControl(const ParameterDefault& row, const QString& group, NumberControl numbers,
                                  const QObject* listener, std::function<void(const ParameterValue&)> taken) {
    const QString name = group + '.' + QString::fromStdString(camelCase(row.row->name));
    const Listener heard{listener, std::move(taken)};
    ParameterControl control = std::holds_alternative<bool>(row.standard) ? flagControl(*row.row, name, heard)
                               : std::holds_alternative<std::string>(row.standard)
                                   ? choiceControl(*row.row, name, heard)
                               : numbers == NumberControl::spinBox
                                   ? spinBoxControl(row, name, heard)
                                   : sliderControl(row, name, heard, numbers == NumberControl::resettingSlider);
    control.show(row.standard);
    return control;
}

}  // namespace echolucent
