// Reads the voxels of volumes that Philips keeps in its own ways.
#pragma once

#include <cstdint>
#include <vector>

#include "io/dicom/elements/dicom_file.h"
#include "io/dicom/volumes/philips_description.h"
#include "io/study/study.h"
#include "io/voxels/voxel_types.h"

namespace echolucent {

struct GreySlice {
    std::int64_t columns = 0, rows = 0;
    StoredType type = StoredType::uint8;  ///< uint8, int8, uint16, int16 or float32
    std::vector<std::uint8_t> bytes;      ///< row after row, in this machine's byte order
};

/// Reads slice `index` (from 0) of the first phase. `progress` is polled for cancel.
[[nodiscard]] Result<GreySlice> readPhilipsSlice(const InputFile& input, const DicomFile& file,
                                                 const PhilipsVolume& volume, std::int64_t index,
                                                 const Progress& progress);

/// Reads the volume that philipsVolumeOf() found in `file`, which was loaded from `input`.
[[nodiscard]] Result<Study> readPhilipsVolume(const InputFile& input, const DicomFile& file,
                                              const PhilipsVolume& volume, const ReadOptions& options,
                                              const Progress& progress);

}  // namespace echolucent
