#include "io/voxels/voxel_encoding.h"

#include <bzlib.h>
#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <optional>
#include <type_traits>
#include <utility>

#include "io/files/header_text.h"
#include "io/voxels/typed_bytes.h"

namespace echolucent {

namespace {

using Step = VoxelDecoder::Step;
using Problem = VoxelDecoder::Problem;
using Decoded = tl::expected<Step, Problem>;

/// The failure of compressed bytes. `detail` says what is wrong.
tl::unexpected<Problem> damagedBy(std::string detail) {
    Problem problem;
    problem.what = "has damaged compressed data";
    problem.detail = std::move(detail);
    return tl::unexpected<Problem>(std::move(problem));
}

// The beginning of a member of gzip or bzip2. Files may hold several members, one after another.
constexpr std::string_view gzipMagic = "\x1f\x8b", bzip2Magic = "BZh";

/// zlib's error in words that need no knowledge of zlib.
const char* zlibProblem(int status, const char* message, bool isGzip) {
    const std::string_view says = message != nullptr ? message : "";
    if (status == Z_NEED_DICT) return "they need a dictionary that the file does not hold";
    if (says == "incorrect data check")
        return isGzip ? "their checksum (CRC-32) does not match" : "their checksum (Adler-32) does not match";
    if (says == "incorrect length check") return "the length beside their checksum does not match";
    if (says == "header crc mismatch") return "the checksum of the gzip header does not match";
    for (const std::string_view unlike :
         {"incorrect header check", "unknown compression method", "invalid window size", "unknown header flags set"})
        if (says == unlike) return "they begin like neither zlib nor gzip";
    return "a block cannot be decoded";
}

/// bzip2's error in words that need no knowledge of bzip2.
const char* bzip2Problem(int status) {
    return status == BZ_DATA_ERROR_MAGIC ? "they do not begin like bzip2"
                                         : "a block cannot be decoded, or its checksum (CRC) does not match";
}

std::string_view asText(std::span<const std::uint8_t> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

class ZlibDecoder : public VoxelDecoder {
public:
    ZlibDecoder() {
        // 15 bits for the window; 32 more let zlib tell its own format from gzip.
        if (inflateInit2(&m_stream, 15 + 32) != Z_OK) throw std::bad_alloc();
    }
    ~ZlibDecoder() override { inflateEnd(&m_stream); }
    ZlibDecoder(const ZlibDecoder&) = delete;
    ZlibDecoder& operator=(const ZlibDecoder&) = delete;

    Decoded decode(std::span<const std::uint8_t> input, bool isLast, std::span<std::uint8_t> output) override {
        m_stream.next_in = const_cast<Bytef*>(input.data());
        m_stream.avail_in = static_cast<uInt>(input.size());
        m_stream.next_out = output.data();
        m_stream.avail_out = static_cast<uInt>(output.size());
        const auto step = [&](bool ended) {
            return Step{input.size() - m_stream.avail_in, output.size() - m_stream.avail_out, ended};
        };
        while (true) {
            const std::string_view rest = asText(input.last(m_stream.avail_in));
            if (m_between) {
                if (rest.size() < gzipMagic.size() && !isLast) return step(false);
                if (!m_gzip || !rest.starts_with(gzipMagic)) return step(true);
                inflateReset(&m_stream);
                m_between = false;
            } else if (m_stream.total_in == 0 && !rest.empty()) {
                m_gzip = rest.front() == gzipMagic.front();
            }
            const int status = inflate(&m_stream, Z_NO_FLUSH);
            if (status == Z_MEM_ERROR) throw std::bad_alloc();
            if (status != Z_STREAM_END && status != Z_OK && status != Z_BUF_ERROR)
                return damagedBy(zlibProblem(status, m_stream.msg, m_gzip));
            m_between = status == Z_STREAM_END;
            if (!m_between) return step(false);
        }
    }

private:
    z_stream m_stream{};
    bool m_gzip = false;     // zlib's own format has one member
    bool m_between = false;  // a member has ended; another one may follow
};

class Bzip2Decoder : public VoxelDecoder {
public:
    Bzip2Decoder() {
        if (BZ2_bzDecompressInit(&m_stream, 0, 0) != BZ_OK) throw std::bad_alloc();
    }
    ~Bzip2Decoder() override { BZ2_bzDecompressEnd(&m_stream); }
    Bzip2Decoder(const Bzip2Decoder&) = delete;
    Bzip2Decoder& operator=(const Bzip2Decoder&) = delete;

    Decoded decode(std::span<const std::uint8_t> input, bool isLast, std::span<std::uint8_t> output) override {
        m_stream.next_in = const_cast<char*>(reinterpret_cast<const char*>(input.data()));
        m_stream.avail_in = static_cast<unsigned>(input.size());
        m_stream.next_out = reinterpret_cast<char*>(output.data());
        m_stream.avail_out = static_cast<unsigned>(output.size());
        const auto step = [&](bool ended) {
            return Step{input.size() - m_stream.avail_in, output.size() - m_stream.avail_out, ended};
        };
        while (true) {
            if (m_between) {
                const std::string_view rest = asText(input.last(m_stream.avail_in));
                if (rest.size() < bzip2Magic.size() && !isLast) return step(false);
                if (!rest.starts_with(bzip2Magic)) return step(true);
                beginAnother();
            }
            const int status = BZ2_bzDecompress(&m_stream);
            if (status == BZ_MEM_ERROR) throw std::bad_alloc();
            if (status != BZ_OK && status != BZ_STREAM_END) return damagedBy(bzip2Problem(status));
            m_between = status == BZ_STREAM_END;
            if (!m_between) return step(false);
        }
    }

private:
    /// Begins another member where the one before ended in input and output. bzip2 itself has no reset.
    void beginAnother() {
        const bz_stream places = m_stream;
        BZ2_bzDecompressEnd(&m_stream);
        m_stream = {};
        if (BZ2_bzDecompressInit(&m_stream, 0, 0) != BZ_OK) throw std::bad_alloc();
        m_stream.next_in = places.next_in;
        m_stream.avail_in = places.avail_in;
        m_stream.next_out = places.next_out;
        m_stream.avail_out = places.avail_out;
        m_between = false;
    }

    bz_stream m_stream{};
    bool m_between = false;  // a member has ended; another one may follow
};

/// A word as a value; no value if it is no number of this type.
template <typename T>
std::optional<T> valueFrom(std::string_view word) {
    if constexpr (!std::is_floating_point_v<T>) {
        T whole{};
        const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), whole);
        if (problem == std::errc() && end == word.data() + word.size()) return whole;
    }
    const auto number = realNumber(word);
    if (!number) return std::nullopt;
    if constexpr (std::is_floating_point_v<T>) {
        return static_cast<T>(*number);
    } else {
        // Programs that know only doubles write whole numbers as 12.0 or 1.2e1.
        constexpr double high = static_cast<double>(std::numeric_limits<T>::max());
        constexpr double low = static_cast<double>(std::numeric_limits<T>::min());
        const bool fits = sizeof(T) == 8 ? *number < high : *number <= high;
        if (!(fits && *number >= low) || *number != std::floor(*number)) return std::nullopt;
        return static_cast<T>(*number);
    }
}

template <typename T>
class TextDecoder : public VoxelDecoder {
public:
    explicit TextDecoder(bool decimalCommas) : m_decimalCommas(decimalCommas) {}

    Decoded decode(std::span<const std::uint8_t> input, bool isLast, std::span<std::uint8_t> output) override {
        constexpr std::size_t longestNumber = 64;
        Step step;
        while (step.given + sizeof(T) <= output.size()) {
            while (step.taken < input.size() && separates(input[step.taken])) ++step.taken;
            std::size_t end = step.taken;
            while (end < input.size() && !separates(input[end]) && end - step.taken <= longestNumber) ++end;
            const std::string_view word(reinterpret_cast<const char*>(input.data()) + step.taken, end - step.taken);
            if (word.size() <= longestNumber && end == input.size() && !isLast) return step;  // it may go on
            if (word.empty()) {
                step.ended = true;
                return step;
            }
            const auto value = word.size() <= longestNumber ? valueOf(word) : std::nullopt;
            if (!value) return tl::unexpected(Problem{"has text that is no voxel of its type", quotedText(word)});
            std::memcpy(output.data() + step.given, &*value, sizeof(T));
            step.given += sizeof(T);
            step.taken = end;
        }
        return step;
    }

private:
    [[nodiscard]] bool separates(std::uint8_t byte) const {
        return separatesNumbers(byte) && !(m_decimalCommas && byte == ',');
    }
    [[nodiscard]] std::optional<T> valueOf(std::string_view word) const {
        if (!m_decimalCommas) return valueFrom<T>(word);
        std::string points(word);
        std::replace(points.begin(), points.end(), ',', '.');
        return valueFrom<T>(points);
    }
    bool m_decimalCommas;
};

class HexDecoder : public VoxelDecoder {
public:
    Decoded decode(std::span<const std::uint8_t> input, bool isLast, std::span<std::uint8_t> output) override {
        Step step;
        for (; step.taken < input.size() && step.given < output.size(); ++step.taken) {
            const std::uint8_t byte = input[step.taken];
            if (separatesNumbers(byte) && byte != ',') continue;
            const auto digit = digitOf(byte);
            if (!digit)
                return tl::unexpected(Problem{"has text that is no hexadecimal digit",
                                              quotedText({reinterpret_cast<const char*>(&byte), 1})});
            if (m_high) output[step.given++] = static_cast<std::uint8_t>(*m_high << 4 | *digit);
            m_high = m_high ? std::nullopt : digit;
        }
        step.ended = isLast && step.taken == input.size();
        return step;
    }

private:
    static std::optional<std::uint8_t> digitOf(std::uint8_t byte) {
        if (byte >= '0' && byte <= '9') return static_cast<std::uint8_t>(byte - '0');
        if (byte >= 'a' && byte <= 'f') return static_cast<std::uint8_t>(byte - 'a' + 10);
        if (byte >= 'A' && byte <= 'F') return static_cast<std::uint8_t>(byte - 'A' + 10);
        return std::nullopt;
    }
    std::optional<std::uint8_t> m_high;
};

std::unique_ptr<VoxelDecoder> textDecoder(StoredType type, bool decimalCommas) {
    return withStoredType(type, [&]<typename T>(T) -> std::unique_ptr<VoxelDecoder> {
        return std::make_unique<TextDecoder<T>>(decimalCommas);
    });
}

}  // namespace

std::string_view compressionWords(VoxelEncoding encoding) {
    switch (encoding) {
        case VoxelEncoding::raw: return "none";
        case VoxelEncoding::zlib: return "zlib/gzip, lossless";
        case VoxelEncoding::bzip2: return "bzip2, lossless";
        case VoxelEncoding::text: return "none, written as decimal text";
        case VoxelEncoding::hex: return "none, written as hexadecimal text";
    }
    return {};
}

bool isCompressed(VoxelEncoding encoding) {
    return encoding == VoxelEncoding::zlib || encoding == VoxelEncoding::bzip2;
}

bool separatesNumbers(std::uint8_t byte) { return byte == ' ' || (byte >= '\t' && byte <= '\r') || byte == ','; }

std::unique_ptr<VoxelDecoder> makeVoxelDecoder(VoxelEncoding encoding, StoredType type, bool decimalCommas) {
    switch (encoding) {
        case VoxelEncoding::raw: return nullptr;
        case VoxelEncoding::zlib: return std::make_unique<ZlibDecoder>();
        case VoxelEncoding::bzip2: return std::make_unique<Bzip2Decoder>();
        case VoxelEncoding::text: return textDecoder(type, decimalCommas);
        case VoxelEncoding::hex: return std::make_unique<HexDecoder>();
    }
    return nullptr;
}

}  // namespace echolucent
