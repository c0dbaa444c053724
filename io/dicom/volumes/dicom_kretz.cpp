#include "io/dicom/volumes/dicom_kretz.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcfcache.h>
#include <dcmtk/dcmdata/dctk.h>

#include <array>
#include <memory>

#include <fmt/format.h>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/files/input_problems.h"
#include "io/kretz/kretz_reader.h"

namespace echolucent {

namespace {

constexpr std::uint16_t privateGroup = 0x7FE1;

/// The element xx01 of the block that KRETZ_US reserves; null if there is none.
DcmElement* volumeElement(DcmDataset& dataset, DicomTag& tag) {
    for (std::uint16_t block = 0x10; block <= 0xFF; ++block) {
        if (dicomText(dataset, {privateGroup, block}) != "KRETZ_US") continue;
        tag = {privateGroup, static_cast<std::uint16_t>(block << 8 | 0x01)};
        DcmElement* element = nullptr;
        if (dataset.findAndGetElement(DcmTagKey(tag.group, tag.element), element).good()) return element;
    }
    return nullptr;
}

/// Whether a volume may be kept in the value representation of an element.
bool mayHoldVolume(DcmElement& element) {
    const DcmEVR vr = element.ident();
    // Without value representations, DCMTK knows none for private elements.
    return vr == EVR_OB || vr == EVR_OW || vr == EVR_UN || vr == EVR_UNKNOWN || vr == EVR_ox;
}

}  // namespace

std::optional<KretzSource> kretzVolumeIn(const DicomFile& file) {
    DicomTag tag;
    DcmElement* const element = volumeElement(file.dataset(), tag);
    if (element == nullptr || !mayHoldVolume(*element)) return std::nullopt;
    KretzSource source;
    source.path = file.path();
    source.element = tagText(tag);
    source.size = element->getLength();
    // DCMTK would give zeros for missing bytes of the value.
    if (const std::uint64_t held = file.scan().kretzBytesHeld; file.scan().holdsKretz && held < source.size) {
        source.read = [=, path = source.path, name = source.element, size = source.size](
                          std::uint64_t, std::span<std::uint8_t>) -> Result<void> {
            return fail(FailureKind::unreadable, path, name,
                        fmt::format("declares a volume of {} bytes where the file holds only {}", size, held),
                        incompleteFile);
        };
        return source;
    }
    // The cache keeps the file open between the many small reads.
    source.read = [element, path = source.path, name = source.element, cache = std::make_shared<DcmFileCache>()](
                      std::uint64_t offset, std::span<std::uint8_t> bytes) -> Result<void> {
        const OFCondition read =
            element->getPartialValue(bytes.data(), static_cast<Uint32>(offset), static_cast<Uint32>(bytes.size()),
                                     cache.get(), EBO_LittleEndian);
        if (read.good()) return {};
        return fail(FailureKind::unreadable, path, name, "could not be read to its end", copyAgain);
    };
    std::array<std::uint8_t, kretzSignature.size()> beginning{};
    if (source.size < beginning.size() || !source.read(0, beginning)) return std::nullopt;
    if (!looksLikeKretz({reinterpret_cast<const char*>(beginning.data()), beginning.size()})) return std::nullopt;
    return source;
}

}  // namespace echolucent
