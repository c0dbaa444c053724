// The contents of a header of a MetaImage, an NRRD, a NIfTI or a raw layout: all that is needed to read the voxels.
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

/// A checked header. No voxel has been read yet.
struct StoredVolume {
    std::string path;  ///< header file, as the person gave it
    /// The files with the voxels, at least one; the first may be the header file. Several hold equal parts, in the
    /// voxels' order.
    std::vector<DataFile> data;
    std::string layoutPath;  ///< file that describes a raw file; empty if a person gave the layout or none is needed
    std::string sizeKey;     ///< the key or option that gave the size: "DimSize", "sizes", "--raw-size"
    /// The remedy if the file holds fewer voxels than declared.
    std::string sizeRemedy = "The file is incomplete or its header is wrong: copy or export it again.";
    /// If a data file was packed as a whole: its bytes on the disc, and unpacked in memory.
    std::uint64_t packedBytes = 0, unpackedBytes = 0;
    VoxelExtent extent;          ///< in each data file; length 0 means that the voxels reach to the end of the file
    bool dataAtEnd = false;      ///< the voxels end where the file ends (HeaderSize = -1, byte skip: -1)
    std::int64_t skipLines = 0;  ///< lines of each data file to skip before the extent's offset counts (line skip)
    StoredType type = StoredType::uint8;
    std::string typeKey;  ///< the key or option that gave the type
    bool bigEndian = false;
    std::string byteOrderKey;   ///< the key that gave the byte order; empty if it is assumed
    std::string encodingKey;    ///< the key or rule that says how the voxels are encoded
    std::int64_t channels = 1;  ///< 3 if every voxel is red, green, blue; these are reduced to luma
    VolumeGeometry geometry;    ///< as stored: the grid may be left-handed (axisToTurn())
    /// 1 or -1 for L, P and S: which way the axes of the file's own frame run. RAS: (-1, -1, 1).
    Vec3 ownAxes{1, 1, 1};
    std::int64_t phases = 1;
    bool phasesFastest = false;        ///< the phase is the fastest axis instead of the slowest
    std::string spacingSource;         ///< the key that gave the spacing; empty if it is assumed
    bool inPlaneSpacingKnown = false;  ///< as StudyParts::inPlaneSpacingKnown
    int sliceAxis = 2;                 ///< as StudyParts::sliceAxis
    std::optional<Rescale> rescale;
    std::string rescaleSource;  ///< the keys that gave `rescale`
    /// Set if the voxels are samples along beams: geometry.size counts samples, lines and planes.
    std::optional<PolarGeometry> polar;
    PolarSources polarSources;
    std::optional<double> whiteLevel;
    std::string whiteLevelSource;
    std::optional<double> blackLevel;  ///< as StudyParts::blackLevel
    std::string blackLevelSource;
    std::optional<double> lowestLevel;    ///< as StudyParts::lowestLevel
    std::optional<DisplayWindow> window;  ///< as StudyParts::window
    PhaseTimes phaseTimes{};
    std::string phaseSource;
    std::vector<ImportFact> facts;
    std::vector<std::string> warnings;
};

struct ByteCounts {
    std::int64_t phase = 0;  ///< bytes of one phase
    std::int64_t all = 0;    ///< bytes of all phases
};
/// Counts the bytes that `stored` declares. Fails (unreadable) if they do not fit into 63 bits, or if there are too
/// many phases.
[[nodiscard]] Result<ByteCounts> countBytes(const StoredVolume& stored);
/// The most memory, in bytes, that reading takes at a time: unpacked files, stored bytes, kept voxels and the data
/// mask.
[[nodiscard]] std::uint64_t memoryToRead(const StoredVolume& stored, const ByteCounts& counts);

}  // namespace echolucent
