// Which frames of a DICOM multi-frame object show tissue, and which belong to one moment.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/dicom/frames/frame_times.h"
#include "io/dicom/frames/functional_groups.h"
#include "processing/result.h"

class DcmItem;

namespace echolucent {

/// What a dimension of a multi-frame object counts.
enum class DimensionMeaning { position, time, dataType, other };

/// One item of the Dimension Index Sequence.
struct FrameDimension {
    DicomTag pointer;  ///< the attribute that varies along the dimension; (0000,0000) if none is named
    DimensionMeaning meaning = DimensionMeaning::other;
};

/// The dimensions of an object, in the order of their index values; empty if it declares none.
[[nodiscard]] std::vector<FrameDimension> readFrameDimensions(DcmItem& dataset);

/// The frames that show tissue, and sentences on those that were left out.
struct TissueFrames {
    std::vector<std::size_t> frames;  ///< counted from 0, in the order of the file
    std::string story;                ///< "tissue intensity", and what was left out; empty if no type is stated
    std::vector<std::string> warnings;
};
/// Keeps the frames of tissue. If no frame states its type, all are kept; if only some do, those without a type are
/// left out. Fails (unreadable, about the file at `path`) if types are stated and none is tissue.
[[nodiscard]] Result<TissueFrames> tissueFramesOf(const std::string& path, const std::vector<FrameGroups>& groups);

struct FramePhases {
    std::vector<std::vector<std::size_t>>
        phases;  ///< in the order of time; the frames of each in the order of the file
    /// The first time of each phase; no value for one phase, or if no attribute states a time of every frame.
    std::optional<DicomTimes> times;
    std::string source;  ///< the attribute that told the phases apart; empty if none was taken
    std::vector<std::string> warnings;
};
/// Splits frames into phases: by the index values of the dimensions that count time, else by Temporal Position Time
/// Offset, else by Temporal Position Index. If places repeat, trigger delays come next, then the order in which Frame
/// Reference or Acquisition Date Time put the frames of each place, with a note. Each of these counts only if all
/// frames state it. If none does, all frames are one phase. They are one phase too if every frame has its own time and
/// its own place, as in a slow sweep. `tissue` names the frames to split, at least one. Fails (unreadable, about the
/// file at `path`) if index values, dimensions and times contradict each other. It also fails if the frames differ
/// along a dimension of unknown meaning, or if phases have different numbers of frames.
[[nodiscard]] Result<FramePhases> splitIntoPhases(const std::string& path,
                                                  const std::vector<FrameDimension>& dimensions,
                                                  const std::vector<FrameGroups>& groups,
                                                  const std::vector<std::size_t>& tissue);

/// The index of a frame along the first dimension that counts positions; no value if there is no such dimension.
[[nodiscard]] std::optional<std::uint32_t> positionIndexOf(const std::vector<FrameDimension>& dimensions,
                                                           const FrameGroups& groups);

}  // namespace echolucent
