// Parallel loops. A loop calls its body through a pointer, once for each part, so that only parallel.cpp sees oneTBB.
#pragma once

#include <cstddef>
#include <cstdint>

namespace echolucent {

/// The indices of [first, last). A parallel loop splits them into parts. A part of at most `grain` (>= 1) indices is
/// not split.
template <typename Index>
class LoopRange {
public:
    LoopRange(Index first, Index last, Index grain = 1) : m_first(first), m_last(last), m_grain(grain) {}
    [[nodiscard]] Index begin() const { return m_first; }
    [[nodiscard]] Index end() const { return m_last; }
    [[nodiscard]] Index grain() const { return m_grain; }
    [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(m_last - m_first); }

private:
    Index m_first, m_last, m_grain;
};

/// The indices of [0, rows) by [0, columns). A parallel loop splits the rectangle along both.
template <typename Index>
class LoopRectangle {
public:
    LoopRectangle(Index rows, Index columns) : m_rows(0, rows), m_columns(0, columns) {}
    [[nodiscard]] const LoopRange<Index>& rows() const { return m_rows; }
    [[nodiscard]] const LoopRange<Index>& columns() const { return m_columns; }

    /// A part of a rectangle, as the bodies of loops get it. Loops themselves go over whole rectangles only.
    [[nodiscard]] static LoopRectangle part(const LoopRange<Index>& rows, const LoopRange<Index>& columns) {
        LoopRectangle rectangle(0, 0);
        rectangle.m_rows = rows;
        rectangle.m_columns = columns;
        return rectangle;
    }

private:
    LoopRange<Index> m_rows, m_columns;
};

/// The parts of parallelFor().
namespace parallel {

using Part = LoopRange<std::int64_t>;
using Tile = LoopRectangle<std::int64_t>;

/// Splits `range` into parts and calls call(body, part) for each, on the threads of oneTBB's arena, the caller's among
/// them. If a call throws, parts that wait are left out, and the caller gets the first exception once all running calls
/// have ended.
void forParts(const Part& range, void (*call)(const void* body, const Part& part), const void* body);
/// As forParts(), for tiles of a rectangle.
void forTiles(const Tile& range, void (*call)(const void* body, const Tile& tile), const void* body);

/// A part in the caller's type of indices.
template <typename Index>
[[nodiscard]] LoopRange<Index> partAs(const Part& part) {
    return {static_cast<Index>(part.begin()), static_cast<Index>(part.end()), static_cast<Index>(part.grain())};
}

}  // namespace parallel

/// Splits `range` into parts, each a LoopRange<Index>, and calls `body` on each.
template <typename Index, typename Body>
void parallelFor(const LoopRange<Index>& range, const Body& body) {
    const auto call = [](const void* of, const parallel::Part& part) {
        (*static_cast<const Body*>(of))(parallel::partAs<Index>(part));
    };
    parallel::forParts({static_cast<std::int64_t>(range.begin()), static_cast<std::int64_t>(range.end()),
                        static_cast<std::int64_t>(range.grain())},
                       call, &body);
}

/// Splits `range` into tiles, each a LoopRectangle<Index>, and calls `body` on each.
template <typename Index, typename Body>
void parallelFor(const LoopRectangle<Index>& range, const Body& body) {
    const auto call = [](const void* of, const parallel::Tile& tile) {
        (*static_cast<const Body*>(of))(
            LoopRectangle<Index>::part(parallel::partAs<Index>(tile.rows()), parallel::partAs<Index>(tile.columns())));
    };
    parallel::forTiles(
        {static_cast<std::int64_t>(range.rows().end()), static_cast<std::int64_t>(range.columns().end())}, call, &body);
}

/// Calls body(index) for every index of [first, last).
template <typename Index, typename Body>
void parallelFor(Index first, Index last, const Body& body) {
    if (first >= last) return;
    parallelFor(LoopRange<Index>(first, last), [&](const LoopRange<Index>& part) {
        for (Index index = part.begin(); index < part.end(); ++index) body(index);
    });
}

}  // namespace echolucent
