// Philips's own ways to keep a volume in DICOM: QLAB's Cartesian export, and private elements of scanners.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/dicom/elements/dicom_file.h"
#include "io/dicom/frames/frame_times.h"
#include "io/study/study.h"
#include "io/voxels/voxel_types.h"

namespace echolucent {

/// What a file says of the volume in it.
struct PhilipsVolume {
    enum class Kind {
        qlab,            ///< Pixel Data hold the slices of all volumes; their declared length may be false
        frames,          ///< each frame of Pixel Data is a slice
        privateElement,  ///< `voxels` holds the voxels, uncompressed
    };
    Kind kind = Kind::qlab;
    std::array<std::int64_t, 3> size{0, 0, 0};  ///< columns, rows, slices; above 0
    std::string sizeSource;
    std::int64_t phases = 1;             ///< as declared; a QLAB file may hold fewer
    std::optional<Vec3> spacing;         ///< mm; no value if it is missing or makes no sense
    std::string spacingSource;           ///< the tags of the spacing; empty if it is missing or a guess
    std::optional<StatedTimes> times{};  ///< of the declared volumes of a QLAB file
    DicomTag voxels{};                   ///< the element of Kind::privateElement
    std::string warning{};               ///< a sentence if numbers contradict each other; else empty
};

/// The volume in a loaded file; no value if the file holds no volume of Philips's. Fails (unreadable) if a QLAB file
/// does not say its size, has pixels of another form than QLAB writes, or holds less than one volume. It also fails if
/// the scanner kept its volume in the maker's own coding; with Failure::framesCouldBeSlices if there are several
/// pictures beside that volume.
[[nodiscard]] Result<std::optional<PhilipsVolume>> philipsVolumeOf(const DicomFile& file);

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
