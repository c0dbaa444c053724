#include "dicom_bytes.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "temporary_folder.h"

namespace echolucent {

namespace {

template <typename T>
std::string littleEndian(T value) {
    return bytesFrom<T>({value});
}

bool hasLongLength(const std::string& vr) {
    static constexpr std::array<std::string_view, 7> those{"OB", "OF", "OV", "OW", "SQ", "UN", "UT"};
    return std::ranges::find(those, vr) != those.end();
}

std::string padded(std::string value, char pad) {
    if (value.size() % 2 == 1) value += pad;
    return value;
}

}  // namespace

DicomBytes twoFrames() {
    DicomBytes file;
    file.text(0x0018, 0x0088, "DS", "1").picture(4, 2, 2).text(0x0028, 0x0030, "DS", "1\\1");
    return file.put(0x7fe0, 0x0010, "OW", std::string(16, 'a'));
}

std::string dicomDirectory(const std::vector<std::string>& names) {
    std::vector<DicomBytes> records;
    for (const std::string& name : names) {
        DicomBytes record;
        record.put(0x0004, 0x1400, "UL", bytesFrom<std::uint32_t>({400}));
        record.word(0x0004, 0x1410, 0xffff).put(0x0004, 0x1420, "UL", bytesFrom<std::uint32_t>({400}));
        record.text(0x0004, 0x1430, "CS", "IMAGE").text(0x0004, 0x1500, "CS", name);
        records.push_back(record);
    }
    return DicomBytes().sequence(0x0004, 0x1220, records).file("1.2.840.10008.1.3.10");
}

std::string dicomItem(const std::string& bytes) {
    return std::string("\xfe\xff\x00\xe0", 4) + littleEndian(static_cast<std::uint32_t>(bytes.size())) + bytes;
}

DicomBytes& DicomBytes::put(std::uint16_t group, std::uint16_t element, const std::string& vr, std::string value,
                            std::int64_t length) {
    const auto declared = static_cast<std::uint32_t>(length < 0 ? static_cast<std::int64_t>(value.size()) : length);
    m_bytes += littleEndian(group) + littleEndian(element) + vr;
    m_bytes += hasLongLength(vr) ? std::string(2, '\0') + littleEndian(declared)
                                 : littleEndian(static_cast<std::uint16_t>(declared));
    m_bytes += value;
    return *this;
}

DicomBytes& DicomBytes::text(std::uint16_t group, std::uint16_t element, const std::string& vr, std::string value) {
    return put(group, element, vr, padded(std::move(value), vr == "UI" ? '\0' : ' '));
}

DicomBytes& DicomBytes::word(std::uint16_t group, std::uint16_t element, std::uint16_t value) {
    return put(group, element, "US", littleEndian(value));
}

DicomBytes& DicomBytes::real(std::uint16_t group, std::uint16_t element, double value) {
    return put(group, element, "FD", littleEndian(value));
}

DicomBytes& DicomBytes::sequence(std::uint16_t group, std::uint16_t element, const std::vector<DicomBytes>& items,
                                 std::int64_t length) {
    std::string value;
    for (const DicomBytes& item : items) value += dicomItem(item.bytes());
    return put(group, element, "SQ", value, length);
}

DicomBytes& DicomBytes::fragments(const std::string& offsetTable, const std::vector<std::string>& fragments,
                                  bool closed) {
    std::string value = dicomItem(offsetTable);
    for (const std::string& fragment : fragments) value += dicomItem(fragment);
    if (closed) value += std::string("\xfe\xff\xdd\xe0\0\0\0\0", 8);
    return put(0x7fe0, 0x0010, "OB", value, 0xffffffff);
}

DicomBytes& DicomBytes::picture(std::uint16_t columns, std::uint16_t rows, int frames, std::uint16_t bits) {
    word(0x0028, 0x0002, 1).text(0x0028, 0x0004, "CS", "MONOCHROME2");
    if (frames > 0) text(0x0028, 0x0008, "IS", std::to_string(frames));
    return word(0x0028, 0x0010, rows)
        .word(0x0028, 0x0011, columns)
        .word(0x0028, 0x0100, bits)
        .word(0x0028, 0x0101, bits)
        .word(0x0028, 0x0102, static_cast<std::uint16_t>(bits - 1))
        .word(0x0028, 0x0103, 0);
}

std::string DicomBytes::file(const std::string& sopClass, const std::string& transferSyntax) const {
    DicomBytes meta;
    if (!sopClass.empty()) meta.text(0x0002, 0x0002, "UI", sopClass);
    meta.text(0x0002, 0x0010, "UI", transferSyntax);
    DicomBytes length;
    length.put(0x0002, 0x0000, "UL", littleEndian(static_cast<std::uint32_t>(meta.bytes().size())));
    return std::string(128, '\0') + "DICM" + length.bytes() + meta.bytes() + m_bytes;
}

}  // namespace echolucent
