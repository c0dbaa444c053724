#include "app/report/first_page.h"

#include <algorithm>

#include "processing/one_line.h"

namespace echolucent {

namespace {

// A sheet has 182 mm beside its margins on A4, and 255 mm on Letter. Title, patient, pictures of at least 80 mm, the
// titles of the texts and the foot leave 100 mm for texts.
constexpr double heightOfTexts = 100.0, heightOfOne = 35.0;  // mm
constexpr double lineHeight = 4.6, rowGap = 1.4;             // mm, at the sizes of the sheet's style
// Letters of a wide font in a line: of the sheet, and of the table's columns.
constexpr int sheetWidth = 84, nameWidth = 20, commentWidth = 44;
constexpr std::size_t mostLinesOfRow = 2;

std::size_t linesOf(std::string_view text, int width) { return endsOfLines(text, width).size(); }

double heightOf(std::string_view text) {
    return text.empty() ? 0.0 : lineHeight * static_cast<double>(linesOf(text, sheetWidth));
}

FirstPageText firstLines(std::string_view text, std::size_t lines, int width) {
    const std::vector<std::size_t> ends = endsOfLines(text, width);
    if (ends.size() <= lines) return {std::string(text), true};
    if (lines == 0) return {"…", false};
    return {std::string(text.substr(0, ends[lines - 1])) + " …", false};
}

FirstPageText fittedTo(std::string_view text, double height) {
    return firstLines(text, static_cast<std::size_t>(std::max(1.0, height / lineHeight + 1e-9)), sheetWidth);
}

/// A row whose name and comment have few lines; `isWhole` becomes false if one was cut. So the first row always fits.
FirstPageRow shortened(FirstPageRow row, bool& isWhole) {
    FirstPageText name = firstLines(row.name, mostLinesOfRow, nameWidth);
    FirstPageText comment = firstLines(row.comment, mostLinesOfRow, commentWidth);
    row.name = std::move(name.text);
    row.comment = std::move(comment.text);
    isWhole = isWhole && name.isWhole && comment.isWhole;
    return row;
}

double heightOf(const FirstPageRow& row) {
    const std::size_t lines = std::max(linesOf(row.name, nameWidth), linesOf(row.comment, commentWidth));
    return lineHeight * static_cast<double>(lines) + rowGap;
}

}  // namespace

std::vector<std::size_t> endsOfLines(std::string_view text, int width) {
    constexpr auto none = std::string_view::npos;
    std::vector<std::size_t> ends;
    std::size_t blank = none;  // the last one in the line
    int used = 0, usedToBlank = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t bytes = firstLetters(text.substr(at), 1).size();
        if (text[at] == '\n') {
            ends.push_back(at);
            blank = none;
            used = 0;
        } else {
            const int letter = bytes > 2 ? 2 : 1;
            if (used + letter > width && text[at] != ' ') {
                ends.push_back(blank == none ? at : blank);
                used = blank == none ? 0 : used - usedToBlank;
                blank = none;
            }
            used += letter;
            if (text[at] == ' ') {
                blank = at;
                usedToBlank = used;
            }
        }
        at += bytes;
    }
    ends.push_back(text.size());
    return ends;
}

FirstPageTexts textsOfFirstPage(const std::vector<FirstPageRow>& rows, std::string_view impression,
                                std::string_view comment) {
    FirstPageTexts texts;
    double forImpression = std::min(heightOf(impression), heightOfOne);
    double forComment = std::min(heightOf(comment), heightOfOne);
    double left = heightOfTexts - forImpression - forComment;
    for (const FirstPageRow& row : rows) {
        bool isWhole = true;
        FirstPageRow next = shortened(row, isWhole);
        const double height = heightOf(next);
        if (height > left) break;
        left -= height;
        texts.rowsAreWhole = texts.rowsAreWhole && isWhole;
        texts.rows.push_back(std::move(next));
    }
    texts.leftOut = rows.size() - texts.rows.size();
    const auto giveMore = [&left](double& height, double wanted) {
        const double more = std::min(left, wanted - height);
        height += more;
        left -= more;
    };
    giveMore(forImpression, heightOf(impression));
    giveMore(forComment, heightOf(comment));
    texts.heightMm = heightOfTexts - left;
    texts.impression = fittedTo(impression, forImpression);
    texts.comment = fittedTo(comment, forComment);
    return texts;
}

}  // namespace echolucent
