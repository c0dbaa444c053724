#include "tests/fuzz/mutations/json_mutation.h"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "tests/fuzz/mutations/byte_mutation.h"
#include "tests/io/document/mutations.h"

namespace echolucent {

namespace {

constexpr int deepestJson = 500;

/// What nests deeper is no JSON that the library can write again: it recurses.
bool isShallow(const std::string& text) {
    int depth = 0;
    for (const char letter : text) {
        if (letter == '[' || letter == '{') ++depth;
        if (letter == ']' || letter == '}') --depth;
        if (depth > deepestJson) return false;
    }
    return true;
}

}  // namespace

std::string mutatedJson(std::string bytes, std::uint64_t seed) {
    Dice dice(seed);
    const auto parsed =
        isShallow(bytes) ? nlohmann::ordered_json::parse(bytes, nullptr, false) : nlohmann::ordered_json();
    if (!parsed.is_structured() || parsed.empty()) return mutatedBytes(std::move(bytes), seed);
    Mutations mutations(std::move(bytes), static_cast<unsigned>(dice.number()), static_cast<int>(dice.below(10)));
    std::string changed = mutations.next();
    if (changed.size() > longestMutation) changed.resize(longestMutation);
    return changed;
}

}  // namespace echolucent
