// What a reader has found in a file, before it is put together to a study.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/study/study.h"
#include "io/voxels/large_volumes.h"
#include "io/voxels/voxel_types.h"

namespace echolucent {

/// A file's display window. Its white counts if it suits the voxels (judgeDeclaredWhite()).
struct DisplayWindow {
    double white = 0.0;  ///< the file's value shown as white; finite
    double black = 0.0;  ///< the file's value shown as black; counts if 0 would hide much (value_window.h)
    std::string words;   ///< the window as the file gives it: "centre 79, width 158"
    std::string source;  ///< tags of the window
};

/// What a study holds and where its black comes from, if black is not 0 or float32 cannot hold the values.
struct ShownValues {
    double lowest = 0.0, highest = 0.0;  ///< of all finite values, in the file's own
    std::string blackSource;
};

/// The findings of a reader. In the study, the reader's own `facts` and `warnings` come first.
struct StudyParts {
    std::string path;                ///< as the person gave it
    std::vector<std::string> files;  ///< every file that was read (Study::files)
    // The source of each number, for the import report: a key, a tag or a rule. No source may be empty unless its
    // comment says so.
    std::string sizeSource;    ///< of the size: "DimSize"
    std::string typeSource;    ///< of the stored type: "ElementType"
    std::string phasesSource;  ///< of the number of phases; it may be empty if sizeSource covers it
    VolumeGeometry geometry;   ///< of a right-handed grid
    /// The axis of the file's grid that the reader turned round, in voxels and geometry, to make it right-handed.
    std::optional<GridAxis> turnedAxis;
    std::string spacingSource;  ///< key or tag of the spacing; empty if the spacing is assumed
    /// Whether spacingSource gives the spacing within slices, and their distance is a guess
    /// (VolumeGeometry::spacingKnown is false).
    bool inPlaneSpacingKnown = false;
    int sliceAxis = 2;  ///< axis of the grid, 0 to 2, along which such slices lie
    /// How the voxels were reduced while reading; geometry is then reducedGeometry().
    std::optional<ChosenReduction> reduction;
    ConvertedVoxels voxels;
    std::optional<double> whiteLevel;  ///< the file's value of white
    std::string whiteLevelSource;      ///< key or tag of whiteLevel
    std::optional<double> blackLevel;  ///< the file's value of black, if it states one
    std::string blackLevelSource;      ///< key or tag of blackLevel
    /// The smallest value that the stored bits can mean, if whiteLevel is the largest one. It is black if 0 would hide
    /// much.
    std::optional<double> lowestLevel;
    std::optional<ShownValues> shown;     ///< set by keepVoxels()
    std::optional<DisplayWindow> window;  ///< used if whiteLevel is not given and voxels have more than 8 bits
    /// Which voxels are data (one byte a voxel, 1 is data), for all phases, if the format knows what was scanned. No
    /// guess is made then. Else null.
    Volume::SharedMask dataMask;
    std::string dataMaskSource;  ///< source of dataMask: "geometry of the sweep"
    /// Slices (along z) that could not be read, in rising order. Their voxels hold 0 and are no data; no guess reaches
    /// through them.
    std::vector<std::size_t> missingSlices;
    std::string probeSource;  ///< tags or items of geometry.probe, if there is one
    PhaseTimes phaseTimes{};
    std::string phaseSource;  ///< key or tag of phaseTimes
    LossyCompression lossyCompression = LossyCompression::unknown;
    std::string lossSource;  ///< tags of lossyCompression; empty if the format has no entry for it
    BurnedInText burnedInText = BurnedInText::no;
    std::string burnedInTextSource;  ///< tags of burnedInText; empty if the format has no entry for it
    std::vector<ImportFact> facts;
    std::vector<std::string> warnings;
};

}  // namespace echolucent
