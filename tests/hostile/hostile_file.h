// Files that are damaged or made to do harm, each with the program's required answer. One table for all ways of
// opening.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "processing/document/read_options.h"

namespace echolucent {

/// How opening a hostile file must end.
enum class HostileOutcome {
    refused,        ///< in one sentence, which holds the row's words
    opensWithNote,  ///< as a study whose warnings hold the row's words
    opens,          ///< as a study without any of the row's words in its warnings: it only looks wrong
};

/// One row of the table.
struct HostileFile {
    std::string name;    ///< unique, a topic and what is wrong: "dicom-structure/pixel-spacing-of-200000-values"
    std::string opened;  ///< what to open, below the folder that write() fills; "." is that folder itself
    /// Writes the row's files into an empty folder.
    std::function<void(const std::filesystem::path& folder)> write;
    HostileOutcome outcome = HostileOutcome::refused;
    /// Each word stands in the sentence or, if a study opens, in one of its warnings.
    std::vector<std::string> words;
    ReadOptions options{};
    std::size_t phases = 0;                              ///< of a study that opens; 0 if the row does not say
    std::size_t mostBytesAtOnce = std::size_t{1} << 30;  ///< the most that may be requested in one piece
};

/// A row with one file of these bytes. It is opened.
[[nodiscard]] HostileFile hostileFile(std::string name, std::string file, std::string bytes,
                                      std::vector<std::string> words, HostileOutcome outcome = HostileOutcome::refused);

/// Writes bytes into a new file, and makes the folders above it. Throws if that fails.
void writeBytes(const std::filesystem::path& path, std::string_view bytes);

/// Names of rows about DICOM elements, values and lengths begin with this.
inline const std::string dicomStructureTopic = "dicom-structure/";

// The rows by topic, each in a source file of its own name.
[[nodiscard]] std::vector<HostileFile> hostileTextHeaders();     ///< MetaImage, NRRD, raw layouts
[[nodiscard]] std::vector<HostileFile> hostileNifti();           ///< NIfTI and Analyze
[[nodiscard]] std::vector<HostileFile> hostileKretz();           ///< GE Voluson, in files of its own and in DICOM
[[nodiscard]] std::vector<HostileFile> hostileCompression();     ///< gzip, zlib and bzip2, whatever they hold
[[nodiscard]] std::vector<HostileFile> hostileDicomStructure();  ///< elements, lengths, nesting
[[nodiscard]] std::vector<HostileFile> hostileDicomValues();     ///< numbers of the wrong kind, several, or nonsense
[[nodiscard]] std::vector<HostileFile> hostileDicomContradictions();  ///< headers that are false, bytes behind pixels
[[nodiscard]] std::vector<HostileFile> hostileDicomCuts();            ///< good files that end too early
[[nodiscard]] std::vector<HostileFile> hostileDicomPixels();          ///< frames, fragments, palettes
[[nodiscard]] std::vector<HostileFile> hostileDicomCodecs();          ///< JPEG, JPEG-LS, JPEG 2000
[[nodiscard]] std::vector<HostileFile> hostileDicomSeries();          ///< folders of slices, damaged or mixed
[[nodiscard]] std::vector<HostileFile> hostileDicomFolders();         ///< places of slices, links and pipes, DICOMDIR
[[nodiscard]] std::vector<HostileFile> hostileDicomParts();           ///< parts of objects, copies

// Files with one fault each.
[[nodiscard]] std::vector<HostileFile> hostileMalformedMetaImage();
[[nodiscard]] std::vector<HostileFile> hostileMalformedNrrd();
[[nodiscard]] std::vector<HostileFile> hostileMalformedNifti();
[[nodiscard]] std::vector<HostileFile> hostileMalformedKretz();
[[nodiscard]] std::vector<HostileFile> hostileMalformedDicom();  ///< impossible numbers, codings, objects
[[nodiscard]] std::vector<HostileFile> hostileDataFiles();       ///< lists of data files, voxels as text, packed voxels
[[nodiscard]] std::vector<HostileFile> hostileUnknownFiles();    ///< no known format, false layouts beside raw files
[[nodiscard]] std::vector<HostileFile> hostileEnhancedUs();      ///< Enhanced US Volumes that contradict themselves
[[nodiscard]] std::vector<HostileFile> hostileFoundByFuzzing();  ///< finds of tests/fuzz, of every format

/// The first call takes seconds.
[[nodiscard]] const std::vector<HostileFile>& hostileFiles();
/// Every sixteenth of these rows, in the order of the table, so that most topics have some; every 64th under the
/// address sanitizer, where test_hostile reads them all.
[[nodiscard]] std::vector<HostileFile> sampleOf(const std::vector<HostileFile>& rows);

}  // namespace echolucent
