// Texts of lessons, which are Markdown, as parts of an HTML document.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace echolucent {

/// The markup of a Markdown text: paragraphs, lists, headings of one size, **strong**, *emphasised* and `code`. An
/// image is embedded if `images` has the bytes of a PNG or JPEG file of its name and `embedded` does not hold the name,
/// which it then does: a page embeds each image once. Else the image's words stand there. Of a link the
/// words stand there, and HTML is shown as words: nothing on the page leads anywhere. The markup is well-formed
/// whatever the text is.
[[nodiscard]] std::string markdownMarkup(std::string_view markdown, const std::map<std::string, std::string>& images,
                                         std::set<std::string>& embedded);

}  // namespace echolucent
