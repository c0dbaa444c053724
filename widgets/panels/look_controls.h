// A control for each choice of a picture's look, made from the table of the look.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "processing/picture/look.h"

class QWidget;

namespace echolucent {

/// Holds a look and shows it in its controls: a check box for a flag, a combo box for a choice, a slider with a spin
/// box and a reset for a number. A control's object name is "view." and the row's name in camel case
/// ("view.colourMap"); the row says its label and its tool tip. A number that no person has moved keeps all its digits,
/// whatever the control shows.
class LookControls : public QObject {
    Q_OBJECT

public:
    /// Makes the controls of all rows for which chosenByPersons() holds; they are without a parent widget.
    explicit LookControls(QObject* parent);

    [[nodiscard]] const Look& look() const { return m_look; }
    /// Emits nothing.
    void setLook(const Look& look);
    /// Of a row; null where no person chooses it.
    [[nodiscard]] QWidget* control(std::string_view name) const;
    [[nodiscard]] static QString label(const Parameter<Look>& row);

signals:
    /// A person changed something.
    void changed(const echolucent::Look& look);

private:
    struct Control {
        QWidget* widget;
        std::function<void(const ParameterValue&)> show;  ///< emits nothing
    };
    [[nodiscard]] Control createFlag(const Parameter<Look>& row);
    [[nodiscard]] Control createChoice(const Parameter<Look>& row);
    [[nodiscard]] Control createNumber(const Parameter<Look>& row);
    void take(const Parameter<Look>& row, const ParameterValue& value);
    void updateEnabled();

    Look m_look = lookAtStart();
    std::map<std::string, Control, std::less<>> m_controls;
};

}  // namespace echolucent
