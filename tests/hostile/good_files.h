// Small good files of every format and coding that is read. Random changes are made to them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "processing/document/read_options.h"

namespace echolucent {

/// How to know a file's voxels without a reader of this program.
enum class VoxelCoding {
    plain,        ///< they stand in the file as bytes
    checked,      ///< compressed with a checksum: what is read must be what was written
    hexadecimal,  ///< as two digits a byte
    decimal,      ///< as numbers in text
    deflated,     ///< the DICOM data set is deflated as a whole, without a checksum
    coded,        ///< in a picture codec without a checksum: as written if the codestreams are untouched
    converted,    ///< samples along beams, which are interpolated; never as bytes
};

struct GoodFile {
    std::string name;                                        ///< format and coding: "nrrd-gzip"
    std::string opened;                                      ///< the file to open; "." is the folder
    std::vector<std::pair<std::string, std::string>> files;  ///< name and bytes of each, the header first
    VoxelCoding coding = VoxelCoding::plain;
    /// The bytes of all phases as they were written; empty if the coding loses some of them.
    std::string voxels;
    ReadOptions options{};
};

/// One of each, with the same bytes on every machine.
[[nodiscard]] std::vector<GoodFile> goodFiles();

}  // namespace echolucent
