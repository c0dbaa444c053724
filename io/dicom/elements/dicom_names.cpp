#include "io/dicom/elements/dicom_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <utility>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include "processing/ascii_letters.h"

namespace echolucent {

namespace {

using Name = std::pair<std::string_view, const char*>;

/// Codings that DCMTK 3.6.7 does not know.
constexpr std::array newCodings{
    Name{"1.2.840.10008.1.2.1.98", "encapsulated uncompressed"},
    Name{"1.2.840.10008.1.2.4.110", "JPEG XL, lossless"},
    Name{"1.2.840.10008.1.2.4.111", "JPEG XL, recompressed JPEG"},
    Name{"1.2.840.10008.1.2.4.112", "JPEG XL"},
    Name{"1.2.840.10008.1.2.4.201", "High-Throughput JPEG 2000, lossless"},
    Name{"1.2.840.10008.1.2.4.202", "High-Throughput JPEG 2000, lossless"},
    Name{"1.2.840.10008.1.2.4.203", "High-Throughput JPEG 2000"},
    Name{"1.2.840.10008.1.2.4.204", "High-Throughput JPEG 2000, pixels kept on a server"},
    Name{"1.2.840.10008.1.2.4.205", "High-Throughput JPEG 2000 deflated, pixels kept on a server"},
    Name{"1.2.840.10008.1.2.8.1", "deflated frame by frame"},
};

/// Names that go before DCMTK's: of objects that DCMTK 3.6.7 does not know, and of objects for which people who scan
/// have a better name than the standard.
constexpr std::array objectsOfOurs{
    Name{directorySopClass, "a DICOMDIR (a list of files)"},
    Name{qlabSopClass, "a Philips QLAB Cartesian volume"},
    Name{"1.2.840.113543.6.6.1.3.10001", "a Philips 3D volume in its maker's own coding"},
    Name{"1.2.840.10008.5.1.4.1.1.3.1", "an ultrasound cine"},
    Name{"1.2.840.10008.5.1.4.1.1.6.2", "an Enhanced US Volume"},
    Name{"1.2.840.10008.5.1.4.1.1.6.3", "a photoacoustic image"},
    Name{"1.2.840.10008.5.1.4.1.1.7", "a screen capture (secondary capture)"},
};

/// How the UIDs of makers' own classes begin.
constexpr std::array makers{
    Name{"1.2.840.113543.6.6.", "Philips"},     Name{"1.2.840.113663.", "Philips"},
    Name{"1.3.46.670589.", "Philips"},          Name{"1.2.840.113619.", "GE"},
    Name{"1.2.276.0.26.20010718.", "GE"},       Name{"1.2.276.0.48.", "TomTec"},
    Name{"1.3.12.2.1107.", "Siemens"},          Name{"1.2.840.113680.", "Acuson"},
    Name{"1.2.392.200036.9116.", "Canon"},      Name{"1.2.392.200036.9125.", "Fujifilm"},
    Name{"1.2.410.200001.", "Samsung Medison"},
};

/// Words in the standard's names, split as wordsOfName() does, and what replaces them in a sentence.
constexpr std::array abbreviations{
    Name{"SR", "structured report"}, Name{"RT", "radiotherapy"}, Name{"RETIRED", "retired"},
    Name{"VL", "visible light"},     Name{"X Ray", "X-ray"},     Name{"Storage", ""},
    Name{"PDF", "PDF document"},     Name{"STL", "STL model"},   Name{"OBJ", "OBJ model"},
};

const char* nameIn(std::span<const Name> names, std::string_view uid) {
    const auto found = std::ranges::find(names, uid, &Name::first);
    return found == names.end() ? nullptr : found->second;
}

bool isUpper(char letter) { return std::isupper(static_cast<unsigned char>(letter)) != 0; }
bool isLower(char letter) { return std::islower(static_cast<unsigned char>(letter)) != 0; }
bool isDigit(char letter) { return std::isdigit(static_cast<unsigned char>(letter)) != 0; }

/// Whether a word begins with a letter that is spoken by its name, as "MR" and "X-ray" do.
bool isSpelled(std::string_view word) { return isUpper(word[0]) && (word.size() == 1 || !isLower(word[1])); }

/// Replaces the abbreviation where it first stands as a separate word.
void writeOut(std::string& words, const Name& abbreviation) {
    const auto& [shortForm, longForm] = abbreviation;
    const std::string padded = ' ' + words + ' ';
    const auto at = padded.find(' ' + std::string(shortForm) + ' ');
    if (at == std::string::npos) return;
    words.replace(at, shortForm.size(), longForm);
    if (*longForm == '\0') words.erase(std::min(at, words.size() - 1), 1);
    if (words.ends_with(' ')) words.pop_back();
}

/// "an enhanced MR image" of "EnhancedMRImageStorage".
std::string objectInWords(std::string_view name) {
    std::string words = wordsOfName(name);
    for (const Name& abbreviation : abbreviations) writeOut(words, abbreviation);
    for (std::size_t i = 0; i < words.size(); ++i)
        if ((i == 0 || words[i - 1] == ' ') && i + 1 < words.size() && isLower(words[i + 1]))
            words[i] = lowerCase(words[i]);
    if (words.ends_with('s') || words.ends_with("data")) return "an object of " + words;
    const std::string_view vowels = isSpelled(words) ? "AEFHILMNORSX" : "aeiou";
    return (vowels.find(words[0]) != std::string_view::npos ? "an " : "a ") + words;
}

}  // namespace

std::string wordsOfName(std::string_view name) {
    std::string words;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const char letter = name[i];
        const bool nextIsLower = i + 1 < name.size() && isLower(name[i + 1]);
        const bool begins = i > 0 && ((isUpper(letter) && (isLower(name[i - 1]) || nextIsLower)) ||
                                      (isDigit(letter) && isLower(name[i - 1])));
        if (begins && words.back() != ' ') words += ' ';
        words += letter == '_' ? ' ' : letter;
    }
    return words;
}

std::string transferSyntaxName(std::string_view uid) {
    if (const char* name = nameIn(newCodings, uid)) return name;
    // The identifiers of videos that may be split into fragments have ".1" at the end. DCMTK 3.6.7 does not know them.
    if (uid.starts_with("1.2.840.10008.1.2.4.10") && uid.ends_with(".1")) uid.remove_suffix(2);
    const DcmXfer syntax(std::string(uid).c_str());
    if (uid.empty() || syntax.getXfer() == EXS_Unknown) return "a coding that is not known here";
    const std::string name = syntax.getXferName();
    return name.starts_with("MPEG") || name.starts_with("HEVC") ? name + " (video)" : name;
}

std::string objectName(std::string_view sopClassUid) {
    if (sopClassUid.empty()) return "an object that does not say of what kind it is";
    if (const char* name = nameIn(objectsOfOurs, sopClassUid)) return name;
    if (const char* name = dcmFindNameOfUID(std::string(sopClassUid).c_str())) return objectInWords(name);
    for (const auto& [root, maker] : makers)
        if (sopClassUid.starts_with(root)) return std::string("a private object of ") + maker;
    return "an object of a kind that is not known here";
}

bool holdsPicture(std::string_view sopClassUid) {
    const std::string name = objectName(sopClassUid);
    return dcmIsImageStorageSOPClassUID(std::string(sopClassUid).c_str()) || name.ends_with(" image") ||
           name.find(" not known here") != std::string::npos || name.find(" does not say") != std::string::npos;
}

}  // namespace echolucent
