// What a reader hands over: the volumes of a study and the story of how they were read.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "processing/progress.h"
#include "processing/result.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// One line of the import report: a fact, its value and where it came from.
struct ImportFact {
    std::string name;    ///< "spacing", "white level", "lossy compression"
    std::string value;   ///< "0.30 x 0.30 x 0.30 mm"
    std::string source;  ///< "ElementSpacing", "(0018,0088)", "assumed"
};

/// A study: one volume, or the phases of a 4D one. Never empty once read. No patient name or identifier in it.
struct Study {
    std::string name;  ///< name of the file or folder, for the window's title
    /// Every file the study was read from (header, voxels, layout kept beside a raw file, all DICOM files of a folder),
    /// as paths that can be opened; empty where it was not read from files. No output may be one of them
    /// (refuseToOverwrite()).
    std::vector<std::string> files;
    std::vector<std::shared_ptr<const Volume>> phases;
    std::optional<double> phaseSeconds;  ///< seconds between phases, above 0; no value where they are unknown
    bool lossyCompressed = false;
    std::vector<ImportFact> facts;
    std::vector<std::string> warnings;  ///< sentences for the person: assumptions, conversions, unknown spacing
};

/// How a headerless raw file is laid out. Once a person has said it, it is kept beside the file as
/// FILE.echolucent.json.
struct RawLayout {
    std::array<std::int64_t, 3> size{0, 0, 0};  ///< voxels along x (fastest), y and z
    std::string type = "uint8";                 ///< uint8, int8, uint16, int16, uint32, int32, float32, float64
    bool bigEndian = false;
    std::int64_t headerBytes = 0;  ///< bytes before the first voxel
    Vec3 spacing{1, 1, 1};         ///< mm
    bool spacingKnown = false;     ///< false where `spacing` is only assumed
};

/// Writes FILE.echolucent.json beside a headerless raw file, so that readStudy() opens it without a layout next
/// time. Fails (unwritable) where the folder cannot be written into.
[[nodiscard]] Result<void> rememberRawLayout(const std::string& path, const RawLayout& layout);
/// The layout kept beside the raw file at `path`; no value where there is none. Fails (unreadable) where
/// FILE.echolucent.json is there but does not describe a layout.
[[nodiscard]] Result<std::optional<RawLayout>> recalledRawLayout(const std::string& path);

/// What a person may say about how a file is to be read.
struct ReadOptions {
    std::optional<RawLayout> raw;  ///< for files that are neither MetaImage, NRRD nor DICOM
    bool framesAsSlices = false;   ///< take the frames of a multi-frame file without volume geometry as slices
    bool guessNoData = true;       ///< mark the outside of the scanned sector as no data (guessDataMask)
};

/// Reads a volume from the file or DICOM folder at `path`. The format is told by the content, then by the name. Every
/// size is checked against the file before memory is taken. `progress` is polled for cancel every few MB, between files
/// and between the elements of a DICOM file. Fails (unreadable) where there is no volume to be read, (cancelled) where
/// the person ended it.
[[nodiscard]] Result<Study> readStudy(const std::string& path, const ReadOptions& options = {},
                                      const Progress& progress = {});

}  // namespace echolucent
