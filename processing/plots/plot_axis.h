// The scale of one axis of a plot: its range, its ticks, and the place of a value.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "processing/plots/plot.h"

namespace echolucent {

struct PlotTick {
    double value = 0.0;
    std::string label;  ///< empty if the tick is only a grid line
};

class PlotAxis {
public:
    /// Spans the range or, if there is none that can be shown, all values that can be shown (finite; above 0 if
    /// logarithmic). There is some room beside them. Without any value it spans [0,1] or [0.1,1].
    PlotAxis(const std::vector<double>& values, bool logarithmic, const std::optional<PlotRange>& range = {});
    [[nodiscard]] bool shows(double value) const;
    /// The place of a value: 0 at the lower end, 1 at the upper.
    [[nodiscard]] double placeOf(double value) const;
    /// The ticks in ascending order, within the range. At least two have labels.
    [[nodiscard]] const std::vector<PlotTick>& ticks() const { return m_ticks; }

private:
    void spanLinear(double least, double most);
    void spanLogarithmic(double least, double most);

    bool m_logarithmic;
    double m_low = 0.0, m_high = 1.0;  ///< ends of the range; decimal logarithms if the axis is logarithmic
    std::vector<PlotTick> m_ticks;
};

/// A number as short as a person would write it: at most six digits, no padded exponent.
[[nodiscard]] std::string shortNumber(double value);

}  // namespace echolucent
