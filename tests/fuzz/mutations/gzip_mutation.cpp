#include "tests/fuzz/mutations/gzip_mutation.h"

#include <algorithm>
#include <utility>

#include "tests/fuzz/mutations/byte_mutation.h"
#include "tests/fuzz/mutations/dicom_mutation.h"
#include "tests/fuzz/mutations/kretz_mutation.h"
#include "tests/fuzz/mutations/nifti_mutation.h"
#include "tests/fuzz/mutations/text_header_mutation.h"
#include "tests/fuzz/mutations/zlib_parts.h"

namespace echolucent {

namespace {

std::string mutatedInside(std::string bytes, std::uint64_t seed) {
    if (bytes.starts_with("NRRD")) return mutatedNrrd(std::move(bytes), seed);
    if (bytes.starts_with("KRETZ")) return mutatedKretz(std::move(bytes), seed);
    if (bytes.find("NDims") < 512) return mutatedMetaImage(std::move(bytes), seed);
    if (bytes.find("DICM") == 128) return mutatedDicom(std::move(bytes), seed);
    return mutatedNifti(std::move(bytes), seed);
}

}  // namespace

std::string mutatedGzip(std::string bytes, std::uint64_t seed) {
    Dice dice(seed);
    switch (dice.below(8)) {
        case 0: return mutatedBytes(std::move(bytes), seed);
        case 1: return bytes + bytes;
        case 2: return packed(packed(unpacked(bytes, gzipWindow), gzipWindow), gzipWindow);
        case 3: {  // Checksum and length at the end.
            std::string end = bytes.substr(bytes.size() - std::min<std::size_t>(8, bytes.size()));
            bytes.resize(bytes.size() - end.size());
            return bytes + withBytesChanged(std::move(end), dice);
        }
        default: return packed(mutatedInside(unpacked(bytes, gzipWindow), seed), gzipWindow);
    }
}

}  // namespace echolucent
