// The name of a series, for lists that must not name the patient.
#pragma once

#include <string>

class DcmItem;

namespace echolucent {

/// The Series Description, in UTF-8 or as stored. It is empty if it may name the patient: if it holds a word of the
/// patient's name, in any case, or the patient's identifier. Names and identifiers outside ASCII cannot be compared, as
/// their case and character set may differ, so it is empty beside them. It is also empty if one of the three texts is
/// longer than 1024 bytes.
[[nodiscard]] std::string seriesDescription(DcmItem& dataset);

}  // namespace echolucent
