// A report as one HTML file that needs nothing beside it: text, tables, plots as SVG, pictures inside.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "processing/picture/picture.h"

namespace echolucent {

/// One line or cloud of points of a plot. Values that are not finite are left out and make a gap in a line.
struct PlotSeries {
    std::string name;
    std::vector<double> x, y;
    bool line = true;
    bool markers = false;
    std::vector<std::string> labels;   ///< names beside the markers; empty for none
    std::vector<std::string> names{};  ///< what each marker says under the pointer; empty where it says its label
};

struct Plot {
    std::string title, xLabel, yLabel;
    bool logX = false, logY = false;  ///< values that are not above 0 are left out of a logarithmic axis
    std::vector<PlotSeries> series;
};
/// The plot as an SVG element, with axes, ticks, grid and legend; series are told apart by colour and line style.
[[nodiscard]] std::string svgOf(const Plot& plot);

/// A matrix of values in [0,1] as a picture: rows downwards, columns to the right (an OTF-over-angle map).
struct HeatMap {
    std::string title, xLabel, yLabel;
    double xFirst = 0, xLast = 1, yFirst = 0,
           yLast = 1;  ///< values at the centres of the outermost cells; row 0 is at yFirst
    std::size_t columns = 0;
    std::vector<double> values;  ///< row-major
};

/// A report that needs nothing beside it. Where text, tables and plots leave room for it, a page keeps below a limit:
/// its pictures and maps are made coarser, all by the same whole factor, until it does.
class HtmlPage {
public:
    /// The limit of a page that is kept beside many others.
    static constexpr std::size_t mostBytes = 200'000;
    /// The limit of a page whose pictures are to stay as they are.
    static constexpr std::size_t anyBytes = std::numeric_limits<std::size_t>::max();
    /// The pictures of a page are never made coarser than by this factor, so that something is still seen.
    static constexpr int coarsest = 8;

    /// A page with a title and its limit in bytes. Text is escaped everywhere.
    explicit HtmlPage(std::string title, std::size_t byteLimit = mostBytes);
    void heading(const std::string& text);
    void paragraph(const std::string& text);
    /// Adds a table. Columns that hold numbers are right-aligned.
    void table(const std::vector<std::string>& columns, const std::vector<std::vector<std::string>>& rows,
               const std::string& caption = {});
    void plot(const Plot& plot);
    void heatMap(const HeatMap& map);
    /// The picture over black, side by side with what follows, as far as the page is wide. Each pixel is shown as
    /// `zoom` pixels across and down (1 or more).
    void picture(const Picture& picture, const std::string& caption, int zoom = 1);
    /// The same of 8-bit red, green, blue, rows from the top. Throws std::invalid_argument where `rgb` does not hold
    /// width * height * 3 bytes.
    void picture(int width, int height, std::vector<std::uint8_t> rgb, const std::string& caption, int zoom = 1);
    /// The whole page; ends with the sentence that this is not a medical device.
    [[nodiscard]] std::string text() const;

private:
    [[nodiscard]] std::string textAt(int coarseness) const;
    void add(std::string markup);

    std::string m_title;
    std::size_t m_byteLimit;
    /// The page's markup, piece by piece, with pictures coarser by a factor.
    std::vector<std::function<std::string(int coarseness)>> m_pieces;
};

}  // namespace echolucent
