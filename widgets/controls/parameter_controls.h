// Controls of parameters, made from the rows of their table.
#pragma once

#include <QObject>
#include <QString>
#include <QWidget>
#include <functional>
#include <map>
#include <string_view>
#include <utility>

#include "processing/parameters/parameter.h"
#include "widgets/controls/panel_controls.h"

namespace echolucent {

/// The control of one parameter: a check box for a flag, a combo box for a choice, a spin box or slider for a number.
struct ParameterControl {
    QWidget* widget = nullptr;
    QLabel* label = nullptr;  ///< the widget is its buddy; null for a check box, which shows the name itself
    std::function<void(const ParameterValue&)> show{};  ///< shows a value; emits nothing
};

/// The kind of control for numbers.
enum class NumberControl {
    spinBox,
    slider,           ///< a slider and a spin box
    resettingSlider,  ///< a slider, a spin box, and a button that sets the default
};

/// Makes the control of a row; the caller owns its widgets. Its object name is the group's name, a point and the row's
/// name in camel case ("view.colourMap"). Its accessible name is the row's label. Its range is
/// AnyParameter::offeredRange(), and it shows the default at first. `taken` is called with each value that a person
/// sets while `listener` lives, and only then.
[[nodiscard]] ParameterControl parameterControl(const ParameterDefault& row, const QString& group,
                                                NumberControl numbers, const QObject* listener,
                                                std::function<void(const ParameterValue&)> taken);

/// Why the control of a row is greyed that plays no part: "It plays a part only in direct mode."
[[nodiscard]] QString whyGreyed(const AnyParameter& row);

/// Values, and a control for each of their rows that panels show. A number keeps all its digits until a person moves
/// it, however few its control shows.
template <typename Values>
class ParameterControls {
public:
    /// `changed` is called if a person sets a row. The controls have no parent. The table outlives this.
    ParameterControls(const ParameterTable<Values>& table, const QString& group, NumberControl numbers,
                      std::function<void(const Values&, const AnyParameter&)> changed)
        : m_table(table), m_values(table.standard), m_changed(std::move(changed)) {
        for (const Parameter<Values>& row : table)
            if (row.inPanels)
                m_controls.emplace(row.name,
                                   parameterControl({&row, defaultOf(table, row)}, group, numbers, &m_listener,
                                                    [this, &row](const auto& value) { take(row, value); }));
        setValues(m_values);
    }

    [[nodiscard]] const Values& values() const { return m_values; }
    /// Calls no callback. Rows that play no part are disabled, and their tool tips say when they play one.
    void setValues(const Values& values) {
        m_values = values;
        for (const Parameter<Values>& row : m_table)
            if (const auto found = m_controls.find(row.name); found != m_controls.end())
                if (const auto value = row.get(m_values)) found->second.show(*value);
        enable();
    }
    /// The row must be one that panels show.
    [[nodiscard]] const ParameterControl& of(std::string_view name) const { return m_controls.at(name); }

private:
    void take(const Parameter<Values>& row, const ParameterValue& value) {
        row.set(m_values, value);
        enable();
        m_changed(m_values, row);
    }
    void enable() {
        for (const Parameter<Values>& row : m_table)
            if (const auto found = m_controls.find(row.name); found != m_controls.end())
                enableOrSayWhy(*found->second.widget, playsAPart(row, m_values), whyGreyed(row));
    }

    const ParameterTable<Values>& m_table;
    Values m_values;
    std::function<void(const Values&, const AnyParameter&)> m_changed;
    std::map<std::string_view, ParameterControl> m_controls;
    QObject m_listener;  // last member: destroyed first, so that no control calls back after that
};

}  // namespace echolucent
