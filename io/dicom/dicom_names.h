// DICOM's unique identifiers in words a person knows, for reports and refusals.
#pragma once

#include <string>
#include <string_view>

namespace echolucent {

/// A transfer syntax in words: "JPEG-LS, lossless". An unknown UID becomes "a coding that is not known here".
[[nodiscard]] std::string transferSyntaxName(std::string_view uid);

/// What an object of a SOP class is, with its article: "an ultrasound image", "an encapsulated PDF document". An
/// unknown UID becomes "an object of a kind that is not known here", one of a maker's own "a private object of
/// Philips".
[[nodiscard]] std::string objectName(std::string_view sopClassUid);

}  // namespace echolucent
