#include "tests/fuzz/mutations/kretz_mutation.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/fuzz/mutations/byte_mutation.h"

namespace echolucent {

namespace {

constexpr std::size_t signatureBytes = 16;

struct Item {
    std::uint16_t group = 0, element = 0;
    std::uint32_t length = 0;  ///< as declared
    std::string value;
};

// Tags that the reader asks for, some that it passes over, and the end.
constexpr std::array<std::pair<std::uint16_t, std::uint16_t>, 19> tags{{{0xC000, 1},
                                                                        {0xC000, 2},
                                                                        {0xC000, 3},
                                                                        {0xC100, 1},
                                                                        {0xC200, 1},
                                                                        {0xC200, 2},
                                                                        {0xC300, 1},
                                                                        {0xC300, 2},
                                                                        {0x0010, 0x22},
                                                                        {0xD000, 1},
                                                                        {0xD000, 2},
                                                                        {0xD600, 1},
                                                                        {0x0002, 0x1000},
                                                                        {0x0002, 0x1100},
                                                                        {0xD000, 0x101},
                                                                        {0xD000, 0x201},
                                                                        {0x0110, 2},
                                                                        {0x0000, 1},
                                                                        {0xFFFF, 0xFFFF}}};

std::vector<Item> itemsOf(const std::string& bytes, std::string& rest) {
    std::vector<Item> items;
    std::size_t at = signatureBytes;
    while (at + 8 <= bytes.size()) {
        Item item{valueAt<std::uint16_t>(bytes, at), valueAt<std::uint16_t>(bytes, at + 2),
                  valueAt<std::uint32_t>(bytes, at + 4), ""};
        item.value = bytes.substr(at + 8, item.length);
        at += 8 + item.value.size();
        items.push_back(std::move(item));
    }
    rest = bytes.substr(std::min(at, bytes.size()));
    return items;
}

std::string valueOfNumbers(Dice& dice) {
    std::string value;
    const std::size_t count = dice.oneIn(4) ? std::size_t{1} << dice.below(12) : 1 + dice.below(5);
    const bool reals = dice.oneIn(2);
    for (std::size_t i = 0; i < count; ++i) value += extremeField(dice, reals ? 8 : 2, reals);
    return value;
}

void changeItem(Item& item, Dice& dice) {
    const auto declare = [&] { item.length = static_cast<std::uint32_t>(item.value.size()); };
    switch (dice.below(6)) {
        case 0: std::tie(item.group, item.element) = dice.oneOf(tags); return;
        case 1: item.length = static_cast<std::uint32_t>(extremeWhole(dice)); return;
        case 2: item.length += static_cast<std::uint32_t>(dice.below(9)) - 4; return;
        case 3:
            item.value = valueOfNumbers(dice);
            declare();
            return;
        case 4: {
            // A number inside the value, whose length stays.
            const bool real = item.value.size() % 8 == 0;
            const std::size_t width = real ? 8 : 2;
            if (item.value.size() < width) return;
            item.value.replace(width * dice.below(item.value.size() / width), width, extremeField(dice, width, real));
            return;
        }
        default: item.value = withBytesChanged(item.value, dice); declare();
    }
}

void change(std::vector<Item>& items, Dice& dice) {
    const auto place = items.begin() + static_cast<std::ptrdiff_t>(dice.below(items.size()));
    switch (dice.below(8)) {
        case 0: items.erase(place); return;
        case 1: items.insert(place, Item(dice.oneOf(items))); return;
        case 2: std::swap(*place, dice.oneOf(items)); return;
        case 3: {
            const auto& [group, element] = dice.oneOf(tags);
            std::string value = valueOfNumbers(dice);
            const auto length = static_cast<std::uint32_t>(value.size());
            items.insert(place, Item{group, element, length, std::move(value)});
            return;
        }
        default: changeItem(*place, dice);
    }
}

}  // namespace

std::string mutatedKretz(std::string bytes, std::uint64_t seed) {
    if (bytes.size() < signatureBytes || !bytes.starts_with("KRETZ")) return mutatedBytes(std::move(bytes), seed);
    Dice dice(seed);
    std::string rest;
    std::vector<Item> items = itemsOf(bytes, rest);
    const std::size_t changes = 1 + dice.below(4);
    for (std::size_t i = 0; i < changes && !items.empty(); ++i) change(items, dice);
    std::string changed = bytes.substr(0, signatureBytes);
    for (const Item& item : items)
        changed += bytesOfValue(item.group) + bytesOfValue(item.element) + bytesOfValue(item.length) + item.value;
    changed += rest;
    if (dice.oneIn(20)) changed = withBytesChanged(std::move(changed), dice);
    if (changed.size() > longestMutation) changed.resize(longestMutation);
    return changed;
}

}  // namespace echolucent
