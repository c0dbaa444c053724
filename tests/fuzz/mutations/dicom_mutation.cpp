#include "tests/fuzz/mutations/dicom_mutation.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/fuzz/mutations/byte_mutation.h"
#include "tests/fuzz/mutations/dicom_elements.h"
#include "tests/fuzz/mutations/kretz_mutation.h"

namespace echolucent {

namespace {

using Elements = std::vector<DicomElementBytes>;

constexpr std::array<std::string_view, 24> vrs{"AE", "AS", "AT", "CS", "DA", "DS", "FD", "FL", "IS", "LO", "LT", "OB",
                                               "OF", "OW", "PN", "SH", "SL", "SQ", "SS", "UI", "UL", "UN", "US", "ZZ"};

constexpr std::array<std::string_view, 15> syntaxes{
    "1.2.840.10008.1.2",      "1.2.840.10008.1.2.1",    "1.2.840.10008.1.2.2",
    "1.2.840.10008.1.2.1.99", "1.2.840.10008.1.2.5",    "1.2.840.10008.1.2.4.50",
    "1.2.840.10008.1.2.4.51", "1.2.840.10008.1.2.4.57", "1.2.840.10008.1.2.4.70",
    "1.2.840.10008.1.2.4.80", "1.2.840.10008.1.2.4.81", "1.2.840.10008.1.2.4.90",
    "1.2.840.10008.1.2.4.91", "1.2.840.113619.5.2",     "1.2.3"};

/// An element that readers ask for, and a value that one may find there.
struct KnownElement {
    std::uint32_t tag;
    std::string_view vr, value;
};
using namespace std::string_view_literals;
constexpr std::array<KnownElement, 40> known{{
    {0x00020002, "UI", "1.2.840.10008.1.3.10"},
    {0x00041220, "SQ", ""},
    {0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.6.2"},
    {0x00080008, "CS", "DERIVED\\SECONDARY"},
    {0x00082218, "SQ", ""},
    {0x00180050, "DS", "1"},
    {0x00180088, "DS", "1"},
    {0x00181063, "DS", "40"},
    {0x00186011, "SQ", ""},
    {0x00186024, "US", "\3\0"sv},
    {0x0018602c, "FD", "\0\0\0\0\0\0\xf0\x3f"sv},
    {0x0020000d, "UI", "1.2.3"},
    {0x0020000e, "UI", "1.2.3"},
    {0x00200013, "IS", "2"},
    {0x00200032, "DS", "0\\0\\1"},
    {0x00200037, "DS", "1\\0\\0\\0\\1\\0"},
    {0x00200052, "UI", "1.2.4"},
    {0x00209301, "FD", "\0\0\0\0\0\0\xf0\x3f"sv},
    {0x00280002, "US", "\3\0"sv},
    {0x00280004, "CS", "PALETTE COLOR"},
    {0x00280004, "CS", "YBR_FULL_422"},
    {0x00280006, "US", "\1\0"sv},
    {0x00280008, "IS", "2"},
    {0x00280009, "AT", "\x18\0\x63\x10"sv},
    {0x00280010, "US", "\2\0"sv},
    {0x00280030, "DS", "1\\1"},
    {0x00280100, "US", "\x10\0"sv},
    {0x00280101, "US", "\xc\0"sv},
    {0x00280103, "US", "\1\0"sv},
    {0x00281050, "DS", "128"},
    {0x00281051, "DS", "256"},
    {0x00281052, "DS", "-1024"},
    {0x00281053, "DS", "2"},
    {0x00281101, "US", "\0\1\0\0\x10\0"sv},
    {0x00282110, "CS", "01"},
    {0x3004000c, "DS", "0\\1\\2"},
    {0x52009229, "SQ", ""},
    {0x52009230, "SQ", ""},
    {0x7fe00001, "OV", "\0\0\0\0\0\0\0\0"sv},
    {0x7fe10010, "LO", "KRETZ_US"},
}};

/// All lists of elements of a data set: its own, and those of items.
void collect(Elements& elements, std::vector<Elements*>& lists) {
    if (!elements.empty()) lists.push_back(&elements);
    for (DicomElementBytes& element : elements)
        for (DicomItemBytes& item : element.items) collect(item.elements, lists);
}

bool isText(std::string_view vr) {
    static constexpr std::array<std::string_view, 9> texts{"AE", "CS", "DA", "DS", "IS", "LO", "SH", "UI", "UT"};
    return std::ranges::find(texts, vr) != texts.end();
}

std::string textOfNumbers(const std::string& value, Dice& dice) {
    std::string text = dice.oneIn(2) ? extremeNumber(dice) : value;
    while (!text.empty() && (text.back() == '\0' || text.back() == ' ')) text.pop_back();
    const std::size_t times = dice.oneIn(4) ? std::size_t{1} << dice.below(11) : dice.below(3);
    const std::string more = dice.oneIn(2) ? "1" : extremeNumber(dice);
    for (std::size_t i = 0; i < times; ++i) text += "\\" + more;
    if (text.size() % 2 == 1) text += ' ';
    return text;
}

void changeValue(DicomElementBytes& element, Dice& dice) {
    if (element.value.starts_with("KRETZFILE")) {
        element.value = mutatedKretz(element.value, dice.number());
    } else if (element.vr == "US" || element.vr == "SS" || element.vr == "AT") {
        const bool small = dice.oneIn(2);
        const auto number = static_cast<std::uint16_t>(small ? dice.below(20) : extremeWhole(dice));
        element.value = bytesOfValue(number) + (dice.oneIn(6) ? element.value : "");
    } else if (element.vr == "FD" || element.vr == "FL") {
        const std::size_t width = element.vr == "FD" ? 8 : 4;
        if (element.value.size() < width || dice.oneIn(8)) element.value += std::string(width, '\0');
        element.value.replace(width * dice.below(element.value.size() / width), width, extremeField(dice, width, true));
    } else if (isText(element.vr) && !dice.oneIn(4)) {
        element.value = textOfNumbers(element.value, dice);
    } else {
        element.value = withBytesChanged(element.value, dice);
    }
}

/// The element inside `depth` sequences, each of one item.
DicomElementBytes nested(DicomElementBytes element, std::size_t depth, Dice& dice) {
    for (std::size_t i = 0; i < depth; ++i) {
        DicomElementBytes outer;
        outer.tag = dice.oneOf(known).tag;
        outer.vr = dice.oneIn(8) ? dice.oneOf(vrs) : "SQ";
        outer.sequence = true;
        outer.delimited = dice.oneIn(2);
        outer.closed = !dice.oneIn(8);
        outer.items.emplace_back();
        outer.items.back().delimited = dice.oneIn(2);
        outer.items.back().closed = !dice.oneIn(8);
        outer.items.back().elements.push_back(std::move(element));
        element = std::move(outer);
    }
    return element;
}

void changeFragments(std::vector<std::string>& fragments, Dice& dice) {
    if (fragments.empty()) return fragments.emplace_back(), void();
    const auto place = fragments.begin() + static_cast<std::ptrdiff_t>(dice.below(fragments.size()));
    switch (dice.below(8)) {
        case 0: fragments.erase(place); return;
        case 1: fragments.insert(place, std::string(dice.oneOf(fragments))); return;
        case 2: std::swap(*place, dice.oneOf(fragments)); return;
        case 3: place->clear(); return;
        case 4: place->resize(dice.below(place->size() + 1)); return;
        case 5: {  // One fragment becomes two.
            const std::size_t at = dice.below(place->size() + 1);
            std::string end = place->substr(at);
            place->resize(at);
            fragments.insert(place + 1, std::move(end));
            return;
        }
        default: *place = withBytesChanged(*place, dice);
    }
}

void changeSequence(DicomElementBytes& element, Dice& dice) {
    switch (dice.below(6)) {
        case 0: element.delimited = !element.delimited; return;
        case 1: element.closed = !element.closed; return;
        case 2: element.falseLength = static_cast<std::uint32_t>(extremeWhole(dice)); return;
        default: break;
    }
    if (element.items.empty()) return element.items.emplace_back(), void();
    const auto place = element.items.begin() + static_cast<std::ptrdiff_t>(dice.below(element.items.size()));
    switch (dice.below(6)) {
        case 0: element.items.erase(place); return;
        case 1: element.items.insert(place, DicomItemBytes(dice.oneOf(element.items))); return;
        case 2: std::swap(*place, dice.oneOf(element.items)); return;
        case 3: place->delimited = !place->delimited; return;
        case 4: place->closed = !place->closed; return;
        default: place->falseLength = static_cast<std::uint32_t>(extremeWhole(dice));
    }
}

void changeElement(DicomElementBytes& element, Dice& dice) {
    switch (dice.below(10)) {
        case 0: element.vr = dice.oneOf(vrs); return;
        case 1: element.tag = dice.oneOf(known).tag; return;
        case 2:
            element.falseLength = dice.oneIn(2) ? static_cast<std::uint32_t>(extremeWhole(dice))
                                                : static_cast<std::uint32_t>(element.value.size() + dice.below(9)) - 4;
            return;
        case 3: element.tag ^= std::uint32_t{1} << dice.below(32); return;
        default: break;
    }
    if (element.encapsulated)
        changeFragments(element.fragments, dice);
    else if (element.sequence)
        changeSequence(element, dice);
    else
        changeValue(element, dice);
}

DicomElementBytes knownElement(Dice& dice) {
    const KnownElement& one = dice.oneOf(known);
    DicomElementBytes element{one.tag, std::string(one.vr), std::string(one.value)};
    element.sequence = one.vr == "SQ";
    if (element.sequence && dice.oneIn(2)) element.items.emplace_back();
    if (element.value.size() % 2 == 1) element.value += one.vr == "UI" ? '\0' : ' ';
    return element;
}

void changeList(Elements& list, std::vector<Elements*>& lists, Dice& dice) {
    const auto place = list.begin() + static_cast<std::ptrdiff_t>(dice.below(list.size()));
    switch (dice.below(12)) {
        case 0: list.erase(place); return;
        case 1: list.insert(place, DicomElementBytes(*place)); return;
        case 2: std::swap(*place, dice.oneOf(list)); return;
        case 3: *place = nested(std::move(*place), 1 + dice.below(dice.oneIn(8) ? 100 : 3), dice); return;
        case 4: {  // A copy of it stands elsewhere.
            DicomElementBytes copy = *place;
            Elements& other = *dice.oneOf(lists);
            other.insert(other.begin() + static_cast<std::ptrdiff_t>(dice.below(other.size() + 1)), std::move(copy));
            return;
        }
        case 5: list.insert(place, knownElement(dice)); return;
        default: changeElement(*place, dice);
    }
}

void changeSyntax(DicomFileBytes& file, Dice& dice) {
    for (DicomElementBytes& element : file.meta)
        if (element.tag == 0x00020010U) {
            element.value = dice.oneOf(syntaxes);
            if (element.value.size() % 2 == 1) element.value += '\0';
        }
    if (dice.oneIn(2)) file.implicit = !file.implicit;
    if (dice.oneIn(4)) file.deflated = !file.deflated;
}

}  // namespace

std::string mutatedDicom(std::string bytes, std::uint64_t seed) {
    Dice dice(seed);
    DicomFileBytes file = dicomParts(bytes);
    if (file.elements.empty()) return mutatedBytes(std::move(bytes), seed);
    const std::size_t changes = 1 + dice.below(4);
    for (std::size_t i = 0; i < changes; ++i) {
        std::vector<Elements*> lists;
        collect(file.elements, lists);
        if (dice.oneIn(12)) collect(file.meta, lists);
        if (dice.oneIn(16))
            changeSyntax(file, dice);
        else if (!lists.empty())
            changeList(*dice.oneOf(lists), lists, dice);
    }
    std::string changed = dicomBytes(file);
    if (dice.oneIn(16)) changed = withBytesChanged(std::move(changed), dice);
    if (changed.size() > longestMutation) changed.resize(longestMutation);
    return changed;
}

}  // namespace echolucent
