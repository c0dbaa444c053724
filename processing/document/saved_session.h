// What a session file keeps: the document, and the snapshots of it that a person named.
#pragma once

#include <string>
#include <vector>

#include "processing/document/document.h"

namespace echolucent {

/// The longest name of a snapshot, bytes of UTF-8.
inline constexpr std::size_t longestSnapshotName = 60;
/// So many snapshots a session may hold.
inline constexpr std::size_t mostSnapshots = 100;

/// A document under a name.
struct Snapshot {
    std::string name;
    Document document;  ///< of the session's study
    friend bool operator==(const Snapshot&, const Snapshot&) = default;
};

/// A document with its snapshots.
struct SavedSession {
    Document document;
    std::vector<Snapshot> snapshots{};  ///< oldest first
    std::string file{};  ///< of what was kept without being asked for: path of the person's own session file, if any
    friend bool operator==(const SavedSession&, const SavedSession&) = default;
};

/// What is wrong with a snapshot's name, lower case, no full stop; an empty text where nothing is: it has 1 to
/// longestSnapshotName bytes and no control characters.
[[nodiscard]] std::string problemOfSnapshotName(const std::string& name);

}  // namespace echolucent
