#include "io/dicom/dicom_scan.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "io/dicom/byte_stream.h"
#include "io/headers/header_text.h"
#include "io/input_file.h"

namespace echolucent {

namespace {

constexpr std::uint64_t endless = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint32_t undefinedLength = 0xffffffffU;
constexpr std::uint32_t itemTag = 0xfffee000U;
constexpr std::uint32_t itemEndTag = 0xfffee00dU;
constexpr std::uint32_t sequenceEndTag = 0xfffee0ddU;
constexpr std::uint32_t pixelDataTag = 0x7fe00010U;
constexpr std::uint32_t sopClassTag = 0x00080016U;
constexpr std::uint32_t kretzGroup = 0x7fe1;
constexpr std::string_view kretzCreator = "KRETZ_US";

enum class LevelKind { dataset, sequence, item, fragments };

struct Level {
    LevelKind kind = LevelKind::dataset;
    std::uint64_t end = endless;
    bool implicitVr = false;
    bool pixels = false;                            // whether it is the pixel data
    std::optional<std::uint64_t> falseLength = {};  // where a length stands that has to be written anew
    std::uint64_t start = 0;
};

bool isVrLetter(char character) { return character >= 'A' && character <= 'Z'; }

bool isVr(const std::uint8_t* bytes) {
    return bytes[0] >= 'A' && bytes[0] <= 'Z' && bytes[1] >= 'A' && bytes[1] <= 'Z';
}

bool hasLongLength(std::string_view vr) {
    constexpr std::array<std::string_view, 13> longVrs{"OB", "OW", "OF", "OD", "OL", "OV", "SQ",
                                                       "UN", "UC", "UR", "UT", "SV", "UV"};
    return std::find(longVrs.begin(), longVrs.end(), vr) != longVrs.end();
}

class Walk {
public:
    Walk(const InputFile& file, DicomScan& scan) : m_file(file), m_stream(file), m_scan(scan) {}

    /// False where sequences are nested too deep. Ends early where the person cancels.
    bool run(const Progress& progress, bool headerOnly) {
        if (!readMeta()) return true;
        const auto enough = [&] { return headerOnly && m_behindKretz; };
        while (!progress.cancelled() && !enough() && step() && m_sequences <= deepestSequence) {
        }
        if (!progress.cancelled() && !enough() && m_sequences <= deepestSequence) closeAtEnd();
        return m_sequences <= deepestSequence;
    }

private:
    bool readMeta();
    bool step();
    bool readElement(std::uint32_t tag);
    bool readDelimiter(std::uint32_t tag);
    bool enterValue(std::uint32_t tag, std::string_view vr, std::uint32_t length);
    bool enterIfItem(std::uint32_t length);
    bool recover();
    bool leaveOutItem(std::uint32_t length);
    void closeAtEnd();
    void writeLength();
    void push(LevelKind kind, std::uint32_t length, bool implicitVr);
    void pop();
    void notePixelData(std::uint32_t length);

    std::optional<std::uint32_t> readTag();
    std::optional<std::uint32_t> read32();
    std::optional<std::uint32_t> read16();

    const InputFile& m_file;
    ByteStream m_stream;
    DicomScan& m_scan;
    std::vector<Level> m_levels;
    int m_sequences = 0;
    bool m_bigEndian = false;
    std::optional<std::uint32_t> m_pendingTag;   // a tag that was read ahead
    std::uint64_t m_emptySequenceEnd = endless;  // where a sequence ended that is declared to be empty
    bool m_behindKretz = false;                  // whether the group in which GE keeps volumes is passed
    std::uint64_t m_stepStart = 0;               // where the last step began
};

std::optional<std::uint32_t> Walk::read16() {
    std::array<std::uint8_t, 2> b{};
    if (!m_stream.read(b.data(), b.size())) return std::nullopt;
    return m_bigEndian ? b[0] << 8 | b[1] : b[1] << 8 | b[0];
}

std::optional<std::uint32_t> Walk::read32() {
    const auto first = read16();
    const auto second = read16();
    if (!first || !second) return std::nullopt;
    return m_bigEndian ? *first << 16 | *second : *second << 16 | *first;
}

std::optional<std::uint32_t> Walk::readTag() {
    if (m_pendingTag) return std::exchange(m_pendingTag, std::nullopt);
    const auto group = read16();
    const auto element = read16();
    if (!group || !element) return std::nullopt;
    return *group << 16 | *element;
}

/// Reads preamble and meta header, and from there how the data set is written. False where the file is too short.
bool Walk::readMeta() {
    const auto beginning = m_file.beginning(132);
    if (!beginning || beginning->size() < 8) return false;
    const bool preamble = beginning->size() == 132 && beginning->substr(128) == "DICM";
    m_stream.skip(preamble ? 132 : 0);
    std::optional<std::uint32_t> tag;
    while ((tag = readTag()) && *tag >> 16 == 0x0002) {
        std::array<std::uint8_t, 2> vr{};
        if (!m_stream.read(vr.data(), 2)) return false;
        const bool isLong = hasLongLength({reinterpret_cast<const char*>(vr.data()), 2});
        if (isLong) m_stream.skip(2);
        const auto length = isLong ? read32() : read16();
        if (!length) return false;
        const bool wanted = *tag == 0x00020010 || *tag == 0x00020002;
        if (wanted && *length <= 128) {
            std::string value(*length, '\0');
            if (!m_stream.read(reinterpret_cast<std::uint8_t*>(value.data()), value.size())) return false;
            value = trimmed(value.substr(0, value.find('\0')));
            (*tag == 0x00020010 ? m_scan.transferSyntax : m_scan.sopClass) = value;
        } else {
            m_stream.skip(*length);
        }
    }
    if (!tag) return false;
    if (m_scan.transferSyntax == "1.2.840.10008.1.2.1.99") {
        // The tag just read was already deflated data: go back to it.
        ByteStream again(m_file);
        again.skip(m_stream.position() - 4);
        m_stream = std::move(again);
        m_stream.inflateFromHere();
    } else {
        m_bigEndian = m_scan.transferSyntax == "1.2.840.10008.1.2.2";
        const std::uint32_t swapped =
            (*tag >> 24 & 0xff) << 16 | (*tag >> 16 & 0xff) << 24 | (*tag & 0xff) << 8 | (*tag >> 8 & 0xff);
        if (!m_bigEndian && m_scan.transferSyntax.empty()) m_bigEndian = *tag >> 16 == 0x0800;
        m_pendingTag = m_bigEndian ? swapped : *tag;
    }
    Level dataset;
    dataset.implicitVr = m_scan.transferSyntax == "1.2.840.10008.1.2";
    if (m_scan.transferSyntax.empty()) {
        std::array<std::uint8_t, 2> vr{};
        if (m_file.readAt(m_stream.position(), vr)) dataset.implicitVr = !isVr(vr.data());
    }
    m_levels.push_back(dataset);
    return true;
}

void Walk::push(LevelKind kind, std::uint32_t length, bool implicitVr) {
    const std::uint64_t start = m_stream.position() - (m_pendingTag ? 4 : 0);
    Level level;
    level.kind = kind;
    level.start = start;
    level.end = length == undefinedLength ? endless : start + length;
    level.implicitVr = implicitVr;
    m_levels.push_back(level);
    m_sequences += kind == LevelKind::sequence ? 1 : 0;
}

void Walk::pop() {
    m_scan.pixelsEnd = m_scan.pixelsEnd || m_levels.back().pixels;
    m_sequences -= m_levels.back().kind == LevelKind::sequence ? 1 : 0;
    m_levels.pop_back();
}

/// Leaves what cannot be understood at the nearest end that is known; false where no end is known.
bool Walk::recover() {
    m_pendingTag.reset();
    while (m_levels.size() > 1) {
        const Level level = m_levels.back();
        pop();
        if (level.end == endless || level.end < m_stream.position()) continue;
        const std::uint64_t rest = level.end - m_stream.position();
        return m_stream.skip(rest) == rest;
    }
    return false;
}

bool Walk::step() {
    const std::uint64_t position = m_stream.position() - (m_pendingTag ? 4 : 0);
    m_stepStart = position;
    if (m_levels.size() > 1 && position >= m_levels.back().end) {
        pop();
        return true;
    }
    const auto tag = readTag();
    if (!tag) return false;
    if (*tag >> 16 == 0xfffe) return readDelimiter(*tag);
    const LevelKind kind = m_levels.back().kind;
    if (m_levels.back().falseLength) {
        m_pendingTag = tag;
        writeLength();
        return true;
    }
    if (kind == LevelKind::sequence || kind == LevelKind::fragments) return recover();
    return readElement(*tag);
}

bool Walk::readDelimiter(std::uint32_t tag) {
    const auto length = read32();
    if (!length) return false;
    const LevelKind kind = m_levels.back().kind;
    if (tag == itemTag) {
        if (kind == LevelKind::fragments) return *length != undefinedLength && m_stream.skip(*length) == *length;
        if (kind != LevelKind::sequence && !m_stream.inflates() && m_levels.size() == 1 &&
            m_stream.position() - 8 == m_emptySequenceEnd) {
            // The items of a sequence follow although its length is declared as 0.
            push(LevelKind::sequence, undefinedLength, false);
            m_levels.back().start = m_emptySequenceEnd;
            m_levels.back().falseLength = m_emptySequenceEnd - 4;
        } else if (kind != LevelKind::sequence) {
            return leaveOutItem(*length) || recover();
        }
        push(LevelKind::item, *length, m_levels.back().implicitVr);
        return true;
    }
    if (tag == itemEndTag && kind == LevelKind::item) {
        pop();
        return true;
    }
    if (tag == sequenceEndTag && (kind == LevelKind::sequence || kind == LevelKind::fragments)) {
        pop();
        return true;
    }
    return recover();
}

bool Walk::readElement(std::uint32_t tag) {
    if (m_levels.back().implicitVr) {
        const auto length = read32();
        return length && enterValue(tag, "", *length);
    }
    std::array<std::uint8_t, 2> bytes{};
    if (!m_stream.read(bytes.data(), 2)) return false;
    const std::string_view vr(reinterpret_cast<const char*>(bytes.data()), 2);
    const bool isLong = hasLongLength(vr);
    if (isLong && m_stream.skip(2) != 2) return false;
    const auto length = isLong ? read32() : read16();
    return length && enterValue(tag, vr, *length);
}

void Walk::notePixelData(std::uint32_t length) {
    m_scan.hasPixelData = true;
    m_scan.pixelStart = m_stream.position();
    if (length == undefinedLength) return;
    m_scan.pixelBytesDeclared = length;
    if (m_scan.transferSyntax != "1.2.840.10008.1.2.1.99")
        m_scan.pixelBytesHeld = std::min<std::uint64_t>(length, m_file.size() - m_stream.position());
    else
        m_scan.pixelBytesHeld = length;
}

bool Walk::enterValue(std::uint32_t tag, std::string_view vr, std::uint32_t length) {
    const bool pixels = tag == pixelDataTag && m_levels.size() == 1;
    m_behindKretz = m_behindKretz || (m_levels.size() == 1 && tag >> 16 > kretzGroup);
    if (m_levels.size() == 1 && tag >> 16 == kretzGroup && length == kretzCreator.size()) {
        std::string value(length, '\0');
        if (!m_stream.read(reinterpret_cast<std::uint8_t*>(value.data()), value.size())) return false;
        m_scan.holdsKretz = m_scan.holdsKretz || ((tag & 0xffff) <= 0xff && value == kretzCreator);
        return true;
    }
    if (pixels) notePixelData(length);
    if (tag == sopClassTag && m_levels.size() == 1 && m_scan.sopClass.empty() && length <= 64) {
        std::string value(length, '\0');
        if (!m_stream.read(reinterpret_cast<std::uint8_t*>(value.data()), value.size())) return false;
        m_scan.sopClass = trimmed(value.substr(0, value.find('\0')));
        return true;
    }
    const bool implicitVr = m_levels.back().implicitVr;
    if (length == undefinedLength) {
        const bool fragments = !implicitVr && vr != "SQ" && vr != "UN";
        push(fragments ? LevelKind::fragments : LevelKind::sequence, length, implicitVr || vr == "UN");
        m_levels.back().pixels = pixels;
        return true;
    }
    if (vr == "SQ") {
        if (length == 0) m_emptySequenceEnd = m_stream.position();
        push(LevelKind::sequence, length, false);
        return true;
    }
    if (implicitVr || vr == "UN") return enterIfItem(length);
    const bool whole = m_stream.skip(length) == length;
    m_scan.pixelsEnd = m_scan.pixelsEnd || (pixels && whole);
    return whole;
}

/// Makes an element of an item that stands in the data set itself, in no sequence: one that nobody asks for. False
/// where that cannot be.
bool Walk::leaveOutItem(std::uint32_t length) {
    const Level& level = m_levels.back();
    if (m_stream.inflates() || m_levels.size() > 1 || level.implicitVr || m_bigEndian || length > 0xfffe) return false;
    const std::uint64_t start = m_stream.position() - 8;
    if (m_stream.skip(length) != length) return false;
    std::string header("\x08\x00\xff\xffST", 6);
    header += static_cast<char>(length & 0xff);
    header += static_cast<char>(length >> 8);
    m_scan.repairs.push_back({start, header});
    m_scan.notes.emplace_back("An item that belongs to no sequence is left out.");
    return true;
}

/// Ends a sequence that is declared to be empty where its last item ended, and notes its true length.
void Walk::writeLength() {
    const std::uint64_t position = m_stream.position() - (m_pendingTag ? 4 : 0);
    const Level level = m_levels.back();
    pop();
    const auto length = static_cast<std::uint32_t>(position - level.start);
    std::string bytes;
    for (int byte = 0; byte < 4; ++byte)
        bytes += static_cast<char>(length >> 8 * (m_bigEndian ? 3 - byte : byte) & 0xff);
    m_scan.repairs.push_back({*level.falseLength, bytes});
    if (m_scan.repairs.size() == 1)
        m_scan.notes.emplace_back(
            "A sequence is declared to be empty although items follow; they are read as its own.");
}

/// Where the file ends between elements and nothing but delimiters is missing, they are noted.
void Walk::closeAtEnd() {
    if (m_stream.inflates() || m_levels.empty() || m_stepStart != m_file.size()) return;
    while (m_levels.size() > 1 && m_levels.back().end == m_stream.position()) pop();
    if (m_levels.back().falseLength) writeLength();
    std::string delimiters;
    for (std::size_t i = m_levels.size(); i-- > 1;) {
        if (m_levels[i].end != endless || m_levels[i].falseLength) return;
        const std::uint32_t tag = m_levels[i].kind == LevelKind::item ? itemEndTag : sequenceEndTag;
        for (const int shift : m_bigEndian ? std::array{24, 16, 8, 0} : std::array{16, 24, 0, 8})
            delimiters += static_cast<char>(tag >> shift & 0xff);
        delimiters.append(4, '\0');
    }
    if (delimiters.empty()) return;
    m_scan.pixelsEnd = m_scan.pixelsEnd ||
                       std::any_of(m_levels.begin(), m_levels.end(), [](const Level& level) { return level.pixels; });
    m_scan.repairs.push_back({m_file.size(), delimiters});
    m_scan.notes.emplace_back("The file ends without the delimiter that closes its last sequence.");
}

/// A value of unknown kind is a sequence where it begins with an item.
bool Walk::enterIfItem(std::uint32_t length) {
    if (length < 8) return m_stream.skip(length) == length;
    const auto tag = readTag();
    if (!tag) return false;
    if (*tag != itemTag) return m_stream.skip(length - 4) == length - 4;
    m_pendingTag = tag;
    push(LevelKind::sequence, length, true);
    return true;
}

}  // namespace

bool looksLikeDicom(std::string_view beginning) {
    if (beginning.size() >= 132 && beginning.substr(128, 4) == "DICM") return true;
    // A file without preamble begins with an element of the meta header (0002,xxxx) or the data set (0008,xxxx).
    if (beginning.size() < 16) return false;
    const auto byte = [&](std::size_t index) { return static_cast<unsigned char>(beginning[index]); };
    const bool little = (byte(0) == 0x02 || byte(0) == 0x08) && byte(1) == 0x00;
    const bool big = byte(0) == 0x00 && byte(1) == 0x08;
    if (!little && !big) return false;
    if (isVrLetter(beginning[4]) && isVrLetter(beginning[5])) return true;
    // Without value representations, a short first value in a low element gives it away.
    return little && byte(3) <= 0x01 && byte(5) == 0 && byte(6) == 0 && byte(7) == 0 && byte(4) > 0 && byte(4) % 2 == 0;
}

Result<DicomScan> scanDicom(const InputFile& file, const Progress& progress, bool headerOnly) {
    const std::string& path = file.path();
    DicomScan scan;
    scan.fileSize = file.size();
    if (!Walk(file, scan).run(progress, headerOnly))
        return fail(
            FailureKind::unreadable, path, "",
            fmt::format("holds sequences nested more than {} deep, which no true DICOM object does", deepestSequence),
            "The file is damaged or made to do harm: do not open it.");
    if (progress.cancelled()) return fail(FailureKind::cancelled, path, "", "was not read: cancelled");
    return scan;
}

}  // namespace echolucent
