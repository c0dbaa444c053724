// The report page and its plots: well-formed, escaped, readable, and true to what was given.
#include "app/pages/html_page.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <regex>
#include <set>
#include <stdexcept>

#include "app/measuring/study.h"
#include "app/pages/html_text.h"
#include "processing/adaptive/method_parameters.h"
#include "processing/plots/plot_axis.h"
#include "processing/plots/series_style.h"
#include "tests/cli/well_formed.h"

namespace echolucent::cli {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::size_t countOf(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
    return count;
}

Plot plotOf(std::vector<PlotSeries> series) {
    return {.title = "Title", .xLabel = "across", .yLabel = "up", .series = std::move(series)};
}

PlotSeries markersOf(std::vector<double> x, std::vector<double> y) {
    return {.name = "some", .x = std::move(x), .y = std::move(y), .line = false, .markers = true, .labels = {}};
}

TEST(HtmlText, EscapesWhatMarkupMeans) {
    EXPECT_EQ(escaped("a<b> & \"c\" 'd'\x01"), "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39; ");
    EXPECT_EQ(escaped("Δα ≤ 1"), "Δα ≤ 1");
}

TEST(HtmlText, PicturesAreBase64OfThePng) {
    const std::vector<std::uint8_t> rgb{255, 0, 0, 0, 255, 0};
    const std::string uri = pngDataUri(2, 1, rgb);
    // The eight bytes every PNG begins with, in base64.
    EXPECT_TRUE(uri.starts_with("data:image/png;base64,iVBORw0KGgo")) << uri;
    EXPECT_EQ((uri.size() - uri.find(',') - 1) % 4, 0U);
}

TEST(Plot, IsWellFormedWithAnyNames) {
    Plot plot = plotOf({markersOf({1, 2}, {3, 4})});
    plot.title = "<script>alert(1)</script> & \"more\"";
    plot.series[0].name = "a < b";
    plot.series[0].labels = {"<b>", "'"};
    const std::string svg = svgOf(plot);
    EXPECT_EQ(problemOf(svg), "");
    EXPECT_EQ(svg.find("<script>"), std::string::npos);
    EXPECT_NE(svg.find("&lt;b&gt;"), std::string::npos);
}

TEST(Plot, NothingToShowIsAnEmptyFrame) {
    for (const bool logarithmic : {false, true}) {
        Plot plot = plotOf({markersOf({nan}, {1}), {}});
        plot.logX = plot.logY = logarithmic;
        const std::string svg = svgOf(plot);
        EXPECT_EQ(problemOf(svg), "");
        EXPECT_EQ(svg.find("nan"), std::string::npos);
        EXPECT_EQ(svg.find("inf"), std::string::npos);
    }
}

TEST(Plot, ALogarithmicAxisLeavesOutWhatIsNotAboveZero) {
    const PlotSeries series = markersOf({1, 10, 100, 1000}, {0, -1, 2, 3});
    // There is one marker in the legend beside those in the plot.
    EXPECT_EQ(countOf(svgOf(plotOf({series})), "class=\"marker"), 5U);
    Plot plot = plotOf({series});
    plot.logY = true;
    EXPECT_EQ(countOf(svgOf(plot), "class=\"marker"), 3U);
}

TEST(Plot, AValueThatIsNotFiniteIsAGap) {
    PlotSeries line;
    line.x = {0, 1, 2, 3, 4};
    line.y = {0, 1, nan, 1, 0};
    const std::string svg = svgOf(plotOf({line}));
    static const std::regex path("class=\"line[^>]* d=\"([^\"]*)\"");
    std::smatch found;
    ASSERT_TRUE(std::regex_search(svg, found, path));
    EXPECT_EQ(countOf(found[1], "M"), 2U);
    EXPECT_EQ(countOf(found[1], "L"), 2U);
}

TEST(Plot, ALineHasThePointsThatItsShapeNeeds) {
    PlotSeries line;
    for (int i = 0; i <= 1000; ++i) {
        line.x.push_back(i);
        line.y.push_back(i <= 300 ? 0.0 : i - 300.0);
    }
    const std::string svg = svgOf(plotOf({line}));
    static const std::regex path("class=\"line[^>]* d=\"([^\"]*)\"");
    std::smatch found;
    ASSERT_TRUE(std::regex_search(svg, found, path));
    EXPECT_EQ(countOf(found[1], "L"), 2U) << "the kink and the end: " << found[1];
}

TEST(Plot, SeriesOfTheCurvesHaveTheirColours) {
    std::vector<PlotSeries> series(7);
    const char* names[] = {"other", "quartic", "linear, eq. 1", "adaptive", "parabolic", "manual", "adaptive, settled"};
    for (std::size_t i = 0; i < series.size(); ++i) series[i].name = names[i];
    EXPECT_EQ(coloursOf(series), (std::vector<std::size_t>{5, 4, 2, 0, 3, 1, 6}));
    const auto many = coloursOf(std::vector<PlotSeries>(20));
    EXPECT_EQ(many.size(), 20U);
    EXPECT_EQ(std::set<std::size_t>(many.begin(), many.end()).size(), seriesColours.size());
}

/// WCAG 2's relative luminance of "#rrggbb".
double luminance(std::string_view colour) {
    double sum = 0;
    for (const auto& [at, weight] : {std::pair{1, 0.2126}, {3, 0.7152}, {5, 0.0722}}) {
        const double c = std::stoi(std::string(colour.substr(static_cast<std::size_t>(at), 2)), nullptr, 16) / 255.0;
        sum += weight * (c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
    }
    return sum;
}

TEST(Plot, ColoursStandOffTheirGround) {
    for (const SeriesColour& colour : seriesColours) {
        EXPECT_GE(1.05 / (luminance(colour.onLight) + 0.05), 4.5) << colour.onLight;
        EXPECT_GE((luminance(colour.onDark) + 0.05) / (luminance("#16191d") + 0.05), 4.5) << colour.onDark;
    }
}

TEST(Plot, MarksAndBandsStandAtTheirValues) {
    PlotSeries line{.name = "some", .x = {0, 10}, .y = {0, 1}};
    Plot plot = plotOf({line});
    plot.rangeX = PlotRange{0, 10};
    plot.marksX = {{5, "surface < here"}, {50, "outside"}};
    plot.marksY = {{0.5, "threshold"}};
    plot.bands = {{2, 4, "range"}, {6, 8, "range"}};
    const std::string svg = svgOf(plot);
    EXPECT_EQ(problemOf(svg), "");
    EXPECT_EQ(countOf(svg, "class=\"mark\""), 2U) << "a mark outside is not drawn";
    EXPECT_EQ(countOf(svg, ">range</text>"), 1U) << "the legend names bands of one name once";
    // The line runs from corner to corner, so its middle is the middle of the plot, where both marks cross.
    const double middle = (78.0 + 736.0) / 2;
    EXPECT_NE(svg.find(fmt::format("d=\"M{:.1f} 40V384\"", middle)), std::string::npos);
    EXPECT_NE(svg.find("d=\"M78 212.0H736\""), std::string::npos);
}

TEST(Plot, FaintSeriesAreGreyAndTakeNoColour) {
    std::vector<PlotSeries> series(3);
    series[0].weight = PlotWeight::faint;
    series[0].name = "adaptive, others";
    series[1].name = "adaptive";
    EXPECT_EQ(coloursOf(series), (std::vector<std::size_t>{seriesColours.size(), 0, 1}));
    EXPECT_EQ(colourAt(seriesColours.size()).onLight, faintColour.onLight);
}

TEST(PlotAxis, ARangeHoldsWhateverTheValuesAre) {
    const PlotAxis axis({0.4, 0.5}, false, PlotRange{0, 1}), larger({-3, 7}, false, PlotRange{0, 1});
    EXPECT_EQ(axis.placeOf(0.25), larger.placeOf(0.25));
    EXPECT_NEAR(axis.placeOf(0.5), 0.5, 1e-12);
    const PlotAxis none({2, 4}, false, PlotRange{1, 1});
    EXPECT_NEAR(none.placeOf(3), 0.5, 1e-12) << "an empty range is none";
}

TEST(PlotAxis, TicksAreRoundAndWithin) {
    for (const auto& [low, high] :
         {std::pair{0.0, 1.0}, {-3.7, 12.2}, {1e-7, 3e-7}, {99999.0, 100001.0}, {5.0, 5.0}, {0.0, 0.0}}) {
        const PlotAxis axis({low, high}, false);
        EXPECT_GE(axis.ticks().size(), 2U) << low << " " << high;
        EXPECT_LE(axis.ticks().size(), 12U);
        for (const PlotTick& tick : axis.ticks()) {
            EXPECT_GE(axis.placeOf(tick.value), -1e-9);
            EXPECT_LE(axis.placeOf(tick.value), 1 + 1e-9);
        }
        EXPECT_GT(axis.placeOf(low), 0.0);
        EXPECT_LT(axis.placeOf(high), 1.0);
    }
}

TEST(PlotAxis, LogarithmicPlacesAreEvenByDecade) {
    const PlotAxis axis({0.0, -5.0, 0.01, 0.1, 100}, true);
    EXPECT_FALSE(axis.shows(0));
    EXPECT_FALSE(axis.shows(-5));
    EXPECT_TRUE(axis.shows(0.01));
    EXPECT_NEAR(axis.placeOf(0.1) - axis.placeOf(0.01), axis.placeOf(100) - axis.placeOf(10), 1e-12);
    std::vector<std::string> labels;
    for (const PlotTick& tick : axis.ticks())
        if (!tick.label.empty()) labels.push_back(tick.label);
    EXPECT_EQ(labels, (std::vector<std::string>{"0.01", "0.1", "1", "10", "100"}));
    for (const auto& [low, high] : {std::pair{1.1, 1.9}, {3.0, 3.0}, {1e-300, 1e300}}) {
        std::size_t labelled = 0;
        const PlotAxis wide({low, high}, true);
        for (const PlotTick& tick : wide.ticks()) labelled += !tick.label.empty();
        EXPECT_GE(labelled, 2U) << low;
        EXPECT_LE(labelled, 12U) << low;
    }
}

TEST(PlotAxis, NumbersAreShort) {
    EXPECT_EQ(shortNumber(0.1 + 0.2), "0.3");
    EXPECT_EQ(shortNumber(1e-7), "1e-7");
    EXPECT_EQ(shortNumber(2.5e12), "2.5e12");
    EXPECT_EQ(shortNumber(-40), "-40");
}

TEST(HtmlPage, HoldsEverythingAndIsWellFormed) {
    HtmlPage page("A & <B>");
    page.heading("<i>heading</i>");
    page.paragraph("x < y");
    page.table({"name", "value"}, {{"a<b", "1.5×"}, {"b", "—"}}, "caption & more");
    page.plot(plotOf({markersOf({1, 2}, {3, 4})}));
    page.heatMap({"map", "across", "down", -45, 45, 0, 1, 3, {0, 0.5, 1, nan, 2, -1}});
    Picture picture{2, 1, {1, 0, 0, 1, 0, 0, 0, 0}, {}};
    page.picture(picture, "seen \"so\"");
    const std::string text = page.text();
    EXPECT_EQ(problemOf(text), "");
    EXPECT_NE(text.find("&lt;i&gt;heading"), std::string::npos);
    EXPECT_NE(text.find("<td>a&lt;b</td><td class=\"number\">1.5×</td>"), std::string::npos) << text;
    EXPECT_EQ(countOf(text, "data:image/png;base64,"), 3U) << "a picture, and two images of a map";
    EXPECT_NE(text.find("not a medical device"), std::string::npos);
    // The page is self-contained: the only addresses are the name of SVG's vocabulary.
    EXPECT_EQ(countOf(text, "http"), countOf(text, "http://www.w3.org/2000/svg"));
    EXPECT_EQ(text.find("<script"), std::string::npos);
}

/// A picture that no compression makes small: random grey levels of 8 bits.
Picture noise(int edge) {
    Picture picture{edge, edge, {}, {}};
    std::mt19937 random(7);
    for (int i = 0; i < edge * edge; ++i) {
        const float level = static_cast<float>(random() % 256) / 255.0f;
        picture.rgba.insert(picture.rgba.end(), {level, level, level, 1.0f});
    }
    return picture;
}

TEST(HtmlPage, KeepsItsLimitWhateverPicturesItHolds) {
    HtmlPage small("few"), large("many");
    small.picture(noise(100), "one");
    for (int i = 0; i < 20; ++i) large.picture(noise(200), "one of many");
    large.heatMap({"map", "across", "down", 0, 1, 0, 1, 300, std::vector<double>(300 * 300, 0.5)});
    EXPECT_GT(small.text().size(), 10000U) << "a page with room shows each pixel";
    const std::string text = large.text();
    EXPECT_LE(text.size(), HtmlPage::mostBytes);
    EXPECT_EQ(problemOf(text), "");
    EXPECT_EQ(countOf(text, "width=\"200\" height=\"200\""), 20U) << "coarser pictures take the same room";
}

TEST(HtmlPage, APageWithoutALimitKeepsEveryPixel) {
    HtmlPage limited("limited"), whole("whole", HtmlPage::anyBytes);
    for (HtmlPage* page : {&limited, &whole}) page->picture(noise(700), "large");
    EXPECT_LE(limited.text().size(), HtmlPage::mostBytes);
    const std::string text = whole.text();
    EXPECT_GT(text.size(), 490'000U) << "that many bytes random pixels have";
    EXPECT_EQ(countOf(text, "class=\"pixels\""), 0U);
}

TEST(HtmlPage, BytesThatDoNotFillAPictureAreRefused) {
    HtmlPage page("bytes");
    EXPECT_THROW(page.picture(2, 2, std::vector<std::uint8_t>(11), "short"), std::invalid_argument);
    EXPECT_THROW(page.picture(0, 2, {}, "empty"), std::invalid_argument);
    page.picture(2, 2, std::vector<std::uint8_t>(12), "whole");
    EXPECT_EQ(countOf(page.text(), "<img"), 1U);
}

PagePicture pictureCalled(const std::string& caption) { return {2, 2, std::vector<std::uint8_t>(12, 90), caption}; }

TEST(HtmlPage, ASheetEndsAtItsAppendix) {
    HtmlPage page("case");
    page.beginSheet();
    page.paragraph("first");
    page.pictures({pictureCalled("large"), pictureCalled("one"), pictureCalled("other")});
    page.lines("two\nlines <b>");
    page.table({"name", "value"}, {{"BPD", "47.1"}}, {}, {70, 30});
    page.appendix("the rest");
    page.paragraph("second");
    const std::string text = page.text();
    EXPECT_EQ(problemOf(text), "");
    const auto at = [&text](const std::string& part) { return text.find(part, text.find("<body>")); };
    EXPECT_EQ(at("<section class=\"sheet\">\n<h1>case</h1>"), at("<body>") + 7);
    EXPECT_LT(at("first"), at("</section>\n<section class=\"appendix\">\n<h1>the rest</h1>"));
    EXPECT_LT(at("<h1>the rest</h1>"), at("second"));
    EXPECT_LT(at("alt=\"large\""), at("<div class=\"others\">"));
    EXPECT_LT(at("<div class=\"others\">"), at("alt=\"one\""));
    EXPECT_NE(at("<p class=\"lines\">two\nlines &lt;b&gt;</p>"), std::string::npos);
    // Of 182 mm the others have a quarter, a gap 2.6 mm, and each picture a caption of 5 mm.
    EXPECT_NE(at("<div class=\"row\" style=\"--most:139mm;--large:139;--others:101\">"), std::string::npos)
        << text.substr(at("<div"), 80);
    EXPECT_NE(at("<col style=\"width:70%\"/>"), std::string::npos);
    EXPECT_EQ(countOf(text, "<h1>"), 2U);
    for (const char* rule : {"@page{", "break-after:page", "footer{position:fixed"})
        EXPECT_EQ(countOf(text, rule), 1U) << rule;
    HtmlPage high("high");
    high.beginSheet();
    high.pictures({pictureCalled("large"), pictureCalled("one"), pictureCalled("other")}, PictureRow::below);
    EXPECT_EQ(problemOf(high.text()), "");
    EXPECT_EQ(countOf(high.text(), "<div class=\"row below\" style=\"--most:284mm;--large:187;--others:95\">"), 1U);
    // A page without a sheet is as ever.
    HtmlPage plain("plain");
    plain.paragraph("first");
    EXPECT_THROW(plain.beginSheet(), std::logic_error);
    EXPECT_EQ(countOf(plain.text(), "@page{"), 0U);
    EXPECT_EQ(countOf(plain.text(), "<body>\n<h1>plain</h1>\n<p>first</p>"), 1U);
}

TEST(HtmlPage, AHeatMapHasWholeRows) {
    HtmlPage page("map");
    EXPECT_THROW(page.heatMap({"map", "x", "y", 0, 1, 0, 1, 2, {0, 1, 0}}), std::invalid_argument);
    EXPECT_THROW(page.heatMap({"map", "x", "y", 0, 1, 0, 1, 0, {}}), std::invalid_argument);
}

TEST(CsvTable, QuotesAndLeavesUnknownNumbersEmpty) {
    CsvTable csv({"a", "b", "c"});
    csv.row({"x, \"y\"", 0.1, 7});
    csv.row({"", nan, -1});
    EXPECT_EQ(csv.text(), "a,b,c\n\"x, \"\"y\"\"\",0.1,7\n,,-1\n");
    EXPECT_THROW(csv.row({"too few"}), std::invalid_argument);
}

TEST(Seeds, AreListsAndRanges) {
    EXPECT_EQ(*parseSeeds("1,2,5", "--seeds"), (std::vector<std::uint64_t>{1, 2, 5}));
    EXPECT_EQ(*parseSeeds("3-5,9", "--seeds"), (std::vector<std::uint64_t>{3, 4, 5, 9}));
    EXPECT_EQ(parseSeeds("18446744073709551615", "--seeds")->front(), 18446744073709551615U);
    for (const char* wrong : {"", "a", "1,", "5-3", "-1", "1-", "1.5", "1-9999999"})
        EXPECT_FALSE(parseSeeds(wrong, "--seeds")) << wrong;
}

}  // namespace
}  // namespace echolucent::cli
