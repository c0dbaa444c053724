// The last step of every reader: voxels and geometry in, a study with its import report out.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/study/study.h"
#include "io/voxels/large_volumes.h"
#include "io/voxels/voxel_types.h"

namespace echolucent {

/// What a file's display window says of white. It counts where it suits the voxels (judgeDeclaredWhite()).
struct WindowWhite {
    double white = 0.0;  ///< stored value that the window shows as white; finite
    std::string words;   ///< the window as the file gives it: "centre 79, width 158"
    std::string source;  ///< tags that gave it
};

/// No scanner writes more phases, and no reader takes more.
constexpr std::int64_t mostPhases = 4096;
/// Fails (unreadable, about `file` and the key, tag or option `element` that gave the number) where `phases` are more.
/// To be asked before memory is taken for them.
[[nodiscard]] Result<void> requirePhases(const std::string& file, const std::string& element, std::int64_t phases);

/// What a reader has found out. Its own `facts` and `warnings` come first in the study's.
struct StudyParts {
    std::string path;                ///< as the person gave it
    std::vector<std::string> files;  ///< every file that was read (Study::files)
    // What gave each number, for the import report: a key, a tag or a rule. None of the sources may stay empty.
    std::string sizeSource;    ///< of the size: "DimSize"
    std::string typeSource;    ///< of the stored type: "ElementType"
    std::string phasesSource;  ///< of the number of phases; it may be empty where that is in the size's source
    VolumeGeometry geometry;
    std::string spacingSource;  ///< key or tag that gave the spacing; empty where the spacing is assumed
    /// Whether spacingSource gives the spacing within slices whose distance is a guess (VolumeGeometry::spacingKnown is
    /// false).
    bool inPlaneSpacingKnown = false;
    int sliceAxis = 2;  ///< axis of the grid, 0 to 2, that such slices lie along
    /// How the voxels were reduced while they were read; geometry is reducedGeometry() then.
    std::optional<ChosenReduction> reduction;
    ConvertedVoxels voxels;
    std::optional<double> whiteLevel;
    std::string whiteLevelSource;       ///< key or tag that gave whiteLevel
    std::optional<WindowWhite> window;  ///< asked where whiteLevel is not given and voxels have more than 8 bits
    /// Which voxels are data (one byte a voxel, 1 is data), for all phases, where the format knows what was scanned: no
    /// guess is made then. Null where it does not.
    Volume::SharedMask dataMask;
    std::string dataMaskSource;  ///< what gave dataMask: "geometry of the sweep"
    /// Slices (along z) of which nothing could be read, in rising order: their voxels, which hold 0, are no data, and
    /// no guess reaches through them.
    std::vector<std::size_t> missingSlices;
    std::string probeSource;  ///< tags or items that gave geometry.probe, where there is one
    std::optional<double> phaseSeconds;
    std::string phaseSource;  ///< key or tag of the time between phases
    LossyCompression lossyCompression = LossyCompression::unknown;
    std::string lossSource;  ///< tags that gave lossyCompression; empty where the format has no entry for it
    BurnedInText burnedInText = BurnedInText::no;
    std::string burnedInTextSource;  ///< tags that gave burnedInText; empty where the format has no entry for it
    std::vector<ImportFact> facts;
    std::vector<std::string> warnings;
};

/// Builds the volumes (one white level for all phases), guesses where there is no data, and completes the report. Fails
/// (unreadable) where the spacing or the origin is one that no scanner makes, NaN among them; (cancelled) where the
/// person ended it.
[[nodiscard]] Result<Study> assembleStudy(StudyParts parts, const ReadOptions& options, const Progress& progress);

/// The share of the voxels of all phases that are no data, [0,1].
[[nodiscard]] double noDataShare(const std::vector<std::shared_ptr<const Volume>>& phases);

/// A size as text, such as "152 x 156 x 110".
[[nodiscard]] std::string sizeText(const std::array<std::int64_t, 3>& size);
/// A spacing as text, such as "0.3 x 0.3 x 0.5 mm".
[[nodiscard]] std::string spacingText(const Vec3& spacing);

/// The name of the file or folder at `path`, without the folders above it.
[[nodiscard]] std::string nameFromPath(const std::string& path);

/// Whether a position in the patient can be one: its coordinates (mm) are finite and no more than 10 km from 0, where
/// doubles still tell nanometres apart.
[[nodiscard]] bool isPosition(const Vec3& position);

/// Whether a spacing (mm) is one that some scanner has: neither a slip of units nor voxels a thousand times as long as
/// wide, which would make tube cores and rays of millions of samples. False where one is no number.
[[nodiscard]] bool isSensibleSpacing(const Vec3& spacing);
/// Whether a white level is one that float32, in which voxels are shown, can hold: above 0 and finite there.
[[nodiscard]] bool isSensibleWhite(double level);

/// Makes the columns of `direction` unit vectors. False where one has no length or the three do not span space.
[[nodiscard]] bool normalizeDirection(Mat3& direction);
/// Whether directions (LPS) of MetaImage and NRRD say anything of the patient: programs that know none write the axes
/// of LPS or of RAS.
[[nodiscard]] bool saysMoreThanItsAxes(const Mat3& direction);
/// A sentence where the columns of `direction` (unit vectors) are not perpendicular to each other; else empty.
[[nodiscard]] std::string skewWarning(const Mat3& direction);

}  // namespace echolucent
