// A field for numbers that says them as short as they are.
#pragma once

#include <QDoubleSpinBox>
#include <QLocale>

namespace echolucent {

/// Shows 0.3 as "0.3", however many decimals it takes.
class ShortSpinBox : public QDoubleSpinBox {
public:
    using QDoubleSpinBox::QDoubleSpinBox;
    [[nodiscard]] QString textFromValue(double value) const override {
        return locale().toString(value, 'g', QLocale::FloatingPointShortest);
    }
};

}  // namespace echolucent
