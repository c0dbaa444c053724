#include "io/files/archives.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

namespace echolucent {

namespace {

using namespace std::string_view_literals;

struct Signature {
    std::string_view bytes, words;
};

constexpr std::string_view zip = "is a ZIP archive";
constexpr std::array signatures{Signature{"PK\x03\x04"sv, zip},
                                Signature{"PK\x05\x06"sv, zip},  // an empty one
                                Signature{"PK\x07\x08"sv, zip},  // one in parts
                                Signature{"7z\xbc\xaf\x27\x1c"sv, "is a 7z archive"},
                                Signature{"Rar!\x1a\x07"sv, "is a RAR archive"},
                                Signature{"\xfd"
                                          "7zXZ\0"sv,
                                          "is compressed with xz"},
                                Signature{"\x28\xb5\x2f\xfd"sv, "is compressed with zstd"},
                                Signature{"LZIP\x01"sv, "is compressed with lzip"},
                                Signature{"\x04\x22\x4d\x18"sv, "is compressed with lz4"},
                                Signature{"\x1f\x9d\x90"sv, "is compressed with compress"}};

/// The octal number of a tar header's field; no value if it is none.
std::optional<std::uint32_t> octal(std::string_view field) {
    const auto first = field.find_first_not_of(' ');
    if (first == std::string_view::npos) return std::nullopt;
    field = field.substr(first);
    field = field.substr(0, field.find_first_of(" \0"sv));
    if (field.empty() || field.size() > 7) return std::nullopt;
    std::uint32_t number = 0;
    for (const char digit : field) {
        if (digit < '0' || digit > '7') return std::nullopt;
        number = 8 * number + static_cast<std::uint32_t>(digit - '0');
    }
    return number;
}

/// Whether a file begins with a tar header. Old ones have no signature, but all have the sum of their bytes, in which
/// the sum's own field counts as blanks.
bool isTar(std::string_view beginning) {
    constexpr std::size_t header = 512, place = 148, length = 8;
    if (beginning.size() < header || beginning[0] == '\0') return false;
    const auto stated = octal(beginning.substr(place, length));
    if (!stated) return false;
    std::uint32_t sum = length * ' ';
    for (std::size_t i = 0; i < header; ++i)
        if (i < place || i >= place + length) sum += static_cast<std::uint8_t>(beginning[i]);
    return sum == *stated;
}

}  // namespace

bool looksLikeBzip2(std::string_view beginning) {
    return beginning.starts_with("BZh") && beginning.size() >= 10 && beginning[3] >= '1' && beginning[3] <= '9' &&
           (beginning.substr(4, 6) == "1AY&SY" || beginning.substr(4, 6) == "\x17\x72\x45\x38\x50\x90");
}

std::string_view archiveInWords(std::string_view beginning) {
    const auto known =
        std::ranges::find_if(signatures, [&](const Signature& each) { return beginning.starts_with(each.bytes); });
    if (known != signatures.end()) return known->words;
    if (looksLikeBzip2(beginning)) return "is compressed with bzip2";
    return isTar(beginning) ? "is a tar archive" : "";
}

}  // namespace echolucent
