// Small good files of every format and coding that is read: what random changes are made to.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "processing/document/read_options.h"

namespace echolucent {

/// How what is read of a file's voxels can be told from the file, without a reader of this program.
enum class VoxelCoding {
    plain,        ///< they stand in the file as bytes
    checked,      ///< compressed with a checksum: what is read of them has to be what was written
    hexadecimal,  ///< as two digits a byte
    decimal,      ///< as numbers in text
    deflated,     ///< the DICOM data set is deflated as a whole, without a checksum
    coded,        ///< in a picture codec without a checksum: as written where the codestreams are untouched
    converted,    ///< samples along beams, which are interpolated: never as bytes
};

struct GoodFile {
    std::string name;                                        ///< format and coding: "nrrd-gzip"
    std::string opened;                                      ///< the file that is opened; "." is the folder
    std::vector<std::pair<std::string, std::string>> files;  ///< name and bytes of each, the header first
    VoxelCoding coding = VoxelCoding::plain;
    /// The bytes of all phases as they were written; empty where the coding loses some of them.
    std::string voxels;
    ReadOptions options{};
};

/// One of each. The same bytes on every machine.
[[nodiscard]] std::vector<GoodFile> goodFiles();

}  // namespace echolucent
