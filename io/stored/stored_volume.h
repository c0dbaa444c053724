// What the header of a MetaImage, an NRRD, a NIfTI or a raw layout says: everything needed to read the voxels.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/files/data_files.h"
#include "io/study/polar_study.h"
#include "io/study/study_assembly.h"
#include "io/voxels/voxel_source.h"
#include "io/voxels/voxel_types.h"

namespace echolucent {

/// A header, checked and understood; nothing of the voxels has been read yet.
struct StoredVolume {
    std::string path;  ///< header file, as the person gave it
    /// The files that hold the voxels, at least one; the first may be the header file. Several hold equal parts, in the
    /// voxels' order.
    std::vector<DataFile> data;
    std::string layoutPath;  ///< file that describes a raw file; empty where a person gave the layout or none is needed
    std::string sizeKey;     ///< the key or option that declared the size: "DimSize", "sizes", "--raw-size"
    /// What to do where the file holds fewer voxels than declared.
    std::string sizeRemedy = "The file is incomplete or its header is wrong: copy or export it again.";
    /// Where a data file was packed as a whole: its bytes on the disc, and what it was unpacked to in memory.
    std::uint64_t packedBytes = 0, unpackedBytes = 0;
    VoxelExtent extent;          ///< in each data file; a length of 0 means that the voxels end with the file
    bool dataAtEnd = false;      ///< the voxels end where the file ends (HeaderSize = -1, byte skip: -1)
    std::int64_t skipLines = 0;  ///< lines of each data file before the extent's offset is counted (line skip)
    StoredType type = StoredType::uint8;
    std::string typeKey;  ///< the key or option that gave the type
    bool bigEndian = false;
    std::string byteOrderKey;   ///< the key that gave the byte order; empty where it is assumed
    std::string encodingKey;    ///< the key or rule that says how the voxels are encoded
    std::int64_t channels = 1;  ///< 3 where every voxel is red, green, blue; these are reduced to luma
    VolumeGeometry geometry;
    std::int64_t phases = 1;
    bool phasesFastest = false;        ///< the phase is the fastest axis instead of the slowest
    std::string spacingSource;         ///< the key that gave the spacing; empty where the spacing is assumed
    bool inPlaneSpacingKnown = false;  ///< as StudyParts::inPlaneSpacingKnown
    int sliceAxis = 2;                 ///< as StudyParts::sliceAxis
    std::optional<Rescale> rescale;
    std::string rescaleSource;  ///< the keys that gave `rescale`
    /// Where the voxels are samples along beams: their geometry, of geometry.size samples, lines and planes.
    std::optional<PolarGeometry> polar;
    PolarSources polarSources;
    std::optional<double> whiteLevel;
    std::string whiteLevelSource;
    std::optional<WindowWhite> window;  ///< as StudyParts::window
    std::optional<double> phaseSeconds;
    std::string phaseSource;
    std::vector<ImportFact> facts;
    std::vector<std::string> warnings;
};

/// How many bytes the voxels take.
struct ByteCounts {
    std::int64_t phase = 0;  ///< bytes of one phase
    std::int64_t all = 0;    ///< bytes of all phases
};
/// Counts the bytes that `stored` declares. Fails (unreadable) where they cannot be counted in 63 bits,
/// or where there are too many phases.
[[nodiscard]] Result<ByteCounts> countBytes(const StoredVolume& stored);
/// The most memory, in bytes, that reading takes at any one time: what was unpacked, the bytes as they are stored, the
/// voxels as they are kept, and the mask of data.
[[nodiscard]] std::uint64_t memoryToRead(const StoredVolume& stored, const ByteCounts& counts);

}  // namespace echolucent
