#include "io/stored/decimal_commas.h"

#include <algorithm>
#include <span>
#include <vector>

#include "io/files/input_problems.h"

namespace echolucent {

namespace {

bool isDigit(std::uint8_t byte) { return byte >= '0' && byte <= '9'; }

/// Takes one byte after the other.
class NumberCounter {
public:
    void take(std::uint8_t byte) {
        const bool separates = separatesNumbers(byte);
        if (m_commaAfterDigit && isDigit(byte)) ++m_found.commasWithin;
        if (m_commaAfterDigit && !isDigit(byte)) m_found.hasOtherCommas = true;
        m_commaAfterDigit = byte == ',' && isDigit(m_previous);
        if (byte == ',' && !m_commaAfterDigit) m_found.hasOtherCommas = true;
        if (!separates && separatesNumbers(m_previous)) ++m_found.numbers;
        if (separates && byte != ',') {
            m_marks = 0;
            m_inWord = false;
        } else {
            if (!m_inWord) ++m_found.words;
            m_inWord = true;
            if (byte == ',' || byte == '.') ++m_marks;
            if (m_marks > 1) m_hasTwoMarks = true;
        }
        m_previous = byte;
    }
    [[nodiscard]] TextNumbers found() const {
        TextNumbers found = m_found;
        found.hasOtherCommas = found.hasOtherCommas || m_commaAfterDigit || m_hasTwoMarks;
        return found;
    }

private:
    TextNumbers m_found;
    std::uint8_t m_previous = ' ';
    int m_marks = 0;  // commas and points in the present word
    bool m_inWord = false, m_commaAfterDigit = false, m_hasTwoMarks = false;
};

/// Calls take(span of bytes) with the bytes of an extent, until it returns false.
template <typename Take>
Result<void> readPieces(const InputFile& file, const VoxelExtent& extent, const Progress& progress, const Take& take) {
    constexpr std::uint64_t pieceBytes = std::uint64_t{1} << 20;
    std::vector<std::uint8_t> piece;
    for (std::uint64_t done = 0; done < extent.length; done += piece.size()) {
        if (progress.cancelled()) return fail(FailureKind::cancelled, file.path(), "", "was not read: cancelled");
        piece.resize(static_cast<std::size_t>(std::min(pieceBytes, extent.length - done)));
        if (const auto read = file.readAt(extent.offset + done, piece); !read) return tl::unexpected(read.error());
        if (!take(std::span<const std::uint8_t>(piece))) break;
    }
    return {};
}

}  // namespace

Result<bool> holdsComma(const InputFile& file, const VoxelExtent& extent, const Progress& progress) {
    bool found = false;
    const auto read = readPieces(file, extent, progress, [&](std::span<const std::uint8_t> piece) {
        found = std::ranges::find(piece, std::uint8_t{','}) != piece.end();
        return !found;
    });
    if (!read) return tl::unexpected(read.error());
    return found;
}

Result<TextNumbers> countNumbers(const InputFile& file, const VoxelExtent& extent, const Progress& progress) {
    NumberCounter counter;
    const auto read = readPieces(file, extent, progress, [&](std::span<const std::uint8_t> piece) {
        for (const std::uint8_t byte : piece) counter.take(byte);
        return true;
    });
    if (!read) return tl::unexpected(read.error());
    return counter.found();
}

}  // namespace echolucent
