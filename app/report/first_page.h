// What of the texts of a case report fits on its first page.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace echolucent {

/// A measurement as the first page tells it.
struct FirstPageRow {
    std::string name, value, unit, comment;
    friend bool operator==(const FirstPageRow&, const FirstPageRow&) = default;
};

/// The beginning of a text. If more follows, it ends with "…".
struct FirstPageText {
    std::string text;
    bool isWhole = true;
};

struct FirstPageTexts {
    std::vector<FirstPageRow> rows{};  ///< the first measurements; a long name or comment ends with "…"
    std::size_t leftOut = 0;           ///< measurements that are not among them
    bool rowsAreWhole = true;          ///< no name and no comment of a measurement was cut
    FirstPageText impression{}, comment{};
    double heightMm = 0.0;  ///< of all these on the sheet, at most 100
};

/// Cuts the texts of a report so that a sheet of A4 or Letter holds them beside its pictures. Lengths are those of a
/// wide font, and pictures shrink if a font is wider still. The impression and the comment get 35 mm each before
/// measurements get room, and what measurements leave after that.
[[nodiscard]] FirstPageTexts textsOfFirstPage(const std::vector<FirstPageRow>& rows, std::string_view impression,
                                              std::string_view comment);

/// The offset in bytes at which each line of a text in UTF-8 ends, before the blank or the end of line that ends it. A
/// line holds letters of at most `width` together: letters from U+0800 on count as two, the others as one. Words that
/// are longer than a line are cut. A text has at least one line. `width` is 2 or more.
[[nodiscard]] std::vector<std::size_t> endsOfLines(std::string_view text, int width);

}  // namespace echolucent
