#include "io/file_format.h"

#include "io/dicom/dicom_scan.h"
#include "io/headers/meta_image.h"
#include "io/headers/nrrd.h"
#include "io/kretz/kretz_reader.h"
#include "io/nifti/nifti_header.h"

namespace echolucent {

FileFormat formatFromContent(std::string_view beginning) {
    if (looksLikeNrrd(beginning)) return FileFormat::nrrd;
    if (looksLikeKretz(beginning)) return FileFormat::kretz;
    if (looksLikeNifti(beginning)) return FileFormat::nifti;
    if (looksLikeDicom(beginning)) return FileFormat::dicom;
    if (looksLikeMetaImage(beginning)) return FileFormat::metaImage;
    return FileFormat::unknown;
}

}  // namespace echolucent
