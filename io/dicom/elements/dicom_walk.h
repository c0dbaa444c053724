// The walk of scanDicom() over a DICOM file's elements, and its state.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/dicom/elements/byte_stream.h"
#include "io/dicom/elements/dicom_scan_result.h"
#include "io/files/input_file.h"
#include "processing/progress.h"

namespace echolucent {

/// (7fe0,0010) Pixel Data: group and element in one number.
inline constexpr std::uint32_t pixelDataTag = 0x7fe00010U;
/// The group in which GE keeps volumes.
inline constexpr std::uint32_t kretzGroup = 0x7fe1;

/// Walks over one file, element by element. `file`, `scan` and `progress` must outlive the walk.
class DicomWalk {
public:
    DicomWalk(const InputFile& file, DicomScan& scan, const Progress& progress)
        : m_file(file), m_stream(file, progress), m_scan(scan), m_progress(progress) {}

    /// Walks as far as scanDicom() says. Ends early if the person cancels or the walk finds harm.
    void run(bool headerOnly);
    /// Why the file must not be read any further; no value if the walk found no harm.
    struct Harm {
        std::string element, problem, remedy;  ///< as in Failure
    };
    [[nodiscard]] std::optional<Harm> harm() const;

private:
    static constexpr std::uint64_t endless = std::numeric_limits<std::uint64_t>::max();
    static constexpr std::uint32_t undefinedLength = 0xffffffffU;
    static constexpr std::uint32_t itemEndTag = 0xfffee00dU;
    static constexpr std::uint32_t sequenceEndTag = 0xfffee0ddU;
    enum class LevelKind { dataset, sequence, item, fragments };
    /// An element that describes the picture or its place.
    struct Described {
        std::uint32_t tag = 0;
        std::string value;  // empty if not kept
        bool isKept = false;
    };
    struct Level {
        LevelKind kind = LevelKind::dataset;
        std::uint64_t end = endless;
        bool implicitVr = false;
        bool bigEndian = false;
        std::size_t elements = 0;
        std::uint32_t lastTag = 0;      // the largest so far
        bool ascends = true;            // whether the last tag was larger than all before
        std::uint32_t previousTag = 0;  // of the element before
        std::vector<Described> described = {};
        bool pixels = false;                            // whether this level is the pixel data
        std::optional<std::uint64_t> falseLength = {};  // the place of a length that must be corrected
        std::uint64_t start = 0;
    };
    bool readMeta();
    bool readWriting(std::uint32_t tag);
    bool step();
    bool readElement(std::uint32_t tag);
    void countElement(std::uint32_t tag);
    bool describe(std::uint32_t tag, std::uint32_t length, bool plain, bool& passed);
    void measureEnd(bool enough);
    void measureWhatLacks();
    void refuseLongRecordType(std::uint32_t tag, std::uint32_t length);
    [[nodiscard]] bool isBigEndian() const { return m_levels.empty() ? m_bigEndian : m_levels.back().bigEndian; }
    bool readDelimiter(std::uint32_t tag);
    bool enterValue(std::uint32_t tag, std::string_view vr, std::uint32_t length);
    bool enterIfItem(std::uint32_t length);
    bool recover();
    bool leaveOutItem(std::uint32_t length);
    void repair(std::uint64_t offset, std::string bytes, const char* note);
    void repairLength(const Level& level, std::uint32_t length);
    bool readKretz(std::uint32_t tag, std::string_view vr, std::uint32_t length);
    bool closeAtEnd();
    void writeLength();
    void push(LevelKind kind, std::uint32_t length, bool implicitVr);
    void pop();
    void notePixelData(std::string_view vr, std::uint32_t length, bool fragments);
    void noteFragment(std::uint32_t length);
    void sayDecimals(std::uint32_t tag, std::string_view value);

    std::optional<std::uint32_t> readTag();
    std::optional<std::uint32_t> read32();
    std::optional<std::uint32_t> read16();

    const InputFile& m_file;
    ByteStream m_stream;
    DicomScan& m_scan;
    const Progress& m_progress;
    std::vector<Level> m_levels;
    int m_sequences = 0;
    bool m_bigEndian = false;  // of the data set
    bool m_lost = false;       // whether the walk met bytes that are no element
    std::size_t m_elements = 0;
    std::uint64_t m_disorder = 0;  // how many elements DCMTK passes to sort in those out of order
    std::optional<Harm> m_harm;
    std::optional<std::uint32_t> m_pendingTag;   // a tag that was read ahead
    std::uint64_t m_emptySequenceEnd = endless;  // the end of the last sequence that is declared empty
    bool m_behindKretz = false;                  // whether the walk is behind the group of GE's volumes
    std::uint32_t m_kretzBlock = 0;              // the first block of elements that GE's creator reserves; 0: none
    std::uint64_t m_stepStart = 0;               // where the last step began
    std::uint64_t m_topStart = 0;                // where the last step at top level began
    std::uint64_t m_pixelsElement = 0;           // where the element of Pixel Data begins
    std::string m_statedSyntax;                  // UID in the meta header
    std::size_t m_fragments = 0;                 // of Pixel Data so far, with the offset table
    bool m_codingSought = false;                 // whether a fragment was asked for its coding
    bool m_commaSaid = false;                    // whether the notes tell of a decimal comma
    std::vector<std::uint32_t> m_noNumbers;      // elements whose values the notes call no numbers
    std::uint32_t m_lastTag = 0;                 // of the element last entered
    std::uint32_t m_lastLength = 0;              // as that element declares
    std::uint64_t m_lastStart = 0;               // where its value begins
    bool m_lastIsPixels = false;
};

}  // namespace echolucent
