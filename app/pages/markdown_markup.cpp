#include "app/pages/markdown_markup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <vector>

#include "app/pages/html_text.h"

namespace echolucent {

namespace {

constexpr int deepestMarks = 8;  // marks within each other; deeper ones stand as they were typed
constexpr auto nowhere = std::string_view::npos;

/// "![words](name)" or "[words](address)" at the beginning of a text.
struct Link {
    std::string_view words, address;
    std::size_t length = 0;
};

std::optional<Link> linkAt(std::string_view text, std::size_t begin) {
    const std::size_t close = text.find("](", begin);
    const std::size_t end = close == nowhere ? nowhere : text.find(')', close);
    if (end == nowhere || text.substr(begin + 1, close - begin - 1).find('[') != nowhere) return std::nullopt;
    const std::string_view target = text.substr(close + 2, end - close - 2);
    return Link{text.substr(begin + 1, close - begin - 1), target.substr(0, target.find(' ')), end + 1 - begin};
}

/// Where the text that a mark begins ends; no value if it begins none.
std::optional<std::size_t> endOfMarked(std::string_view text, std::size_t begin, std::string_view mark) {
    const std::size_t first = begin + mark.size();
    if (first >= text.size() || text[first] == ' ') return std::nullopt;
    for (std::size_t end = text.find(mark, first + 1); end != nowhere; end = text.find(mark, end + 1)) {
        if (text[end - 1] == ' ') continue;
        const bool isStrong = mark == "*" && text.substr(end, 2) == "**";
        if (!isStrong) return end;
        ++end;
    }
    return std::nullopt;
}

class Inline {
public:
    Inline(const std::map<std::string, std::string>& images, std::set<std::string>& embedded)
        : m_images(images), m_embedded(embedded) {}

    [[nodiscard]] std::string markup(std::string_view text, int depth = 0) const {
        if (depth > deepestMarks) return escaped(text);
        std::string markup;
        std::size_t plain = 0, at = 0;
        const auto add = [&](const std::string& part, std::size_t length) {
            markup += escaped(text.substr(plain, at - plain)) + part;
            plain = at = at + length;
        };
        while (at < text.size()) {
            const std::string_view rest = text.substr(at);
            if (rest.size() > 1 && rest[0] == '\\' && std::ispunct(static_cast<unsigned char>(rest[1])) != 0) {
                add(escaped(rest.substr(1, 1)), 2);
            } else if (const auto marked = markedAt(text, at, depth)) {
                add(marked->first, marked->second);
            } else {
                ++at;
            }
        }
        at = text.size();
        add({}, 0);
        return markup;
    }

private:
    /// The markup of what begins here, and how long it is in the text.
    [[nodiscard]] std::optional<std::pair<std::string, std::size_t>> markedAt(std::string_view text, std::size_t at,
                                                                              int depth) const {
        const std::string_view rest = text.substr(at);
        if (rest.starts_with("![") || rest.starts_with("[")) {
            const bool isImage = rest.starts_with("!");
            const auto link = linkAt(rest, isImage ? 1 : 0);
            if (!link) return std::nullopt;
            return std::pair(isImage ? imageMarkup(*link) : markup(link->words, depth + 1),
                             link->length + (isImage ? 1 : 0));
        }
        for (const auto& [mark, tag] : {std::pair("`", "code"), std::pair("**", "strong"), std::pair("*", "em")}) {
            const std::string_view sign = mark;
            if (!rest.starts_with(sign)) continue;
            const auto end = endOfMarked(text, at, sign);
            if (!end) continue;
            const std::string_view inner = text.substr(at + sign.size(), *end - at - sign.size());
            return std::pair(
                fmt::format("<{0}>{1}</{0}>", tag, sign == "`" ? escaped(inner) : markup(inner, depth + 1)),
                *end + sign.size() - at);
        }
        return std::nullopt;
    }
    [[nodiscard]] std::string imageMarkup(const Link& link) const {
        const auto image = m_images.find(std::string(link.address));
        if (image == m_images.end()) return escaped(link.words);
        const bool isPng = image->second.starts_with("\x89PNG\r\n\x1a\n");
        if ((!isPng && !image->second.starts_with("\xff\xd8\xff")) || !m_embedded.insert(image->first).second)
            return escaped(link.words);
        return fmt::format("<img alt=\"{}\" src=\"{}\"/>", escaped(link.words),
                           dataUri(isPng ? "image/png" : "image/jpeg", image->second));
    }

    const std::map<std::string, std::string>& m_images;
    std::set<std::string>& m_embedded;
};

/// What a line begins.
enum class Block { none, paragraph, heading, bullets, numbers };

struct Line {
    Block begins = Block::none;
    std::string_view words;
};

Line lineOf(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == nowhere) return {};
    line = line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
    if (line.starts_with("- ") || line.starts_with("* ")) return {Block::bullets, line.substr(2)};
    if (const std::size_t sharps = line.find_first_not_of('#'); sharps != nowhere && sharps > 0 && line[sharps] == ' ')
        return {Block::heading, line.substr(sharps + 1)};
    const std::size_t digits = line.find_first_not_of("0123456789");
    constexpr std::size_t mostDigits = 3;
    if (digits != nowhere && digits > 0 && digits <= mostDigits && line.substr(digits).starts_with(". "))
        return {Block::numbers, line.substr(digits + 2)};
    return {Block::paragraph, line};
}

std::string_view tagOf(Block block) {
    switch (block) {
        case Block::bullets: return "ul";
        case Block::numbers: return "ol";
        default: return {};
    }
}

}  // namespace

std::string markdownMarkup(std::string_view markdown, const std::map<std::string, std::string>& images,
                           std::set<std::string>& embedded) {
    const Inline words(images, embedded);
    std::string markup, text;
    Block block = Block::none, list = Block::none;
    const auto endBlock = [&] {
        const std::string inner = words.markup(text);
        if (block == Block::paragraph) markup += "<p>" + inner + "</p>\n";
        if (block == Block::heading) markup += "<p><strong>" + inner + "</strong></p>\n";
        if (block == Block::bullets || block == Block::numbers) markup += "<li>" + inner + "</li>\n";
        text.clear();
        block = Block::none;
    };
    const auto changeList = [&](Block next) {
        if (next == list) return;
        if (list != Block::none) markup += fmt::format("</{}>\n", tagOf(list));
        if (next != Block::none) markup += fmt::format("<{}>\n", tagOf(next));
        list = next;
    };
    std::size_t begin = 0;
    while (begin < markdown.size()) {
        const std::size_t end = std::min(markdown.find('\n', begin), markdown.size());
        const Line line = lineOf(markdown.substr(begin, end - begin));
        begin = end + 1;
        // A plain line goes on with what stands above it.
        if (line.begins == Block::paragraph && block != Block::none && block != Block::heading) {
            text += '\n';
            text += line.words;
            continue;
        }
        endBlock();
        if (line.begins == Block::none) continue;
        changeList(tagOf(line.begins).empty() ? Block::none : line.begins);
        block = line.begins;
        text = line.words;
    }
    endBlock();
    changeList(Block::none);
    return markup;
}

}  // namespace echolucent
