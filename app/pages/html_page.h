// A report as one HTML file with all it needs inside: text, tables, plots as SVG, pictures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "processing/picture/picture.h"
#include "processing/plots/plot.h"

namespace echolucent {

/// The plot as an SVG element, with axes, ticks, grid and legend. Colour and line style tell the series apart.
[[nodiscard]] std::string svgOf(const Plot& plot);

/// A matrix of values in [0,1] as a picture: rows downwards, columns to the right (an OTF-over-angle map).
struct HeatMap {
    std::string title, xLabel, yLabel;
    double xFirst = 0, xLast = 1, yFirst = 0,
           yLast = 1;  ///< values at the centres of the outermost cells; row 0 is at yFirst
    std::size_t columns = 0;
    std::vector<double> values;  ///< row-major
};

/// A picture of 8-bit red, green, blue, rows from the top.
struct PagePicture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;  ///< width * height * 3 bytes
    std::string caption;
};

/// How a row of pictures stands on a sheet.
enum class PictureRow {
    beside,  ///< the first is large, the others stand beside it, one below the other: a low row
    below,   ///< the first is as wide as the sheet, the others stand below it in a row: a high one
};

/// A report with all it needs inside. If a page exceeds its limit, all its pictures and maps are made coarser by one
/// whole factor, up to `coarsest`. Even then text, tables and plots may exceed it.
class HtmlPage {
public:
    /// The limit of a page that is kept beside many others.
    static constexpr std::size_t mostBytes = 200'000;
    /// The limit of a page whose pictures keep their size.
    static constexpr std::size_t anyBytes = std::numeric_limits<std::size_t>::max();
    /// The largest factor by which pictures are made coarser, so that something can still be seen.
    static constexpr int coarsest = 8;

    /// A page with a title and its limit in bytes. All text is escaped.
    explicit HtmlPage(std::string title, std::size_t byteLimit = mostBytes);
    void heading(const std::string& text);
    void paragraph(const std::string& text);
    /// Adds a text that keeps its ends of lines.
    void lines(const std::string& text);
    /// Adds a Markdown text as markdownMarkup() shows it, with the images of these names.
    void markdown(const std::string& text, const std::map<std::string, std::string>& images = {});
    /// Adds a table. Columns of numbers are right-aligned. `widths` are those of the columns, percent of the table;
    /// without them columns are as wide as they need.
    void table(const std::vector<std::string>& columns, const std::vector<std::vector<std::string>>& rows,
               const std::string& caption = {}, const std::vector<int>& widths = {});
    void plot(const Plot& plot);
    /// Throws std::invalid_argument if the values of `map` do not fill whole rows, or if there are none.
    void heatMap(const HeatMap& map);
    /// Adds a picture over black. Pictures stand side by side as far as the page is wide. Each pixel is shown as `zoom`
    /// pixels across and down (1 or more).
    void picture(const Picture& picture, const std::string& caption, int zoom = 1);
    /// Adds a picture of 8-bit red, green, blue, rows from the top. Throws std::invalid_argument if `rgb` does not hold
    /// width * height * 3 bytes.
    void picture(int width, int height, std::vector<std::uint8_t> rgb, const std::string& caption, int zoom = 1);
    /// Begins a sheet: what a printer puts on one side of A4 or Letter. Its row of pictures shrinks to what its texts
    /// leave, of 246 mm. Throws std::logic_error if anything was added before.
    void beginSheet();
    /// Adds pictures to a sheet. Throws std::invalid_argument as picture() does.
    void pictures(const std::vector<PagePicture>& row, PictureRow how = PictureRow::beside);
    /// Ends the sheet. What follows has a title of its own, and a printer begins another side for it. Each side of
    /// paper says that this is not a medical device.
    void appendix(const std::string& title);
    /// The whole page. Its last sentence says that this is not a medical device.
    [[nodiscard]] std::string text() const;

private:
    [[nodiscard]] std::string textAt(int coarseness) const;
    void add(std::string markup);
    void addPicture(const PagePicture& picture, int zoom);

    std::string m_title;
    std::size_t m_byteLimit;
    bool m_hasSheet = false;
    std::set<std::string> m_embedded;  ///< names of images
    /// The page's markup, piece by piece. A call gives it with pictures coarser by a factor.
    std::vector<std::function<std::string(int coarseness)>> m_pieces;
};

}  // namespace echolucent
