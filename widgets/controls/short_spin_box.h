// A number field that shows no needless zeros.
#pragma once

#include <QDoubleSpinBox>
#include <QLocale>

namespace echolucent {

/// Shows 0.3 as "0.3", whatever its number of decimals.
class ShortSpinBox : public QDoubleSpinBox {
public:
    using QDoubleSpinBox::QDoubleSpinBox;
    [[nodiscard]] QString textFromValue(double value) const override {
        return locale().toString(value, 'g', QLocale::FloatingPointShortest);
    }
};

}  // namespace echolucent
