// What a series calls itself, for lists that name no patient.
#pragma once

#include <string>

class DcmItem;

namespace echolucent {

/// The Series Description, in UTF-8 or as stored; empty where it may name the patient: where it holds a word of the
/// patient's name, whatever the case, or the patient's identifier. Names that hold letters outside ASCII cannot be
/// compared (their case and their character set may differ), so that nothing is shown beside them; nor is it where any
/// of the three texts is longer than 1024 bytes.
[[nodiscard]] std::string seriesDescription(DcmItem& dataset);

}  // namespace echolucent
