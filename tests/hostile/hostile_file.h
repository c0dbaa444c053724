// Files that are damaged or made to hurt, each with what the program has to say of it: one table for all ways of
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

/// How opening a hostile file has to end.
enum class HostileOutcome {
    refused,        ///< in one sentence, which holds the row's words
    opensWithNote,  ///< as a study whose warnings hold the row's words
    opens,          ///< as a study without any of the row's words in its warnings: what looks wrong is not
};

/// One row of the table.
struct HostileFile {
    std::string name;    ///< unique, a topic and what is wrong: "dicom-structure/pixel-spacing-of-200000-values"
    std::string opened;  ///< what is opened, below the folder that write() wrote into; "." is that folder itself
    /// Writes the row's files into an empty folder.
    std::function<void(const std::filesystem::path& folder)> write;
    HostileOutcome outcome = HostileOutcome::refused;
    /// Each of them stands in the sentence or, of a study that opens, in one of its warnings.
    std::vector<std::string> words;
    ReadOptions options{};
    std::size_t phases = 0;  ///< how many a study that opens has; 0 where the row does not say it
    std::size_t mostBytesAtOnce = std::size_t{1} << 30;  ///< that may be asked for
};

/// A row with one file of these bytes, which is opened.
[[nodiscard]] HostileFile hostileFile(std::string name, std::string file, std::string bytes,
                                      std::vector<std::string> words, HostileOutcome outcome = HostileOutcome::refused);

/// Writes bytes into a new file, and the folders above it. Throws where that fails.
void writeBytes(const std::filesystem::path& path, std::string_view bytes);

/// What the names of rows about DICOM elements, values and lengths begin with.
inline const std::string dicomStructureTopic = "dicom-structure/";

// The rows by topic; each stands in a source file of its own name.
[[nodiscard]] std::vector<HostileFile> hostileTextHeaders();     ///< MetaImage, NRRD, raw layouts
[[nodiscard]] std::vector<HostileFile> hostileNifti();           ///< NIfTI and Analyze
[[nodiscard]] std::vector<HostileFile> hostileKretz();           ///< GE Voluson, in files of its own and in DICOM
[[nodiscard]] std::vector<HostileFile> hostileCompression();     ///< gzip, zlib and bzip2, whatever they hold
[[nodiscard]] std::vector<HostileFile> hostileDicomStructure();  ///< elements, lengths, nesting
[[nodiscard]] std::vector<HostileFile> hostileDicomValues();     ///< numbers of the wrong kind, several, or nonsense
[[nodiscard]] std::vector<HostileFile> hostileDicomCuts();       ///< good files that end too early
[[nodiscard]] std::vector<HostileFile> hostileDicomPixels();     ///< frames, fragments, palettes
[[nodiscard]] std::vector<HostileFile> hostileDicomCodecs();     ///< JPEG, JPEG-LS, JPEG 2000
[[nodiscard]] std::vector<HostileFile> hostileDicomSeries();     ///< folders of slices, damaged or mixed
[[nodiscard]] std::vector<HostileFile> hostileDicomFolders();    ///< places of slices, links and pipes, DICOMDIR

// One fault each, in files that are good but for it.
[[nodiscard]] std::vector<HostileFile> hostileMalformedMetaImage();
[[nodiscard]] std::vector<HostileFile> hostileMalformedNrrd();
[[nodiscard]] std::vector<HostileFile> hostileMalformedNifti();
[[nodiscard]] std::vector<HostileFile> hostileMalformedKretz();
[[nodiscard]] std::vector<HostileFile> hostileMalformedDicom();  ///< numbers of no scanner, codings, objects
[[nodiscard]] std::vector<HostileFile> hostileDataFiles();       ///< lists of data files, voxels as text, packed voxels
[[nodiscard]] std::vector<HostileFile> hostileUnknownFiles();    ///< no known format, false layouts beside raw files
[[nodiscard]] std::vector<HostileFile> hostileEnhancedUs();      ///< Enhanced US Volumes that contradict themselves
[[nodiscard]] std::vector<HostileFile> hostileFoundByFuzzing();  ///< whatever tests/fuzz found, of every format

/// All rows.
[[nodiscard]] std::vector<HostileFile> hostileFiles();
/// Every sixteenth of these rows, in the order of the table, so that most topics have some.
[[nodiscard]] std::vector<HostileFile> sampleOf(const std::vector<HostileFile>& rows);

}  // namespace echolucent
