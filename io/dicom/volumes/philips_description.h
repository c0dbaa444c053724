// What a file says of a volume that Philips keeps in its own way: QLAB's Cartesian export, private elements of
// scanners.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/dicom/elements/dicom_file.h"
#include "io/dicom/frames/frame_times.h"
#include "processing/result.h"
#include "processing/volume/geometry.h"

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
    std::int64_t phases = 1;            ///< as declared; a QLAB file may hold fewer
    std::optional<Vec3> spacing;        ///< mm; no value if it is missing or makes no sense
    std::string spacingSource;          ///< the tags of the spacing; empty if it is missing or a guess
    std::optional<DicomTimes> times{};  ///< of the declared volumes of a QLAB file
    DicomTag voxels{};                  ///< the element of Kind::privateElement
    std::string warning{};              ///< a sentence if numbers contradict each other; else empty

    /// Voxels of one volume, of Kind::qlab and Kind::privateElement. philipsVolumeOf() checks that they can be counted.
    [[nodiscard]] std::int64_t voxelCount() const { return size[0] * size[1] * size[2]; }
};

/// The volume in a loaded file; no value if the file holds no volume of Philips's. Fails (unreadable) if a QLAB file
/// does not say its size, has pixels of another form than QLAB writes, or holds less than one volume. It also fails if
/// the scanner kept its volume in the maker's own coding; with Failure::framesCouldBeSlices if there are several
/// pictures beside that volume.
[[nodiscard]] Result<std::optional<PhilipsVolume>> philipsVolumeOf(const DicomFile& file);

}  // namespace echolucent
