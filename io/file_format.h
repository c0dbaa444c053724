// Which format the first bytes of a file tell.
#pragma once

#include <string_view>

namespace echolucent {

enum class FileFormat { metaImage, nrrd, nifti, dicom, kretz, unknown };

/// The format that a file's first 4096 bytes, or all of them where it is shorter, give away.
[[nodiscard]] FileFormat formatFromContent(std::string_view beginning);

}  // namespace echolucent
