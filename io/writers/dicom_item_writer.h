// Puts attributes into a new DICOM data set. DCMTK's types are only declared here, not included.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

class DcmItem;
class DcmTagKey;

namespace echolucent {

/// A new unique identifier.
[[nodiscard]] std::string newDicomUid();

/// A number as DICOM's decimal string: as many digits as fit into 16 characters.
[[nodiscard]] std::string decimalString(double number);

/// One data set or item of a sequence, which must outlive this object. Each function throws std::logic_error if the
/// attribute cannot hold such values.
class DicomItemWriter {
public:
    explicit DicomItemWriter(DcmItem& item) : m_item(&item) {}

    void text(const DcmTagKey& attribute, const std::string& value);  ///< several values are separated by backslashes
    void decimals(const DcmTagKey& attribute, const std::vector<double>& values);
    void doubles(const DcmTagKey& attribute, const std::vector<double>& values);
    void word(const DcmTagKey& attribute, std::uint16_t value);
    void longWords(const DcmTagKey& attribute, const std::vector<std::uint32_t>& values);
    void tag(const DcmTagKey& attribute, const DcmTagKey& value);
    void pixels(const std::vector<std::uint8_t>& values);
    void pixels(const std::vector<std::uint16_t>& values);
    void emptySequence(const DcmTagKey& sequence);
    /// A new item at the end of a sequence. A missing sequence is made.
    [[nodiscard]] DicomItemWriter newItem(const DcmTagKey& sequence);

private:
    DcmItem* m_item;
};

}  // namespace echolucent
