// Which frames of a DICOM multi-frame object belong together: to the tissue, and to one moment.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/dicom/frames/functional_groups.h"
#include "processing/result.h"

class DcmItem;

namespace echolucent {

/// What a dimension of a multi-frame object counts.
enum class DimensionMeaning { position, time, dataType, other };

/// One item of the Dimension Index Sequence.
struct FrameDimension {
    DicomTag pointer;  ///< the attribute that varies along it
    DimensionMeaning meaning = DimensionMeaning::other;
};

/// The dimensions of an object, in the order of their index values; none where it declares none.
[[nodiscard]] std::vector<FrameDimension> readFrameDimensions(DcmItem& dataset);

/// The frames that show tissue, and what is to be said of the others.
struct TissueFrames {
    std::vector<std::size_t> frames;  ///< counted from 0, in the order of the file
    std::string story;                ///< "tissue intensity", or what was left out too; empty where no type is stated
    std::vector<std::string> warnings;
};
/// Keeps data types apart. Where no frame states its type, all are kept. Fails (unreadable, about the file at `path`)
/// where types are stated and none is tissue.
[[nodiscard]] Result<TissueFrames> tissueFramesOf(const std::string& path, const std::vector<FrameGroups>& groups);

/// The frames of each phase.
struct FramePhases {
    std::vector<std::vector<std::size_t>> phases;  ///< in the order of time; each in the order of the file
    std::optional<double> phaseSeconds;            ///< seconds between phases, their mean
    std::string source;                            ///< the attribute that told the phases apart
    std::vector<std::string> warnings;
};
/// Splits frames into phases: by the index values of the dimensions that count time, else by Temporal Position Time
/// Offset, else by Temporal Position Index; all are one phase where none of these is stated, and where every frame has
/// a time and a place of its own, as the slices of a slow sweep have. `tissue` names the frames to be split, at least
/// one. Fails (unreadable, about the file at `path`) where index values, dimensions and times contradict each other,
/// where the frames differ along a dimension of unknown meaning, or where phases differ in their number of frames.
[[nodiscard]] Result<FramePhases> splitIntoPhases(const std::string& path,
                                                  const std::vector<FrameDimension>& dimensions,
                                                  const std::vector<FrameGroups>& groups,
                                                  const std::vector<std::size_t>& tissue);

/// The index of a frame along the dimension that counts positions; no value where there is none.
[[nodiscard]] std::optional<std::uint32_t> positionIndexOf(const std::vector<FrameDimension>& dimensions,
                                                           const FrameGroups& groups);

}  // namespace echolucent
