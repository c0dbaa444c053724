#include "io/nifti/nifti_header.h"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

namespace echolucent {

namespace {

constexpr std::size_t bytesOfOne = shortestNiftiHeader, bytesOfTwo = niftiHeaderBytes;
constexpr std::string_view magicOfTwo("+2\0\r\n\x1a\n", 7);

/// Reads values from a header's bytes, in the byte order of the file.
class HeaderReader {
public:
    HeaderReader(std::string_view bytes, bool bigEndian) : m_bytes(bytes), m_bigEndian(bigEndian) {}
    /// The text in 80 bytes, up to its first zero.
    [[nodiscard]] std::string textAt(std::size_t offset) const {
        const std::string_view text = m_bytes.substr(offset, 80);
        return std::string(text.substr(0, text.find('\0')));
    }
    template <typename T>
    [[nodiscard]] T at(std::size_t offset) const {
        std::array<char, sizeof(T)> raw{};
        std::copy_n(m_bytes.begin() + static_cast<std::ptrdiff_t>(offset), sizeof(T), raw.begin());
        if (m_bigEndian) std::reverse(raw.begin(), raw.end());
        T value;
        std::memcpy(&value, raw.data(), sizeof(T));
        return value;
    }
    /// Fills `values` with consecutive values of type T from `offset` on.
    template <typename T, typename Values>
    void fill(std::size_t offset, Values& values) const {
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = static_cast<typename Values::value_type>(at<T>(offset + i * sizeof(T)));
    }

private:
    std::string_view m_bytes;
    bool m_bigEndian;
};

NiftiHeader headerOfOne(const HeaderReader& bytes) {
    NiftiHeader header;
    header.version = 1;
    bytes.fill<std::int16_t>(40, header.dim);
    header.intentCode = bytes.at<std::int16_t>(68);
    header.datatype = bytes.at<std::int16_t>(70);
    header.bitpix = bytes.at<std::int16_t>(72);
    bytes.fill<float>(76, header.pixdim);
    header.voxOffset = bytes.at<float>(108);
    header.sclSlope = bytes.at<float>(112);
    header.sclInter = bytes.at<float>(116);
    header.xyztUnits = bytes.at<std::uint8_t>(123);
    header.calMax = bytes.at<float>(124);
    header.calMin = bytes.at<float>(128);
    header.toffset = bytes.at<float>(136);
    header.descrip = bytes.textAt(148);
    header.qformCode = bytes.at<std::int16_t>(252);
    header.sformCode = bytes.at<std::int16_t>(254);
    bytes.fill<float>(256, header.quatern);
    bytes.fill<float>(268, header.qoffset);
    for (std::size_t row = 0; row < 3; ++row) bytes.fill<float>(280 + 16 * row, header.srow[row]);
    return header;
}

NiftiHeader headerOfTwo(const HeaderReader& bytes) {
    NiftiHeader header;
    header.version = 2;
    header.datatype = bytes.at<std::int16_t>(12);
    header.bitpix = bytes.at<std::int16_t>(14);
    bytes.fill<std::int64_t>(16, header.dim);
    bytes.fill<double>(104, header.pixdim);
    header.voxOffset = static_cast<double>(bytes.at<std::int64_t>(168));
    header.sclSlope = bytes.at<double>(176);
    header.sclInter = bytes.at<double>(184);
    header.calMax = bytes.at<double>(192);
    header.calMin = bytes.at<double>(200);
    header.toffset = bytes.at<double>(216);
    header.descrip = bytes.textAt(240);
    header.qformCode = bytes.at<std::int32_t>(344);
    header.sformCode = bytes.at<std::int32_t>(348);
    bytes.fill<double>(352, header.quatern);
    bytes.fill<double>(376, header.qoffset);
    for (std::size_t row = 0; row < 3; ++row) bytes.fill<double>(400 + 32 * row, header.srow[row]);
    header.xyztUnits = bytes.at<std::int32_t>(500);
    header.intentCode = bytes.at<std::int32_t>(504);
    return header;
}

/// Whether a file with a header of this length is big endian; no value if the file is shorter, or if its first number
/// is not that length.
std::optional<bool> bigEndianOf(std::string_view beginning, std::size_t headerBytes) {
    if (beginning.size() < headerBytes) return std::nullopt;
    for (const bool big : {false, true})
        if (HeaderReader(beginning, big).at<std::int32_t>(0) == static_cast<std::int32_t>(headerBytes)) return big;
    return std::nullopt;
}

/// Whether the magic puts the voxels into their own file ("ni") or the same file ("n+"); no value for other bytes.
std::optional<bool> apartOf(std::string_view magic, int version) {
    if (version == 1 && magic.substr(0, 4) == std::string_view("n+1\0", 4)) return false;
    if (version == 1 && magic.substr(0, 4) == std::string_view("ni1\0", 4)) return true;
    if (version == 2 && magic.starts_with('n') && magic.substr(1, 7) == magicOfTwo) return false;
    if (version == 2 && magic.starts_with("ni") && magic.substr(2, 6) == magicOfTwo.substr(1)) return true;
    return std::nullopt;
}

}  // namespace

std::string niftiWhiteText(double black, double white, std::string_view typeName) {
    if (black == 0.0) return fmt::format("Echolucent white level {} of {}", white, typeName);
    // The header holds float32, whose shortest text fits into the 80 bytes of descrip.
    return fmt::format("Echolucent black level {}, white level {} of {}", static_cast<float>(black),
                       static_cast<float>(white), typeName);
}

bool looksLikeNifti(std::string_view beginning) { return niftiHeaderIn(beginning).has_value(); }

bool looksLikeAnalyze(std::string_view beginning) {
    constexpr std::size_t regularAt = 38;  // Analyze's own constant, "r"
    return bigEndianOf(beginning, bytesOfOne) && !looksLikeNifti(beginning) && beginning[regularAt] == 'r';
}

bool beginsLikeNifti(std::string_view beginning) {
    constexpr std::size_t lengthBytes = 4;
    if (beginning.size() < lengthBytes) return false;
    for (const bool big : {false, true}) {
        const auto length = HeaderReader(beginning, big).at<std::int32_t>(0);
        if (length == static_cast<std::int32_t>(bytesOfOne) || length == static_cast<std::int32_t>(bytesOfTwo))
            return beginning.size() < static_cast<std::size_t>(length);
    }
    return false;
}

std::optional<NiftiHeader> niftiHeaderIn(std::string_view beginning) {
    for (const int version : {1, 2}) {
        const auto big = bigEndianOf(beginning, version == 1 ? bytesOfOne : bytesOfTwo);
        if (!big) continue;
        const auto apart = apartOf(beginning.substr(version == 1 ? 344 : 4), version);
        if (!apart) continue;
        const HeaderReader bytes(beginning, *big);
        NiftiHeader header = version == 1 ? headerOfOne(bytes) : headerOfTwo(bytes);
        header.bigEndian = *big;
        header.voxelsApart = *apart;
        return header;
    }
    return std::nullopt;
}

}  // namespace echolucent
