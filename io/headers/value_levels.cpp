#include "io/headers/value_levels.h"

#include <cmath>

#include "io/files/header_text.h"

namespace echolucent {

namespace {

std::optional<double> finiteNumber(const std::string& text) {
    const auto number = realNumber(text);
    return number && std::isfinite(*number) ? number : std::nullopt;
}

}  // namespace

tl::expected<void, LevelProblem> readLevels(const std::string* black, const std::string* white, StoredVolume& stored) {
    const auto wrong = [](const char* key, const std::string& problem) {
        return tl::unexpected(LevelProblem{key, problem});
    };
    if (black != nullptr) {
        stored.blackLevel = finiteNumber(*black);
        stored.blackLevelSource = "BlackLevel";
        // Above, doubles would leave no room for white.
        constexpr double most = 1.7e308;
        if (!stored.blackLevel || *stored.blackLevel > most)
            return wrong("BlackLevel", "must be a number below 1.7e308, not " + quotedText(*black));
    }
    if (white == nullptr) return {};
    stored.whiteLevel = finiteNumber(*white);
    stored.whiteLevelSource = "WhiteLevel";
    if (!stored.whiteLevel || !(*stored.whiteLevel > stored.blackLevel.value_or(0.0)))
        return wrong("WhiteLevel", std::string("must be a number above ") + (black != nullptr ? "BlackLevel" : "0") +
                                       ", not " + quotedText(*white));
    return {};
}

}  // namespace echolucent
