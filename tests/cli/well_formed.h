// Whether the markup of a page is well-formed.
#pragma once

#include <cstddef>
#include <regex>
#include <string>
#include <vector>

namespace echolucent {

/// The text is empty where every element that is opened is closed, in order; else it says what is wrong. The page is
/// written as XML, but for its first line.
inline std::string problemOf(const std::string& markup) {
    static const std::regex tag(R"(<(/?)([a-zA-Z0-9]+)((?:\s+[a-zA-Z:-]+="[^"<]*")*)\s*(/?)>)");
    std::vector<std::string> open;
    std::size_t at = markup.starts_with("<!DOCTYPE html>") ? 15 : 0;
    for (std::smatch found; at < markup.size();) {
        const std::size_t next = markup.find('<', at);
        if (markup.substr(at, next - at).find('>') != std::string::npos && (open.empty() || open.back() != "style"))
            return "a bare > near " + markup.substr(at, 60);
        if (next == std::string::npos) break;
        const auto begin = markup.cbegin() + static_cast<std::ptrdiff_t>(next);
        if (!std::regex_search(begin, markup.cend(), found, tag, std::regex_constants::match_continuous))
            return "no element: " + markup.substr(next, 80);
        at = next + static_cast<std::size_t>(found.length());
        if (found[4].length() > 0) continue;
        if (found[1].length() == 0) {
            open.push_back(found[2]);
            continue;
        }
        if (open.empty() || open.back() != found[2]) return "closes what is not open: " + found.str();
        open.pop_back();
    }
    return open.empty() ? "" : "not closed: " + open.back();
}

}  // namespace echolucent
