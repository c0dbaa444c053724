// A plot as values: pages draw it as SVG, the window on a canvas.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace echolucent {

/// How a line stands out.
enum class PlotWeight {
    ordinary,
    heavy,  ///< the one that is spoken of
    faint,  ///< thin and grey, behind the others: what it is compared with
};

/// One line or cloud of points of a plot. A value that is not finite is left out, and makes a gap in a line.
struct PlotSeries {
    std::string name;
    std::vector<double> x, y;
    bool line = true;
    bool markers = false;
    std::vector<std::string> labels{};  ///< names beside the markers; empty for none
    std::vector<std::string> names{};   ///< a marker's words under the pointer; empty: its label
    PlotWeight weight = PlotWeight::ordinary;
    /// Index of its colour among seriesColours (series_style.h), whatever the others have; none: as coloursOf() says.
    std::optional<std::size_t> colour{};
    friend bool operator==(const PlotSeries&, const PlotSeries&) = default;
};

/// A line across the plot at one value of an axis, with a few words.
struct PlotMark {
    double value = 0.0;
    std::string label{};
    friend bool operator==(const PlotMark&, const PlotMark&) = default;
};

/// A shaded range of the x axis, with a few words in the legend.
struct PlotBand {
    double from = 0.0, to = 0.0;  ///< from <= to
    std::string label{};
    friend bool operator==(const PlotBand&, const PlotBand&) = default;
};

/// What an axis spans, but for a little room at both ends.
struct PlotRange {
    double from = 0.0, to = 1.0;  ///< from < to
    friend bool operator==(const PlotRange&, const PlotRange&) = default;
};

struct Plot {
    std::string title, xLabel, yLabel;
    bool logX = false, logY = false;  ///< a logarithmic axis leaves out values that are not above 0
    std::vector<PlotSeries> series{};
    std::vector<PlotMark> marksX{};  ///< upright lines, each at a value of the x axis
    std::vector<PlotMark> marksY{};  ///< level lines, each at a value of the y axis
    std::vector<PlotBand> bands{};
    /// What the axes span, whatever the values are; empty: all values of the series. Marks and bands outside are not
    /// drawn.
    std::optional<PlotRange> rangeX{}, rangeY{};
    friend bool operator==(const Plot&, const Plot&) = default;
};

}  // namespace echolucent
