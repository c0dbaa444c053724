// The contents of a session file: the document, and its snapshots that a person named.
#pragma once

#include <string>
#include <vector>

#include "processing/document/document.h"

namespace echolucent {

/// The longest name of a snapshot, bytes of UTF-8.
inline constexpr std::size_t longestSnapshotName = 60;
/// The most snapshots of a session.
inline constexpr std::size_t mostSnapshots = 100;

struct Snapshot {
    std::string name;
    Document document;  ///< of the session's study
    friend bool operator==(const Snapshot&, const Snapshot&) = default;
};

struct SavedSession {
    Document document;
    std::vector<Snapshot> snapshots{};  ///< oldest first
    /// Path of the person's own session file, if any; only in a session that the program kept by itself.
    std::string file{};
    friend bool operator==(const SavedSession&, const SavedSession&) = default;
};

/// What is wrong with a snapshot's name: lower case, no full stop. It must have 1 to longestSnapshotName bytes and no
/// control characters. Empty if nothing is wrong.
[[nodiscard]] std::string problemOfSnapshotName(const std::string& name);

}  // namespace echolucent
