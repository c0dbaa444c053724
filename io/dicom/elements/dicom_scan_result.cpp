#include "io/dicom/elements/dicom_scan_result.h"

#include <fmt/format.h>

namespace echolucent {

std::string nestedTooDeep() {
    return fmt::format("holds sequences nested more than {} deep, which no true DICOM object does", deepestSequence);
}

std::string tooManyElements() {
    return fmt::format("holds more than {} elements, which no true DICOM object does", mostElements);
}

}  // namespace echolucent
