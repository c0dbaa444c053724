// What the functional groups of a DICOM multi-frame object say of its frames.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/dicom/elements/dicom_attributes.h"
#include "processing/progress.h"
#include "processing/result.h"
#include "processing/volume/geometry.h"

class DcmItem;

namespace echolucent {

inline constexpr DicomTag sharedGroupsTag{0x5200, 0x9229};
inline constexpr DicomTag perFrameGroupsTag{0x5200, 0x9230};
inline constexpr DicomTag indexValuesTag{0x0020, 0x9157};
inline constexpr DicomTag timeOffsetTag{0x0020, 0x930d};
inline constexpr DicomTag temporalIndexTag{0x0020, 0x9128};
inline constexpr DicomTag dataTypeTag{0x0018, 0x9808};
inline constexpr DicomTag positionVolumeTag{0x0020, 0x9301};
inline constexpr DicomTag positionPatientTag{0x0020, 0x0032};

/// Where a picture lies in one frame of reference.
struct StatedPlane {
    std::optional<Vec3> position;                    ///< mm, of the centre of the first pixel
    std::optional<std::array<Vec3, 2>> orientation;  ///< unit vectors along a row, along a column; perpendicular

    [[nodiscard]] bool isComplete() const { return position && orientation; }
    friend bool operator==(const StatedPlane&, const StatedPlane&) = default;
};

/// What the groups say of one frame: its own groups, else those of all frames. What neither says is empty.
struct FrameGroups {
    StatedPlane inVolume;                               ///< Plane Position and Orientation (Volume)
    StatedPlane inPatient;                              ///< Plane Position and Orientation (Patient), LPS
    std::optional<std::array<double, 2>> pixelSpacing;  ///< mm along x (between columns) and y (between rows)
    std::optional<double> betweenSlices;                ///< (0018,0088), mm
    std::optional<double> timeOffset;                   ///< Temporal Position Time Offset, seconds
    std::optional<std::int64_t> temporalIndex;          ///< Temporal Position Index
    std::optional<double> triggerDelay;     ///< Nominal, else Actual Cardiac or Respiratory Trigger Delay Time, seconds
    DicomTag delayTag{};                    ///< the attribute that triggerDelay is
    std::optional<double> referenceTime;    ///< Frame Reference Date Time, seconds as of secondsOfDateTime()
    std::optional<double> acquisitionTime;  ///< Frame Acquisition Date Time, the same
    std::string dataType;                   ///< (0018,9808): TISSUE_INTENSITY, FLOW_VELOCITY, ...
    /// Dimension Index Values; splitIntoPhases() checks that there is one a dimension.
    std::vector<std::uint32_t> indexValues;

    friend bool operator==(const FrameGroups&, const FrameGroups&) = default;
};

/// The groups of all `frames` frames, in the order of the file; empty if the object has no groups of single frames.
/// Fails (unreadable, about the file at `path`) if there are groups for more or fewer frames. It also fails if a
/// position, an orientation, a spacing or a time makes no sense, such as NaN. `progress` is polled for cancel.
[[nodiscard]] Result<std::vector<FrameGroups>> readFunctionalGroups(DcmItem& dataset, const std::string& path,
                                                                    std::size_t frames, const Progress& progress);

}  // namespace echolucent
