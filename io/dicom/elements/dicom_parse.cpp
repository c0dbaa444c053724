#include "io/dicom/elements/dicom_parse.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcistrma.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "io/files/raw_inflater.h"

namespace echolucent {

namespace {

/// The most stack that parsing may take: far more than 64 levels of nesting need, also with the larger frames of the
/// address sanitizer.
constexpr std::uintptr_t mostStackBytes = std::uintptr_t{4} << 20;
/// DCMTK reads an element in three to seven pieces.
constexpr std::uint64_t mostReads = 10 * mostElements;

class RepairedBytes {
public:
    /// Ends at `usedBytes`, if it has a value.
    RepairedBytes(InputFile file, std::vector<DicomRepair> repairs, std::optional<std::uint64_t> usedBytes)
        : m_file(std::move(file)), m_size(std::min(usedBytes.value_or(m_file.size()), m_file.size())) {
        std::ranges::sort(repairs, {}, &DicomRepair::offset);
        if (usedBytes)
            std::erase_if(repairs, [&](const DicomRepair& one) { return one.offset + one.bytes.size() > *usedBytes; });
        for (const DicomRepair& repair : repairs)
            m_size = std::max<std::uint64_t>(m_size, repair.offset + repair.bytes.size());
        m_repairs = std::make_shared<const std::vector<DicomRepair>>(std::move(repairs));
    }
    [[nodiscard]] std::uint64_t size() const { return m_size; }
    [[nodiscard]] const InputFile& file() const { return m_file; }
    /// Fills `bytes` from `position` on. The range must lie within size().
    [[nodiscard]] bool read(std::uint64_t position, std::span<std::uint8_t> bytes) const {
        const std::uint64_t held = m_file.size() - std::min(position, m_file.size());
        const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), held));
        if (!m_file.readAt(position, bytes.first(count))) return false;
        const std::uint64_t end = position + bytes.size();
        // Repairs do not overlap, so their ends are in order too.
        auto repair = std::ranges::lower_bound(*m_repairs, position + 1, {},
                                               [](const DicomRepair& one) { return one.offset + one.bytes.size(); });
        for (; repair != m_repairs->end() && repair->offset < end; ++repair)
            for (std::uint64_t at = std::max(position, repair->offset);
                 at < std::min<std::uint64_t>(end, repair->offset + repair->bytes.size()); ++at)
                bytes[static_cast<std::size_t>(at - position)] =
                    static_cast<std::uint8_t>(repair->bytes[static_cast<std::size_t>(at - repair->offset)]);
        return true;
    }

private:
    InputFile m_file;
    // Copies share it: DCMTK makes a copy for each long value.
    std::shared_ptr<const std::vector<DicomRepair>> m_repairs;
    std::uint64_t m_size;
};

/// The state that all reads of one parse share.
struct ParseBounds {
    std::uintptr_t stackStart = 0;  ///< the stack's address when parsing began
    std::uint64_t reads = 0;
    bool tooDeep = false;
    bool tooMuch = false;

    [[nodiscard]] bool broken() const { return tooDeep || tooMuch; }
    /// Counts one read, and measures how deep DCMTK has recursed.
    void count() {
        const std::uintptr_t here = stackHere();
        tooDeep = tooDeep || (here < stackStart ? stackStart - here : here - stackStart) > mostStackBytes;
        tooMuch = tooMuch || ++reads > mostReads;
    }
    /// The address of this call's stack frame. The address of a local would not do: the address sanitizer may put
    /// locals elsewhere.
    static std::uintptr_t stackHere() { return reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0)); }
};

/// Hands DCMTK the bytes of a file, inflated behind inflateFromHere(), until the person cancels or a bound is broken.
class FileProducer : public DcmProducer {
public:
    FileProducer(RepairedBytes file, std::uint64_t position, const Progress* progress, ParseBounds* bounds)
        : m_file(std::move(file)),
          m_position(std::min(position, m_file.size())),
          m_size(m_file.size()),
          m_progress(progress),
          m_bounds(bounds) {}
    /// Takes the rest as a raw deflate stream that unpacks to `size` bytes.
    void inflateFromHere(std::uint64_t size) {
        m_inflater = std::make_unique<RawInflater>(m_file.file(), m_position);
        m_block.clear();
        m_blockStart = m_position;
        m_size = m_position + size;
    }
    [[nodiscard]] bool inflates() const { return m_inflater != nullptr; }
    [[nodiscard]] OFBool good() const override { return status().good(); }
    [[nodiscard]] OFCondition status() const override {
        const bool cancelled = m_progress != nullptr && m_progress->cancelled();
        const bool broken = m_bounds != nullptr && m_bounds->broken();
        return m_failed || cancelled || broken ? EC_InvalidStream : EC_Normal;
    }
    OFBool eos() override { return m_position >= m_size; }
    offile_off_t avail() override { return static_cast<offile_off_t>(m_size - m_position); }
    offile_off_t read(void* bytes, offile_off_t count) override {
        if (m_bounds != nullptr) m_bounds->count();
        if (status().bad()) return 0;
        const std::span whole(static_cast<std::uint8_t*>(bytes), static_cast<std::size_t>(within(count)));
        std::span rest = whole;
        while (!rest.empty()) {
            const std::size_t taken = take(rest);
            if (taken == 0) return 0;
            rest = rest.subspan(taken);
        }
        return static_cast<offile_off_t>(whole.size());
    }
    offile_off_t skip(offile_off_t count) override {
        const std::uint64_t skipped = within(count);
        if (!m_inflater) {
            m_position += skipped;
            return static_cast<offile_off_t>(skipped);
        }
        std::vector<std::uint8_t> passed(blockBytes);
        std::uint64_t done = 0;
        while (done < skipped) {
            const auto piece = static_cast<std::size_t>(std::min<std::uint64_t>(passed.size(), skipped - done));
            const std::size_t taken = take(std::span(passed).first(piece));
            if (taken == 0) break;
            done += taken;
        }
        return static_cast<offile_off_t>(done);
    }
    void putback(offile_off_t count) override {
        const std::uint64_t most = m_inflater ? m_position - m_blockStart : m_position;
        m_failed = m_failed || static_cast<std::uint64_t>(count) > most;
        m_position -= std::min(static_cast<std::uint64_t>(count), most);
    }

private:
    [[nodiscard]] std::uint64_t within(offile_off_t count) const {
        return count < 0 ? 0 : std::min(static_cast<std::uint64_t>(count), m_size - m_position);
    }
    /// Copies the next bytes into the front of `bytes`. Returns how many, 0 if they cannot be read. Keeps a block,
    /// because DCMTK asks for headers in pieces of two bytes.
    std::size_t take(std::span<std::uint8_t> bytes) {
        const bool kept = m_position >= m_blockStart && m_position < m_blockStart + m_block.size();
        if (!kept && m_inflater) {
            inflateBlock();
            if (m_failed) return 0;
        } else if (!kept && bytes.size() >= blockBytes) {
            m_failed = !m_file.read(m_position, bytes);
            m_position += m_failed ? 0 : bytes.size();
            return m_failed ? 0 : bytes.size();
        } else if (!kept) {
            m_block.resize(static_cast<std::size_t>(std::min<std::uint64_t>(blockBytes, m_size - m_position)));
            m_blockStart = m_position;
            m_failed = !m_file.read(m_position, m_block);
            if (m_failed) return 0;
        }
        const auto from = static_cast<std::size_t>(m_position - m_blockStart);
        const std::size_t count = std::min(bytes.size(), m_block.size() - from);
        std::copy_n(m_block.begin() + static_cast<std::ptrdiff_t>(from), count, bytes.begin());
        m_position += count;
        return count;
    }
    /// Inflates the next block. Keeps the last bytes of the block before, because DCMTK may put them back.
    void inflateBlock() {
        const std::size_t tail = std::min(m_block.size(), putBackBytes);
        m_blockStart += m_block.size() - tail;
        m_block.erase(m_block.begin(), m_block.end() - static_cast<std::ptrdiff_t>(tail));
        m_block.resize(tail + inflatedBytes);
        const std::size_t count = m_inflater->read(std::span(m_block).subspan(tail));
        m_block.resize(tail + count);
        m_failed = m_failed || count == 0;
    }

    static constexpr std::size_t blockBytes = 8192;
    static constexpr std::size_t inflatedBytes = 65536;
    static constexpr std::size_t putBackBytes = 64;
    RepairedBytes m_file;
    std::uint64_t m_position;
    std::uint64_t m_size;
    const Progress* m_progress;
    ParseBounds* m_bounds;
    std::unique_ptr<RawInflater> m_inflater;
    std::vector<std::uint8_t> m_block;
    std::uint64_t m_blockStart = 0;
    bool m_failed = false;
};

/// The stream for DCMTK. DCMTK's own file stream opens files by name and cannot be cancelled. DCMTK's own inflating
/// filter reads ahead, so that reads would not show how deep DCMTK recurses.
class FileStream : public DcmInputStream {
public:
    // The base class does not use the pointer before the first read, and by then `m_producer` is constructed.
    FileStream(const RepairedBytes& file, std::uint64_t position, std::uint64_t unpackedBytes, const Progress* progress,
               ParseBounds* bounds)
        : DcmInputStream(&m_producer),
          m_file(file),
          m_start(position),
          m_unpackedBytes(unpackedBytes),
          m_producer(file, position, progress, bounds) {}
    /// Lets DCMTK read long values later, but those of deflated data at once (null).
    [[nodiscard]] DcmInputStreamFactory* newFactory() const override;
    OFCondition installCompressionFilter(E_StreamCompression) override {
        m_producer.inflateFromHere(m_unpackedBytes);
        return EC_Normal;
    }

private:
    RepairedBytes m_file;
    std::uint64_t m_start;
    std::uint64_t m_unpackedBytes;
    FileProducer m_producer;
};

/// Makes streams that begin at a long value.
class FileStreamFactory : public DcmInputStreamFactory {
public:
    FileStreamFactory(RepairedBytes file, std::uint64_t position) : m_file(std::move(file)), m_position(position) {}
    [[nodiscard]] DcmInputStream* create() const override {
        return new FileStream(m_file, m_position, 0, nullptr, nullptr);
    }
    [[nodiscard]] DcmInputStreamFactory* clone() const override { return new FileStreamFactory(*this); }
    [[nodiscard]] DcmInputStreamFactoryType ident() const override { return DFT_DcmInputFileStreamFactory; }

private:
    RepairedBytes m_file;
    std::uint64_t m_position;
};

DcmInputStreamFactory* FileStream::newFactory() const {
    if (m_producer.inflates()) return nullptr;
    return new FileStreamFactory(m_file, m_start + static_cast<std::uint64_t>(tell()));
}

/// Removes the last elements if they were not read to their end: they hold memory that was never filled.
void removeCutElement(DcmDataset& dataset) {
    for (unsigned long last = dataset.card(); last > 0; --last) {
        DcmElement* element = dataset.getElement(last - 1);
        if (element == nullptr || element->transferState() == ERW_ready) return;
        delete dataset.remove(element);
    }
}

OFCondition parse(DcmDataset& dataset, DcmInputStream& stream, E_TransferSyntax syntax, const DcmTagKey& end) {
    dataset.transferInit();
    OFCondition done;
    try {
        done = dataset.readUntilTag(stream, syntax, EGL_noChange, DCM_MaxReadLength, end);
    } catch (const std::out_of_range&) {
        done = EC_CorruptedData;  // DCMTK 3.6.7 stumbles over damaged names of directory records
    }
    // transferEnd() clears the states by which removeCutElement() tells which elements were read.
    if (end == DCM_PixelData && done.bad()) removeCutElement(dataset);
    dataset.transferEnd();
    return done;
}

/// Makes fragments that were read among elements of implicit VR or big endian known as of their own coding.
void nameCoding(DcmDataset& dataset, E_TransferSyntax read, E_TransferSyntax coding) {
    DcmElement* element = nullptr;
    DcmPixelSequence* fragments = nullptr;
    if (dataset.findAndGetElement(DCM_PixelData, element).bad() || element->ident() != EVR_PixelData) return;
    if (static_cast<DcmPixelData*>(element)->getEncapsulatedRepresentation(read, nullptr, fragments).bad()) return;
    auto pixels = std::make_unique<DcmPixelData>(DCM_PixelData);
    pixels->putOriginalRepresentation(coding, nullptr, new DcmPixelSequence(*fragments));
    if (dataset.insert(pixels.get(), OFTrue).good()) (void)pixels.release();
    dataset.updateOriginalXfer();
}

}  // namespace

DicomParsed parseDicom(DcmDataset& dataset, const InputFile& input, const DicomScan& scan, bool withPixels,
                       const Progress& progress) {
    ParseBounds bounds;
    bounds.stackStart = ParseBounds::stackHere();
    FileStream stream(RepairedBytes(input, scan.repairs, scan.usedBytes), scan.datasetStart, scan.unpackedBytes,
                      &progress, &bounds);
    const E_TransferSyntax syntax =
        scan.elementSyntax.empty() ? EXS_Unknown : DcmXfer(scan.elementSyntax.c_str()).getXfer();
    const OFCondition done = parse(dataset, stream, syntax, withPixels ? DCM_UndefinedTagKey : DCM_PixelData);
    DicomParsed parsed{DicomParseEnd::whole, scan.datasetStart + static_cast<std::uint64_t>(stream.tell())};
    if (done.good() && withPixels && scan.pixelsInFragments && scan.elementSyntax != scan.transferSyntax)
        nameCoding(dataset, dataset.getOriginalXfer(), DcmXfer(scan.transferSyntax.c_str()).getXfer());
    if (bounds.tooDeep)
        parsed.end = DicomParseEnd::tooDeep;
    else if (bounds.tooMuch)
        parsed.end = DicomParseEnd::tooMuch;
    else if (done.bad())
        parsed.end = stream.eos() || done == EC_StreamNotifyClient || done == EC_EndOfStream ? DicomParseEnd::cut
                                                                                             : DicomParseEnd::damaged;
    return parsed;
}

}  // namespace echolucent
