#include "io/dicom/series/series_description.h"

#include <algorithm>
#include <vector>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/files/header_text.h"
#include "processing/ascii_letters.h"

namespace echolucent {

namespace {

bool isLetterOrDigit(char character) {
    return (character >= 'a' && character <= 'z') || (character >= '0' && character <= '9');
}

/// Whether the text is printable ASCII. An escape begins letters of another character set.
bool isPlain(const std::string& text) {
    return std::ranges::all_of(text, [](char character) { return character >= ' ' && character <= '~'; });
}

/// The words of a text in small letters: its runs of letters and digits.
std::vector<std::string> plainWords(std::string text) {
    std::ranges::replace_if(
        text, [](char character) { return !isLetterOrDigit(character); }, ' ');
    return wordsOf(text);
}

}  // namespace

std::string seriesDescription(DcmItem& dataset) {
    // DICOM allows 64 letters each. Longer texts take too long to compare word by word.
    constexpr std::size_t longest = 1024;
    const std::string description = dicomText(dataset, {0x0008, 0x103e});
    const std::string name = lowerCase(dicomText(dataset, {0x0010, 0x0010}));
    const std::string identifier = lowerCase(dicomText(dataset, {0x0010, 0x0020}));
    if (std::max({description.size(), name.size(), identifier.size()}) > longest) return {};
    if (!isPlain(name) || !isPlain(identifier)) return {};
    const std::string small = lowerCase(description);
    const std::vector<std::string> said = plainWords(small);
    // Two letters occur in many words that name nobody.
    const auto isSaid = [&](const std::string& part) {
        return part.size() > 2 ? small.find(part) != std::string::npos : std::ranges::find(said, part) != said.end();
    };
    std::vector<std::string> parts = plainWords(name);
    if (!identifier.empty()) parts.push_back(identifier);
    return std::ranges::any_of(parts, isSaid) ? std::string() : description;
}

}  // namespace echolucent
