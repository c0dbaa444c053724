// Names the study of a document, without holding it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "processing/document/read_options.h"
#include "processing/phantom/phantom_config.h"
#include "processing/volume/grid_axis.h"

namespace echolucent {

/// A study in a file, or in a folder of DICOM slices.
struct StudyFile {
    std::string path;
    ReadOptions options;
    std::string checksum;    ///< of the bytes that were read, with its algorithm in front; empty if unknown
    std::int64_t bytes = 0;  ///< of all files that were read; 0 if the checksum is unknown
    std::int64_t files = 0;  ///< how many files were read; 0 if the checksum is unknown
    /// The axis of the file's grid that was turned round (Study::turnedAxis) when the document was made. No value:
    /// positions and directions of the document lie in the file's own grid.
    std::optional<GridAxis> turnedAxis{};
    friend bool operator==(const StudyFile&, const StudyFile&) = default;
};

/// A scan that the program simulates: defaultPhantom(scene) of a size (voxels) and a seed.
struct SimulatedScan {
    PhantomScene scene = PhantomScene::fetus;
    std::array<std::int64_t, 3> size{192, 192, 192};
    std::uint64_t seed = 1;
    friend bool operator==(const SimulatedScan&, const SimulatedScan&) = default;
};

/// std::monostate: nothing is open.
using StudyReference = std::variant<std::monostate, StudyFile, SimulatedScan>;

/// The axis of the file's grid that was turned round; no value if none was, and for everything but files.
[[nodiscard]] std::optional<GridAxis> turnedAxisOf(const StudyReference& study);

/// Whether both name one study. What is known about its bytes does not count.
[[nodiscard]] bool nameTheSame(const StudyReference& one, const StudyReference& other);

}  // namespace echolucent
