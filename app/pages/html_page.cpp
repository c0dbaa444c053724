#include "app/pages/html_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "app/pages/html_text.h"
#include "app/pages/markdown_markup.h"
#include "processing/plots/plot_axis.h"
#include "processing/plots/series_style.h"

namespace echolucent {

namespace {

constexpr std::string_view style = R"(
:root{color-scheme:light dark}
body{font:15px/1.5 system-ui,sans-serif;max-width:1600px;margin:2rem auto;padding:0 1rem;background:#fff;color:#222}
h1{font-size:1.7rem;margin-bottom:.3rem}h2{font-size:1.25rem;margin-top:2.2rem}p,ul,ol{max-width:52rem}
.scroll{overflow-x:auto}table{border-collapse:collapse;margin:1rem 0;font-size:13.5px}
caption{text-align:left;padding-bottom:.4rem;color:#555}
th,td{padding:.25rem .7rem;border-bottom:1px solid #d5d9de;text-align:left;vertical-align:top}
th{border-bottom:2px solid #888}.number{text-align:right;font-variant-numeric:tabular-nums}
figure{display:inline-block;margin:.6rem .8rem .6rem 0;vertical-align:top;max-width:100%}
figcaption{color:#555;font-size:13px;max-width:32rem}svg,img{max-width:100%;height:auto}
img.pixels{image-rendering:pixelated}
footer{margin-top:3rem;color:#555;font-size:13px}
)";
/// Of a page that has a sheet. On paper the sheet is a column in which the row of pictures takes what texts leave.
constexpr std::string_view sheetStyle = R"(
.lines{white-space:pre-line;overflow-wrap:anywhere}
.sheet{max-width:1000px}.sheet p{max-width:none;margin:.4rem 0}.sheet h2{margin:1.2rem 0 .2rem}
.sheet table{width:100%;table-layout:fixed;margin:.4rem 0}.sheet td{overflow-wrap:anywhere}
.row{display:flex;gap:10px;margin:.8rem 0}.row figure{margin:0;flex:1 1 0;min-width:0}
.others{flex:0 0 25%;display:flex;flex-direction:column;gap:8px}.others figure{flex:none}
.below{flex-direction:column}.below .others{flex-direction:row;flex:none}.below .others figure{flex:1 1 0}
.appendix{margin-top:4rem}
@page{margin:12mm 14mm}
@media print{
body{font-size:9.5pt;line-height:1.35;margin:0;padding:0;max-width:none}
h1{font-size:15pt;margin:0 0 1mm}h2{font-size:11pt;margin:4mm 0 1mm;break-after:avoid}
table{font-size:9pt;margin:1mm 0}th,td{padding:.5mm 2mm}tr,figure{break-inside:avoid}
figcaption,footer{font-size:8pt}
.sheet{height:246mm;max-width:none;display:flex;flex-direction:column;break-after:page}
.sheet p{margin:0 0 1mm}.sheet h2{margin:2.5mm 0 .5mm}.sheet table{margin:0}
.sheet .row{flex:1 1 0;min-height:0;max-height:var(--most);margin:1mm 0}
.sheet figure{display:flex;flex-direction:column;min-height:0;break-inside:auto}
.sheet figcaption{order:-1}
.sheet img{flex:1 1 0;min-height:0;width:100%;object-fit:contain;object-position:left top}
.sheet .others{gap:1mm}.sheet .others figure{flex:1 1 0}
.sheet .below .large{flex:var(--large) 1 0;display:flex;min-height:0}
.sheet .below .others{flex:var(--others) 1 0;min-height:0}
.appendix{margin:0;padding-bottom:7mm;-webkit-box-decoration-break:clone;box-decoration-break:clone}
footer{position:fixed;bottom:0;left:0;margin:0}
}
)";
constexpr std::string_view darkStyle =
    "body{background:#16191d;color:#dde1e6}caption,figcaption,footer{color:#a3abb5}"
    "th,td{border-color:#343a42}th{border-color:#7c8591}svg .ink{fill:#dde1e6}svg .grid{stroke:#343a42}"
    "svg .frame{stroke:#7c8591}svg .band{fill:#2a3139}svg .mark{stroke:#a3abb5}";

std::string wholeStyle() {
    std::string dark(darkStyle);
    for (std::size_t i = 0; i <= seriesColours.size(); ++i)
        dark += fmt::format("svg path.c{0}{{stroke:{1}}}svg path.marker.c{0}{{stroke:none;fill:{1}}}", i,
                            colourAt(i).onDark);
    return std::string(style) + "@media screen and (prefers-color-scheme:dark){" + dark + "}\n";
}

/// Whether a cell has no value: tables show dashes or blanks then.
bool isBlank(const std::string& cell) { return cell.empty() || cell == "-" || cell == "—" || cell == "–"; }

bool isNumeric(const std::string& cell) {
    std::size_t at = cell.find_first_not_of("+-<>≤≥− ");
    return at != std::string::npos && std::isdigit(static_cast<unsigned char>(cell[at]));
}

std::vector<bool> numericColumns(std::size_t columns, const std::vector<std::vector<std::string>>& rows) {
    std::vector<bool> numeric(columns, false);
    for (std::size_t c = 0; c < columns; ++c) {
        bool any = false, all = true;
        for (const auto& row : rows) {
            if (c >= row.size() || isBlank(row[c])) continue;
            any = true;
            all = all && isNumeric(row[c]);
        }
        numeric[c] = any && all;
    }
    return numeric;
}

/// Values in [0,1] as colours of the viridis map, which looks even to everyone, the colour-blind too. A value that is
/// not finite is grey.
std::vector<std::uint8_t> coloured(const std::vector<double>& values) {
    constexpr std::uint8_t greyOfNone = 128;
    cv::Mat levels(1, static_cast<int>(values.size()), CV_8U), bgr;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double value = std::isfinite(values[i]) ? std::clamp(values[i], 0.0, 1.0) : 0.0;
        levels.at<std::uint8_t>(static_cast<int>(i)) = static_cast<std::uint8_t>(std::lround(value * 255.0));
    }
    cv::applyColorMap(levels, bgr, cv::COLORMAP_VIRIDIS);
    std::vector<std::uint8_t> rgb(values.size() * 3);
    for (std::size_t i = 0; i < values.size(); ++i)
        for (std::size_t channel = 0; channel < 3; ++channel)
            rgb[3 * i + channel] = std::isfinite(values[i])
                                       ? bgr.at<cv::Vec3b>(static_cast<int>(i))[2 - static_cast<int>(channel)]
                                       : greyOfNone;
    return rgb;
}

std::string inkText(double x, double y, std::string_view anchor, const std::string& text) {
    return fmt::format("<text class=\"ink\" fill=\"#333\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x,
                       y, anchor, escaped(text));
}

std::string stretchedImage(double x, double y, double width, double height, const std::string& uri) {
    return fmt::format(
        "<image x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\" preserveAspectRatio=\"none\" "
        "style=\"image-rendering:pixelated\" href=\"{4}\"/>\n",
        x, y, width, height, uri);
}

/// 8-bit RGB. Each pixel is the mean of `square` * `square` pixels; in the last row and column it may be of fewer.
struct CoarsePicture {
    int width, height;
    std::vector<std::uint8_t> rgb;
};
CoarsePicture coarser(int width, int height, std::vector<std::uint8_t> rgb, int square) {
    if (square == 1) return {width, height, std::move(rgb)};
    const cv::Mat whole(height, width, CV_8UC3, rgb.data());
    cv::Mat small;
    cv::resize(whole, small, cv::Size((width + square - 1) / square, (height + square - 1) / square), 0, 0,
               cv::INTER_AREA);
    return {small.cols, small.rows, {small.datastart, small.dataend}};
}

/// The map, with ticks at its sides and the scale of its colours.
std::string heatMapSvg(const HeatMap& map, int coarseness) {
    constexpr double left = 78, top = 40, wide = 560, high = 344, barLeft = 664, barWide = 18, steps = 5;
    const int columns = static_cast<int>(map.columns), rows = static_cast<int>(map.values.size() / map.columns);
    std::string body = fmt::format(
        "<text class=\"ink\" fill=\"#333\" x=\"{}\" y=\"24\" font-size=\"15\" font-weight=\"bold\">{}</text>\n", left,
        escaped(map.title));
    const CoarsePicture image = coarser(columns, rows, coloured(map.values), coarseness);
    body += stretchedImage(left, top, wide, high, pngDataUri(image.width, image.height, image.rgb));
    std::vector<double> scale(64);
    for (std::size_t i = 0; i < scale.size(); ++i) scale[i] = 1.0 - static_cast<double>(i) / 63.0;
    body += stretchedImage(barLeft, top, barWide, high, pngDataUri(1, 64, coloured(scale)));
    for (int i = 0; i <= static_cast<int>(steps); ++i) {
        const double share = i / steps;
        // The first and the last value belong to the centres of the outermost cells, half a cell inside the picture.
        const double x = left + wide * (0.5 + share * (columns - 1)) / columns;
        const double y = top + high * (0.5 + share * (rows - 1)) / rows;
        body += inkText(x, top + high + 18, "middle", shortNumber(map.xFirst + share * (map.xLast - map.xFirst)));
        body += inkText(left - 8, y + 4, "end", shortNumber(map.yFirst + share * (map.yLast - map.yFirst)));
        body += inkText(barLeft + barWide + 8, top + high * (1 - share) + 4, "start", shortNumber(share));
    }
    body += inkText(left + wide / 2, top + high + 38, "middle", map.xLabel);
    body += fmt::format(
        "<text class=\"ink\" fill=\"#333\" x=\"18\" y=\"{0}\" text-anchor=\"middle\" transform=\"rotate(-90 18 "
        "{0})\">{1}"
        "</text>\n",
        top + high / 2, escaped(map.yLabel));
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 760 436\" width=\"760\" height=\"436\" role=\"img\" "
        "font-family=\"sans-serif\" font-size=\"12\">\n<title>{}</title>\n{}</svg>\n",
        escaped(map.title), body);
}

/// The heights that pictures take on A4, mm: there is no use in more.
struct HeightsOnPaper {
    double large = 0.0, others = 0.0, row = 0.0;
};
HeightsOnPaper heightsOnPaper(const std::vector<PagePicture>& row, PictureRow how) {
    constexpr double wide = 182.0, gap = 2.6, caption = 5.0;
    const auto height = [](const PagePicture& picture, double width) {
        return width * picture.height / std::max(1, picture.width) + caption;
    };
    const bool below = how == PictureRow::below;
    const auto count = static_cast<double>(row.size() - 1);
    const double narrow = below ? (wide - gap * (count - 1)) / count : 0.25 * wide;
    HeightsOnPaper heights{.large = height(row.front(), below || count == 0 ? wide : wide - narrow - gap)};
    for (std::size_t i = 1; i < row.size(); ++i) {
        const double next = height(row[i], narrow);
        heights.others = below ? std::max(heights.others, next) : heights.others + next;
    }
    heights.row = below ? heights.large + heights.others + gap : std::max(heights.large, heights.others);
    return heights;
}

}  // namespace

HtmlPage::HtmlPage(std::string title, std::size_t byteLimit) : m_title(std::move(title)), m_byteLimit(byteLimit) {}

void HtmlPage::add(std::string markup) {
    m_pieces.emplace_back([markup = std::move(markup)](int) { return markup; });
}

void HtmlPage::heading(const std::string& text) { add("<h2>" + escaped(text) + "</h2>\n"); }

void HtmlPage::paragraph(const std::string& text) { add("<p>" + escaped(text) + "</p>\n"); }

void HtmlPage::lines(const std::string& text) { add("<p class=\"lines\">" + escaped(text) + "</p>\n"); }

void HtmlPage::markdown(const std::string& text, const std::map<std::string, std::string>& images) {
    add(markdownMarkup(text, images, m_embedded));
}

void HtmlPage::table(const std::vector<std::string>& columns, const std::vector<std::vector<std::string>>& rows,
                     const std::string& caption, const std::vector<int>& widths) {
    const auto numeric = numericColumns(columns.size(), rows);
    const auto cell = [&](std::string_view tag, std::size_t column, const std::string& text) {
        const bool right = column < numeric.size() && numeric[column];
        return fmt::format("<{0}{1}>{2}</{0}>", tag, right ? " class=\"number\"" : "", escaped(text));
    };
    std::string markup = "<div class=\"scroll\"><table>\n";
    if (!caption.empty()) markup += "<caption>" + escaped(caption) + "</caption>\n";
    if (!widths.empty()) {
        markup += "<colgroup>";
        for (const int width : widths) markup += fmt::format("<col style=\"width:{}%\"/>", width);
        markup += "</colgroup>\n";
    }
    markup += "<thead><tr>";
    for (std::size_t c = 0; c < columns.size(); ++c) markup += cell("th", c, columns[c]);
    markup += "</tr></thead>\n<tbody>\n";
    for (const auto& row : rows) {
        markup += "<tr>";
        for (std::size_t c = 0; c < row.size(); ++c) markup += cell("td", c, row[c]);
        markup += "</tr>\n";
    }
    add(markup + "</tbody></table></div>\n");
}

void HtmlPage::plot(const Plot& plot) { add("<figure>" + echolucent::svgOf(plot) + "</figure>\n"); }

void HtmlPage::heatMap(const HeatMap& map) {
    if (map.columns == 0 || map.values.empty() || map.values.size() % map.columns != 0)
        throw std::invalid_argument("HtmlPage::heatMap: the values do not fill whole rows");
    m_pieces.emplace_back([map](int coarseness) { return "<figure>" + heatMapSvg(map, coarseness) + "</figure>\n"; });
}

void HtmlPage::picture(const Picture& picture, const std::string& caption, int zoom) {
    this->picture(picture.width, picture.height, overBackground(picture, {0, 0, 0}), caption, zoom);
}

void HtmlPage::picture(int width, int height, std::vector<std::uint8_t> rgb, const std::string& caption, int zoom) {
    addPicture({width, height, std::move(rgb), caption}, zoom);
}

void HtmlPage::addPicture(const PagePicture& picture, int zoom) {
    const int width = picture.width, height = picture.height;
    if (width < 1 || height < 1 ||
        picture.rgb.size() != std::size_t{3} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
        throw std::invalid_argument("HtmlPage::picture: the bytes do not fill the picture");
    m_pieces.emplace_back([picture, zoom](int coarseness) {
        const CoarsePicture image = coarser(picture.width, picture.height, picture.rgb, coarseness);
        const bool pixelated = zoom > 1 || coarseness > 1;
        return fmt::format(
            "<figure><img alt=\"{0}\" width=\"{1}\" height=\"{2}\"{4} src=\"{3}\"/>"
            "<figcaption>{0}</figcaption></figure>\n",
            escaped(picture.caption), picture.width * zoom, picture.height * zoom,
            pngDataUri(image.width, image.height, image.rgb), pixelated ? " class=\"pixels\"" : "");
    });
}

void HtmlPage::beginSheet() {
    if (!m_pieces.empty()) throw std::logic_error("HtmlPage::beginSheet: the sheet is not the first of the page");
    m_hasSheet = true;
    add("<section class=\"sheet\">\n<h1>" + escaped(m_title) + "</h1>\n");
}

void HtmlPage::pictures(const std::vector<PagePicture>& row, PictureRow how) {
    if (row.empty()) return;
    const HeightsOnPaper heights = heightsOnPaper(row, how);
    add(fmt::format("<div class=\"row{}\" style=\"--most:{:.0f}mm;--large:{:.0f};--others:{:.0f}\">\n",
                    how == PictureRow::below ? " below" : "", heights.row, heights.large, heights.others));
    if (how == PictureRow::below) add("<div class=\"large\">\n");
    addPicture(row.front(), 1);
    if (how == PictureRow::below) add("</div>\n");
    if (row.size() > 1) {
        add("<div class=\"others\">\n");
        for (std::size_t i = 1; i < row.size(); ++i) addPicture(row[i], 1);
        add("</div>\n");
    }
    add("</div>\n");
}

void HtmlPage::appendix(const std::string& title) {
    add("</section>\n<section class=\"appendix\">\n<h1>" + escaped(title) + "</h1>\n");
}

std::string HtmlPage::text() const {
    std::string text = textAt(1);
    for (int coarseness = 2; coarseness <= coarsest && text.size() > m_byteLimit; ++coarseness)
        text = textAt(coarseness);
    return text;
}

std::string HtmlPage::textAt(int coarseness) const {
    std::string body;
    if (!m_hasSheet) body += "<h1>" + escaped(m_title) + "</h1>\n";
    for (const auto& piece : m_pieces) body += piece(coarseness);
    if (m_hasSheet) body += "</section>\n";
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" "
           "content=\"width=device-width, initial-scale=1\"/>\n<title>" +
           escaped(m_title) + "</title>\n<style>" + wholeStyle() +
           (m_hasSheet ? std::string(sheetStyle) : std::string()) + "</style>\n</head>\n<body>\n" + body +
           "<footer>Echolucent is not a medical device.</footer>\n</body>\n</html>\n";
}

}  // namespace echolucent
