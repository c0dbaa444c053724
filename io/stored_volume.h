// What the header of a MetaImage, an NRRD or a raw layout says: everything needed to read the voxels.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/study.h"
#include "io/voxel_source.h"
#include "io/voxel_types.h"

namespace echolucent {

/// A header, checked and understood; nothing of the voxels has been read yet.
struct StoredVolume {
    std::string path;        ///< header file, as the person gave it
    std::string dataPath;    ///< file that holds the voxels; may be the same
    std::string layoutPath;  ///< file that describes a raw file; empty where a person gave the layout or none is needed
    std::string sizeKey;     ///< what declared the size: "DimSize", "sizes", "--raw-size"
    VoxelExtent extent;      ///< `length` is filled in from the file where 0
    bool dataAtEnd = false;  ///< voxels end where the file ends (HeaderSize = -1, byte skip: -1)
    StoredType type = StoredType::uint8;
    bool bigEndian = false;
    std::int64_t channels = 1;  ///< 3: red, green, blue, fastest; reduced to luma
    VolumeGeometry geometry;
    std::int64_t phases = 1;
    bool phasesFastest = false;  ///< the phase is the fastest axis instead of the slowest
    std::string spacingSource;   ///< empty: assumed
    std::optional<double> whiteLevel;
    std::string whiteLevelSource;
    std::optional<double> phaseSeconds;
    std::string phaseSource;
    std::vector<ImportFact> facts;
    std::vector<std::string> warnings;
};

/// Bytes of the voxels of one phase and of all, or a failure where they cannot be counted in 63 bits.
struct ByteCounts {
    std::int64_t phase = 0;
    std::int64_t all = 0;
};
[[nodiscard]] Result<ByteCounts> countBytes(const StoredVolume& stored);

/// Compares the declared size with what the file can hold, only then takes memory and reads.
[[nodiscard]] Result<Study> readStoredVolume(StoredVolume stored, const ReadOptions& options, const Progress& progress);

/// The path of a data file named in a header; fails unless it stays in the header's folder.
[[nodiscard]] Result<std::string> dataFileBeside(const std::string& headerPath, const std::string& key,
                                                 const std::string& name);

}  // namespace echolucent
