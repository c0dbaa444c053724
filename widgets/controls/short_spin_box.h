// A number field that shows no needless zeros.
#pragma once

#include <QLocale>

#include "widgets/controls/number_box.h"

namespace echolucent {

/// Shows 0.3 as "0.3", whatever its number of decimals.
class ShortSpinBox : public NumberBox {
public:
    using NumberBox::NumberBox;
    [[nodiscard]] QString textFromValue(double value) const override {
        return QLocale::c().toString(value, 'g', QLocale::FloatingPointShortest);
    }
};

}  // namespace echolucent
