#include "io/headers/meta_image_keys.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "io/files/header_text.h"
#include "io/files/input_problems.h"
#include "processing/ascii_letters.h"

namespace echolucent {

namespace {

// Keys that decide how voxels are read. Other keys are allowed and play no part, but for those that tell of frames
// (settleFrames()).
constexpr std::array<std::string_view, 25> ourKeys{"ObjectType",
                                                   "NDims",
                                                   "BinaryData",
                                                   "DimSize",
                                                   "ElementType",
                                                   "ElementNumberOfChannels",
                                                   "ElementSpacing",
                                                   "ElementSize",
                                                   "DistanceUnits",
                                                   "Kinds",
                                                   "SpacingKnown",
                                                   "TransformMatrix",
                                                   "Rotation",
                                                   "Orientation",
                                                   "Offset",
                                                   "Position",
                                                   "Origin",
                                                   "BinaryDataByteOrderMSB",
                                                   "ElementByteOrderMSB",
                                                   "CompressedData",
                                                   "CompressedDataSize",
                                                   "HeaderSize",
                                                   "WhiteLevel",
                                                   "BlackLevel",
                                                   "ElementDataFile"};

/// A key as we spell it, whatever its case: programs disagree on capitals. Keys that are not ours stay as they are.
std::string asWeSpellIt(std::string key) {
    const auto ours = std::find_if(ourKeys.begin(), ourKeys.end(),
                                   [&](std::string_view known) { return lowerCase(known) == lowerCase(key); });
    return ours == ourKeys.end() ? std::move(key) : std::string(*ours);
}

/// Whether the values of two keys for the same thing agree.
bool saySame(const std::string& one, const std::string& other) {
    const auto numbers = realNumbers(one), others = realNumbers(other);
    return lowerCase(one) == lowerCase(other) || (numbers && others && *numbers == *others);
}

Result<void> readListedNames(const InputFile& file, std::string_view rest, MetaImageKeys& keys) {
    if (file.size() > headerLimit)
        return keys.wrong("ElementDataFile", fmt::format("begins a list that is longer than {} bytes", headerLimit),
                          "Save the volume as one .mha file.");
    while (const auto line = nextLine(rest))
        if (std::string name = trimmed(*line); !name.empty()) keys.listed.push_back(std::move(name));
    return {};
}

}  // namespace

bool isMetaImageList(const std::string& dataFile) {
    return dataFile == "LIST" || dataFile.starts_with("LIST ") || dataFile.starts_with("LIST\t");
}

const std::string* MetaImageKeys::find(const std::string& key) const {
    const auto found = values.find(key);
    return found == values.end() ? nullptr : &found->second;
}

std::string MetaImageKeys::firstOf(std::initializer_list<const char*> keys) const {
    for (const char* key : keys)
        if (find(key) != nullptr) return key;
    return {};
}

Result<std::string> MetaImageKeys::onlyOf(std::initializer_list<const char*> keys) const {
    std::string first = firstOf(keys);
    for (const char* key : keys)
        if (find(key) != nullptr && !saySame(*find(first), *find(key)))
            return wrong(key, fmt::format("is {} beside {} = {}, which means the same thing", quotedText(*find(key)),
                                          first, quotedText(*find(first))));
    return first;
}

Result<std::vector<double>> MetaImageKeys::numbers(const std::string& key, std::size_t least, std::size_t most,
                                                   std::vector<std::string>& notes) const {
    const std::string& text = *find(key);
    auto numbers = realNumbers(text);
    const auto fits = [&] { return numbers && numbers->size() >= least && numbers->size() <= most; };
    if (const auto points = numbers ? std::nullopt : withDecimalPoints(text)) {
        numbers = realNumbers(*points);
        if (fits()) notes.push_back(decimalCommasNote(key, text));
    }
    if (!fits())
        return wrong(key, fmt::format("must be {} numbers, not {}", most, quotedText(text)), remedyOfNumbers(text));
    return *numbers;
}

Result<bool> MetaImageKeys::flag(const std::string& key) const {
    const std::string* value = find(key);
    if (value == nullptr) return false;
    const std::string lower = lowerCase(*value);
    if (lower == "true" || lower == "t" || lower == "1" || lower == "yes") return true;
    if (lower == "false" || lower == "f" || lower == "0" || lower == "no") return false;
    return wrong(key, "must be True or False, not " + quotedText(*value));
}

tl::unexpected<Failure> MetaImageKeys::wrong(const std::string& key, const std::string& problem,
                                             const std::string& remedy) const {
    return fail(FailureKind::unreadable, path, key, problem, remedy);
}

Result<MetaImageKeys> readMetaImageKeys(const InputFile& file) {
    const auto beginning = file.beginning(headerLimit);
    if (!beginning) return tl::unexpected(beginning.error());
    MetaImageKeys keys;
    keys.path = file.path();
    std::string_view rest = withoutByteOrderMark(*beginning);
    if (endsLinesWithLoneCr(rest)) return keys.wrong("", loneCrProblem, loneCrRemedy);
    for (int number = 1; const auto line = nextLine(rest); ++number) {
        if (trimmed(*line).empty()) continue;
        const bool isCut = rest.empty() && !beginning->ends_with('\n');
        const auto equals = line->find('=');
        if (isCut && equals == std::string_view::npos && number > 1)
            return keys.wrong("", fmt::format("ends within line {} of its header ({})", number, quotedText(*line)),
                              damagedFile);
        if (equals == std::string_view::npos || trimmed(line->substr(0, equals)).empty())
            return keys.wrong(
                "", fmt::format("has no \"Key = Value\" in line {} of its header ({})", number, quotedText(*line)),
                "This is no MetaImage file, or its header is damaged.");
        const std::string key = asWeSpellIt(trimmed(line->substr(0, equals)));
        const std::string value = trimmed(line->substr(equals + 1));
        const auto [known, isNew] = keys.values.emplace(key, value);
        if (!isNew && std::find(ourKeys.begin(), ourKeys.end(), key) != ourKeys.end()) {
            if (!saySame(known->second, value))
                return keys.wrong(key, "appears twice in the header, with different values");
            keys.repeated.insert(key);
        }
        if (key != "ElementDataFile") continue;
        if (const std::string& name = *keys.find(key);
            isCut && !name.empty() && name != "LOCAL" && std::string_view("LOCAL").starts_with(name))
            return keys.wrong(key, fmt::format("is cut off after {}, where the file ends", quotedText(name)),
                              damagedFile);
        keys.headerBytes = beginning->size() - rest.size();
        if (isMetaImageList(*keys.find(key)))
            if (auto listed = readListedNames(file, rest, keys); !listed) return tl::unexpected(listed.error());
        return keys;
    }
    return keys.wrong("ElementDataFile",
                      fmt::format("is missing from the header (looked through {} bytes)", beginning->size()),
                      damagedFile);
}

}  // namespace echolucent
