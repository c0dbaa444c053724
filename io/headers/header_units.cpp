#include "io/headers/header_units.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "io/files/header_text.h"
#include "processing/ascii_letters.h"

namespace echolucent {

namespace {

struct Unit {
    std::string_view name;
    double value;
};
constexpr std::array<Unit, 12> namesOfLengths{{{"nm", 1e-6},
                                               {"um", 1e-3},
                                               {"micron", 1e-3},
                                               {"microns", 1e-3},
                                               {"mm", 1.0},
                                               {"cm", 10.0},
                                               {"dm", 100.0},
                                               {"m", 1000.0},
                                               {"in", 25.4},
                                               {"inch", 25.4},
                                               {"inches", 25.4},
                                               {"mum", 1e-3}}};
constexpr std::array<Unit, 12> namesOfTimes{{{"ns", 1e-9},
                                             {"us", 1e-6},
                                             {"usec", 1e-6},
                                             {"ms", 1e-3},
                                             {"msec", 1e-3},
                                             {"s", 1.0},
                                             {"sec", 1.0},
                                             {"secs", 1.0},
                                             {"min", 60.0},
                                             {"minute", 60.0},
                                             {"minutes", 60.0},
                                             {"h", 3600.0}}};
constexpr std::array<Unit, 6> prefixes{
    {{"nano", 1e-9}, {"micro", 1e-6}, {"milli", 1e-3}, {"centi", 1e-2}, {"deci", 1e-1}, {"", 1.0}}};

/// The name in lower case, with a plain "u" for the sign of micro in UTF-8 (two code points) and in Latin-1.
std::string plainName(std::string_view unit) {
    std::string name = lowerCase(trimmed(unit));
    for (const std::string_view sign : {"\xc2\xb5", "\xce\xbc", "\xb5"})
        if (name.starts_with(sign)) return "u" + name.substr(sign.size());
    return name;
}

template <std::size_t count>
std::optional<double> valueOf(const std::array<Unit, count>& table, std::string_view name) {
    const auto found = std::find_if(table.begin(), table.end(), [&](const Unit& unit) { return unit.name == name; });
    return found == table.end() ? std::nullopt : std::optional(found->value);
}

/// The value of "millimetres" and the like, in units of `whole`, of which the name has one of these spellings.
std::optional<double> inFull(std::string name, std::initializer_list<std::string_view> spellings) {
    if (name.ends_with('s')) name.pop_back();
    for (const std::string_view spelling : spellings)
        if (name.ends_with(spelling))
            return valueOf(prefixes, std::string_view(name).substr(0, name.size() - spelling.size()));
    return std::nullopt;
}

}  // namespace

bool saysNoUnit(std::string_view unit) {
    const std::string name = lowerCase(trimmed(unit));
    return name.empty() || name == "none" || name == "?" || name == "???";
}

std::optional<double> mmOfUnit(std::string_view unit) {
    const std::string name = plainName(unit);
    if (const auto mm = valueOf(namesOfLengths, name)) return mm;
    const auto metres = inFull(name, {"meter", "metre"});
    return metres ? std::optional(*metres * 1000.0) : std::nullopt;
}

std::optional<double> secondsOfUnit(std::string_view unit) {
    const std::string name = plainName(unit);
    if (const auto seconds = valueOf(namesOfTimes, name)) return seconds;
    return inFull(name, {"second"});
}

bool LengthUnits::areOne() const {
    return std::all_of(mm.begin(), mm.end(), [&](double one) { return one == mm.front(); });
}

LengthUnits lengthUnits(const std::string& key, std::vector<std::string> words) {
    LengthUnits units{.mm = std::vector<double>(words.size(), 1.0), .warning = {}};
    std::size_t missing = 0;
    std::string stated;
    bool alike = true;
    for (std::size_t axis = 0; axis < words.size(); ++axis) {
        if (saysNoUnit(words[axis])) {
            ++missing;
            continue;
        }
        units.stated = true;
        const auto mm = mmOfUnit(words[axis]);
        if (!mm) {
            units.known = false;
            units.warning = fmt::format("{} names {}, which is not a known length.", key, quotedText(words[axis]));
            units.mm.assign(words.size(), 1.0);
            return units;
        }
        units.mm[axis] = *mm;
        alike = alike && (stated.empty() || mmOfUnit(stated) == mm);
        stated = words[axis];
    }
    if (!units.stated || missing == 0 || (alike && mmOfUnit(stated) == 1.0)) return units;
    if (missing + 1 == words.size()) {
        units.mm.assign(words.size(), *mmOfUnit(stated));
        units.warning = fmt::format("{} names {} once; it is taken for all axes.", key, quotedText(stated));
        return units;
    }
    units.known = false;
    units.mm.assign(words.size(), 1.0);
    units.warning = fmt::format("{} names {} for some axes and nothing for the others.", key, quotedText(stated));
    return units;
}

}  // namespace echolucent
