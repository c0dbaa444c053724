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
    std::string name;  ///< file or folder name, for the window's title
    /// Every file the study was read from (header, voxels, layout kept beside a raw file, all DICOM files of a folder),
    /// as paths that can be opened; empty where it was not read from files. No output may be one of them
    /// (refuseToOverwrite()).
    std::vector<std::string> files;
    std::vector<std::shared_ptr<const Volume>> phases;
    std::optional<double> phaseSeconds;  ///< time between phases; none: unknown
    bool lossyCompressed = false;
    std::vector<ImportFact> facts;
    std::vector<std::string> warnings;  ///< sentences for the person: assumptions, conversions, unknown spacing
};

/// How a headerless raw file is laid out; also kept beside the file as FILE.echolucent.json once given.
struct RawLayout {
    std::array<std::int64_t, 3> size{0, 0, 0};
    std::string type = "uint8";  ///< uint8, int8, uint16, int16, uint32, int32, float32, float64
    bool bigEndian = false;
    std::int64_t headerBytes = 0;
    Vec3 spacing{1, 1, 1};
    bool spacingKnown = false;
};

/// Writes FILE.echolucent.json beside a headerless raw file, so that readStudy() opens it without a layout next time.
[[nodiscard]] Result<void> rememberRawLayout(const std::string& path, const RawLayout& layout);
/// The layout remembered for a file; no value where there is none. Fails where the side-car is there but wrong.
[[nodiscard]] Result<std::optional<RawLayout>> recalledRawLayout(const std::string& path);

struct ReadOptions {
    std::optional<RawLayout> raw;  ///< for files that are neither MetaImage, NRRD nor DICOM
    bool framesAsSlices = false;   ///< take the frames of a multi-frame file without volume geometry as slices
    bool guessNoData = true;       ///< mark the outside of the scanned sector as no data (guessDataMask)
};

/// Reads a volume from a file or a DICOM folder; picks the format by content, then by name. Every size is checked
/// against the file before memory is taken. progress is polled for cancel at least every few MB.
[[nodiscard]] Result<Study> readStudy(const std::string& path, const ReadOptions& options = {},
                                      const Progress& progress = {});

}  // namespace echolucent
