#include "tests/fuzz/mutations/text_header_mutation.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/fuzz/mutations/byte_mutation.h"

namespace echolucent {

namespace {

/// What the fields of a kind of header look like.
struct HeaderKind {
    std::string_view separator;
    std::span<const std::string_view> fields;  ///< whole lines that may be put in
    std::span<const std::string_view> values;  ///< words that stand behind a separator
};

constexpr std::array<std::string_view, 40> metaImageLines{"ObjectType = Image",
                                                          "NDims = 4",
                                                          "NDims = 2",
                                                          "DimSize = 4 3 2",
                                                          "DimSize = 1 1 1",
                                                          "DimSize = 4 3 2 2",
                                                          "ElementType = MET_SHORT",
                                                          "ElementType = MET_DOUBLE",
                                                          "ElementNumberOfChannels = 3",
                                                          "ElementNumberOfChannels = 2",
                                                          "ElementSpacing = 0.5 0.5 0.5",
                                                          "ElementSize = 1 1 1",
                                                          "Kinds = domain domain list",
                                                          "Kinds = vector domain domain domain",
                                                          "SpacingKnown = False",
                                                          "TransformMatrix = 1 0 0 0 1 0 0 0 1",
                                                          "TransformMatrix = 1 0 0 1 0 0 0 0 1",
                                                          "Rotation = 0 1 0 1 0 0 0 0 1",
                                                          "Orientation = 1 0 0 0 1 0",
                                                          "Offset = 1e30 0 0",
                                                          "Position = 1 2 3",
                                                          "Origin = nan 0 0",
                                                          "BinaryData = False",
                                                          "BinaryDataByteOrderMSB = True",
                                                          "ElementByteOrderMSB = True",
                                                          "CompressedData = True",
                                                          "CompressedDataSize = 10",
                                                          "HeaderSize = 4",
                                                          "HeaderSize = -1",
                                                          "WhiteLevel = 100",
                                                          "ElementDataFile = LOCAL",
                                                          "ElementDataFile = voxels.raw",
                                                          "ElementDataFile = LIST",
                                                          "ElementDataFile = v%03d.raw 1 3 1",
                                                          "ElementDataFile = v%2d 50%.raw",
                                                          "DistanceUnits = um",
                                                          "DistanceUnits = ells",
                                                          "ElementSpacing = 0,5 0,5 0,5",
                                                          "Seq_Frame0000_Timestamp = 0.5",
                                                          "Seq_Frame0001_Timestamp = 0.75"};
constexpr std::array<std::string_view, 18> metaImageValues{
    "MET_UCHAR",     "MET_CHAR",  "MET_SHORT",  "MET_USHORT", "MET_INT",    "MET_UINT",
    "MET_LONG_LONG", "MET_FLOAT", "MET_DOUBLE", "MET_STRING", "True",       "False",
    "Image",         "LOCAL",     "LIST",       "scan",       "voxels.raw", "../scan"};

constexpr std::array<std::string_view, 46> nrrdLines{"type: uchar",
                                                     "type: short",
                                                     "type: double",
                                                     "dimension: 4",
                                                     "dimension: 2",
                                                     "sizes: 4 3 2",
                                                     "sizes: 3 4 3 2",
                                                     "encoding: raw",
                                                     "encoding: gzip",
                                                     "encoding: bzip2",
                                                     "encoding: hex",
                                                     "encoding: ascii",
                                                     "endian: big",
                                                     "endian: little",
                                                     "spacings: 1 1 1",
                                                     "spacings: nan 1 1 1",
                                                     "units: \"mm\" \"cm\" \"um\"",
                                                     "space: left-posterior-superior",
                                                     "space: right-anterior-superior-time",
                                                     "space dimension: 3",
                                                     "space origin: (0,0,1e30)",
                                                     "space directions: (1,0,0) (0,1,0) (0,0,1)",
                                                     "space directions: none (1,0,0) (0,1,0) (0,0,1)",
                                                     "space units: \"mm\" \"mm\" \"mm\"",
                                                     "kinds: domain domain domain",
                                                     "kinds: vector domain domain time",
                                                     "line skip: 1",
                                                     "byte skip: -1",
                                                     "data file: voxels.raw",
                                                     "data file: v%d.raw 1 3 1",
                                                     "data file: a 50% of it.raw",
                                                     "units: um um furlong",
                                                     "units: ms mm mm mm",
                                                     "labels: \"\" \"\" \"\" \"time\"",
                                                     "space directions: (1,0,0,0) (0,1,0,0) (0,0,1,0) (0,0,0,0.04)",
                                                     "space dimension: 4",
                                                     "axis mins: 0 0 0",
                                                     "axis maxs: 1 2 3",
                                                     "centerings: cell node cell",
                                                     "spacings: 0,5 0,5 1",
                                                     "axis 0 index type:=numeric",
                                                     "axis 0 index values:=0 0.04",
                                                     "axis 3 index values:=0 0.04 0.1",
                                                     "MultiVolume.FrameLabels:=0,40",
                                                     "MultiVolume.FrameIdentifyingDICOMTagName:=TriggerTime",
                                                     "Seq_Frame0000_Timestamp:=0.5"};
constexpr std::array<std::string_view, 20> nrrdValues{
    "uchar", "int8",  "short", "ushort", "uint", "long long", "float",  "double",    "block", "raw",
    "gzip",  "bzip2", "hex",   "ascii",  "none", "space",     "vector", "RGB-color", "LIST",  "time"};

constexpr HeaderKind metaImage{" = ", metaImageLines, metaImageValues};
constexpr HeaderKind nrrd{": ", nrrdLines, nrrdValues};

/// The lines of the header, and what follows them.
struct SplitHeader {
    std::vector<std::string> lines;
    std::string rest;
};

SplitHeader split(const std::string& bytes, std::size_t end) {
    SplitHeader header;
    std::size_t from = 0;
    while (from < end) {
        std::size_t to = bytes.find('\n', from);
        if (to == std::string::npos || to >= end) to = end;
        header.lines.push_back(bytes.substr(from, to - from));
        from = to + 1;
    }
    header.rest = bytes.substr(end);
    return header;
}

std::string joined(const SplitHeader& header) {
    std::string bytes;
    for (std::size_t i = 0; i < header.lines.size(); ++i) bytes += (i > 0 ? "\n" : "") + header.lines[i];
    return bytes + header.rest;
}

/// The value with one of its words changed.
std::string withWordChanged(const std::string& value, const HeaderKind& kind, Dice& dice) {
    std::vector<std::string> words;
    std::size_t from = 0;
    while (from <= value.size()) {
        const std::size_t to = std::min(value.find_first_of(" ,()", from), value.size());
        words.push_back(value.substr(from, to + 1 - from));
        from = to + 1;
    }
    std::string& word = dice.oneOf(words);
    const std::string end = !word.empty() && std::string_view(" ,()").find(word.back()) != std::string_view::npos
                                ? word.substr(word.size() - 1)
                                : std::string();
    word = (dice.oneIn(3) ? std::string(dice.oneOf(kind.values)) : extremeNumber(dice)) + end;
    std::string changed;
    for (const std::string& one : words) changed += one;
    return changed;
}

std::string changedValue(const std::string& value, const HeaderKind& kind, Dice& dice) {
    switch (dice.below(8)) {
        case 0: return extremeNumber(dice);
        case 1: return std::string(dice.oneOf(kind.values));
        case 2: return value + " " + extremeNumber(dice);
        case 3: {
            std::string list;
            const std::size_t count = std::size_t{1} << dice.below(12);
            const std::string number = dice.oneIn(2) ? "1" : extremeNumber(dice);
            for (std::size_t i = 0; i < count; ++i) list += number + " ";
            return list;
        }
        default: return withWordChanged(value, kind, dice);
    }
}

void changeLines(std::vector<std::string>& lines, const HeaderKind& kind, Dice& dice) {
    const std::size_t at = dice.below(lines.size());
    const auto place = lines.begin() + static_cast<std::ptrdiff_t>(at);
    switch (dice.below(10)) {
        case 0: lines.erase(place); return;
        case 1: lines.insert(place, std::string(dice.oneOf(lines))); return;
        case 2: std::swap(*place, dice.oneOf(lines)); return;
        case 3:
        case 4: lines.insert(place, std::string(dice.oneOf(kind.fields))); return;
        case 5: *place = withBytesChanged(*place, dice); return;
        default: break;
    }
    const std::size_t separator = place->find(kind.separator);
    if (separator == std::string::npos) return;
    const std::size_t value = separator + kind.separator.size();
    *place = place->substr(0, value) + changedValue(place->substr(value), kind, dice);
}

std::string mutated(const std::string& bytes, std::size_t headerEnd, const HeaderKind& kind, std::uint64_t seed) {
    Dice dice(seed);
    SplitHeader header = split(bytes, headerEnd);
    const std::size_t changes = 1 + dice.below(4);
    for (std::size_t i = 0; i < changes; ++i)
        if (header.lines.empty() || dice.oneIn(12))
            header.rest = withBytesChanged(header.rest, dice);
        else
            changeLines(header.lines, kind, dice);
    std::string changed = joined(header);
    if (changed.size() > longestMutation) changed.resize(longestMutation);
    return changed;
}

}  // namespace

std::string mutatedMetaImage(std::string bytes, std::uint64_t seed) {
    // The line of the data file is the last of the header.
    const std::size_t last = bytes.find("ElementDataFile");
    const std::size_t end = last == std::string::npos ? bytes.size() : std::min(bytes.find('\n', last), bytes.size());
    return mutated(bytes, end, metaImage, seed);
}

std::string mutatedNrrd(std::string bytes, std::uint64_t seed) {
    return mutated(bytes, std::min(bytes.find("\n\n"), bytes.size()), nrrd, seed);
}

}  // namespace echolucent
