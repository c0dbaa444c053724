// A range of indices.
#pragma once

namespace echolucent {

/// A range of indices, both ends included; without an index if `last` is below `first`.
struct IndexRange {
    int first = 0;
    int last = -1;
    [[nodiscard]] bool empty() const { return last < first; }
    friend bool operator==(const IndexRange&, const IndexRange&) = default;
};

}  // namespace echolucent
