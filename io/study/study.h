// The result of a reader: the volumes of a study and the report of how they were read.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "processing/document/read_options.h"
#include "processing/motion/phase_times.h"
#include "processing/progress.h"
#include "processing/result.h"
#include "processing/volume/grid_axis.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// One line of the import report: a fact, its value and its source.
struct ImportFact {
    std::string name;    ///< "spacing", "white level", "lossy compression"
    std::string value;   ///< "0.30 x 0.30 x 0.30 mm"
    std::string source;  ///< "ElementSpacing", "(0018,0088)", "assumed"
};

/// Whether voxels were ever compressed with loss, as far as a file tells. In rising order: the largest value holds for
/// several files together.
enum class LossyCompression { no, unknown, yes };

/// Whether pictures have text drawn into their pixels, as far as a file tells. The text may name the patient. In rising
/// order: the largest value holds for several files together.
enum class BurnedInText {
    no,       ///< the file declares none, is of a kind without text, or its format has no entry for it
    unknown,  ///< a DICOM file of pictures that does not say
    yes,      ///< the file declares text
};

/// A study: one volume, or the phases of a 4D one. Never empty once read. It holds no patient name or identifier.
struct Study {
    std::string name;  ///< name of the file or folder, for the window's title
    /// Every file of the study (header, voxels, layout kept beside a raw file, all DICOM files of a folder), as paths
    /// that can be opened. Empty if it was not read from files. No output may be one of them (refuseToOverwrite()).
    std::vector<std::string> files;
    std::vector<std::shared_ptr<const Volume>> phases;
    PhaseTimes phaseTimes{};
    /// The axis of the file's grid that was turned round, because the grid was left-handed. No value if the grid is the
    /// file's own.
    std::optional<GridAxis> turnedAxis{};
    LossyCompression lossyCompression = LossyCompression::unknown;
    BurnedInText burnedInText = BurnedInText::no;
    std::vector<ImportFact> facts;
    std::vector<std::string> warnings;  ///< sentences for the person: assumptions, conversions, unknown spacing
};

/// Writes FILE.echolucent.json beside a headerless raw file, so that readStudy() opens it without a layout next time.
/// Fails (unwritable) if the folder cannot be written into.
[[nodiscard]] Result<void> rememberRawLayout(const std::string& path, const RawLayout& layout);
/// The layout kept beside the raw file at `path`; no value if there is none. Fails (unreadable) if FILE.echolucent.json
/// is there but describes no layout.
[[nodiscard]] Result<std::optional<RawLayout>> recalledRawLayout(const std::string& path);

/// Reads a volume from the file or DICOM folder at `path`. The content tells the format, else the name. Every size is
/// checked against the file before memory is taken. `progress` is polled for cancel every few MB, between files and
/// between the elements of a DICOM file. Fails (unreadable) if there is no readable volume or not enough memory, (wrong
/// usage) if `path` is empty, (cancelled) if the person ended it.
[[nodiscard]] Result<Study> readStudy(const std::string& path, const ReadOptions& options = {},
                                      const Progress& progress = {});

}  // namespace echolucent
