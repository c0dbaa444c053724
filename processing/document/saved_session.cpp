#include "processing/document/saved_session.h"

#include <algorithm>

namespace echolucent {

std::string problemOfSnapshotName(const std::string& name) {
    if (name.empty()) return "must not be empty";
    if (name.size() > longestSnapshotName) return "must have at most " + std::to_string(longestSnapshotName) + " bytes";
    const auto controls = [](char each) { return static_cast<unsigned char>(each) < 0x20 || each == 0x7f; };
    return std::ranges::any_of(name, controls) ? "must not hold control characters" : "";
}

}  // namespace echolucent
