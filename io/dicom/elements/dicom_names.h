// DICOM's unique identifiers in words, for reports and refusals. DCMTK's names are rewritten so that they fit into
// sentences.
#pragma once

#include <string>
#include <string_view>

namespace echolucent {

constexpr std::string_view directorySopClass = "1.2.840.10008.1.3.10";  ///< of a DICOMDIR
constexpr std::string_view qlabSopClass = "1.2.840.113543.6.6.1.3.10002";

/// The words of a name that DCMTK writes without blanks: "SOP Class UID" of "SOPClassUID".
[[nodiscard]] std::string wordsOfName(std::string_view name);

/// A transfer syntax in words: "JPEG-LS Lossless". An empty or unknown UID becomes "a coding that is not known here".
[[nodiscard]] std::string transferSyntaxName(std::string_view uid);

/// An object of a SOP class in words, with its article: "an ultrasound image", "an encapsulated PDF document". An
/// unknown UID becomes "an object of a kind that is not known here", an empty one "an object that does not say of what
/// kind it is". A maker's own UID becomes "a private object of Philips".
[[nodiscard]] std::string objectName(std::string_view sopClassUid);

/// Whether objects of a SOP class hold a picture, so that one without Pixel Data is incomplete. True also for an empty
/// UID and for unknown classes, whose objects may hold one. False for the private classes of makers.
[[nodiscard]] bool holdsPicture(std::string_view sopClassUid);

}  // namespace echolucent
