#include "io/writers/dicom_item_writer.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include <array>
#include <memory>
#include <stdexcept>

namespace echolucent {

namespace {

void requireTaken(const OFCondition& done, const DcmTagKey& attribute) {
    if (done.bad())
        throw std::logic_error(fmt::format("DicomItemWriter: ({:04x},{:04x}): {}", attribute.getGroup(),
                                           attribute.getElement(), done.text()));
}

}  // namespace

std::string newDicomUid() {
    std::array<char, 100> uid{};
    return dcmGenerateUniqueIdentifier(uid.data());
}

std::string decimalString(double number) {
    constexpr std::size_t longest = 16;
    for (int digits = 17; digits > 1; --digits)
        if (std::string text = fmt::format("{:.{}g}", number, digits); text.size() <= longest) return text;
    return fmt::format("{:.1g}", number);
}

void DicomItemWriter::text(const DcmTagKey& attribute, const std::string& value) {
    requireTaken(m_item->putAndInsertString(attribute, value.c_str()), attribute);
}

void DicomItemWriter::decimals(const DcmTagKey& attribute, const std::vector<double>& values) {
    std::string joined;
    for (const double value : values) joined += (joined.empty() ? "" : "\\") + decimalString(value);
    text(attribute, joined);
}

void DicomItemWriter::doubles(const DcmTagKey& attribute, const std::vector<double>& values) {
    requireTaken(m_item->putAndInsertFloat64Array(attribute, values.data(), values.size()), attribute);
}

void DicomItemWriter::word(const DcmTagKey& attribute, std::uint16_t value) {
    requireTaken(m_item->putAndInsertUint16(attribute, value), attribute);
}

void DicomItemWriter::longWords(const DcmTagKey& attribute, const std::vector<std::uint32_t>& values) {
    auto element = std::make_unique<DcmUnsignedLong>(attribute);
    const std::vector<Uint32> longs(values.begin(), values.end());
    requireTaken(element->putUint32Array(longs.data(), static_cast<unsigned long>(longs.size())), attribute);
    requireTaken(m_item->insert(element.release(), OFTrue), attribute);
}

void DicomItemWriter::tag(const DcmTagKey& attribute, const DcmTagKey& value) {
    requireTaken(m_item->putAndInsertTagKey(attribute, value), attribute);
}

void DicomItemWriter::pixels(const std::vector<std::uint8_t>& values) {
    requireTaken(m_item->putAndInsertUint8Array(DCM_PixelData, values.data(), values.size()), DCM_PixelData);
}

void DicomItemWriter::pixels(const std::vector<std::uint16_t>& values) {
    requireTaken(m_item->putAndInsertUint16Array(DCM_PixelData, values.data(), values.size()), DCM_PixelData);
}

void DicomItemWriter::emptySequence(const DcmTagKey& sequence) {
    requireTaken(m_item->insertEmptyElement(sequence), sequence);
}

DicomItemWriter DicomItemWriter::newItem(const DcmTagKey& sequence) {
    DcmItem* item = nullptr;
    requireTaken(m_item->findOrCreateSequenceItem(sequence, item, -2), sequence);
    return DicomItemWriter(*item);
}

}  // namespace echolucent
