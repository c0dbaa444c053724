// The file formats that volumes are read from. A new format is its reader and its row in the list of file_formats.cpp.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/stored/stored_volume.h"
#include "io/study/study.h"

namespace echolucent {

/// One format: how its files are called and told, and who reads them.
struct FileFormat {
    /// Reads and checks the header of an opened file; no voxel is read. Where `framesAsSlices` is set, 2D frames over
    /// time are accepted as a volume of unknown spacing.
    using HeaderReader = Result<StoredVolume> (*)(const InputFile& file, bool framesAsSlices, const Progress& progress);
    /// Reads an opened file from its header to its voxels.
    using StudyReader = Result<Study> (*)(const InputFile& file, const ReadOptions& options, const Progress& progress);

    std::string_view name;       ///< in lists: "NRRD"; its heading in docs/formats-read.md begins so
    std::string_view oneOfThem;  ///< in sentences: "an NRRD file"
    /// Lower-case endings, ".gz" behind them aside: where its content tells nothing, a file that ends so is of this
    /// format.
    std::vector<std::string_view> endings;
    /// Patterns of other names that such files, or those beside them, often have. They tell nothing; dialogs show them.
    std::vector<std::string_view> otherNames;
    /// Whether the first 4096 bytes of a file, or all of them where it is shorter, are of this format.
    bool (*isBegunBy)(std::string_view beginning);
    /// Whether the bytes of a whole, short file are a cut beginning of this format. Asked only if isBegunBy() said no.
    bool (*mayBeCutAt)(std::string_view whole);
    /// Who reads it. readStoredVolume() reads the voxels behind a header alone, in the file's order, with coarse voxels
    /// first where that is asked for.
    std::variant<HeaderReader, StudyReader> reader;
    bool needsDicomTables = false;  ///< whether DCMTK's dictionary and tables of characters must be loaded before
    std::string_view mimeType;      ///< for desktops; empty where there is none
    bool definesMimeType = false;   ///< whether we define this MIME type, because the system's list lacks it
    std::string_view mimeMagic;     ///< the bytes that all its files begin with; empty if there are none
};

/// All formats, in the order in which refusals name them. Of several that bytes might be of, the first counts.
[[nodiscard]] std::span<const FileFormat> fileFormats();

/// The format that a file's first 4096 bytes, or all of them where it is shorter, give away; null where none does.
[[nodiscard]] const FileFormat* formatFromContent(std::string_view beginning);
/// The format that the ending of a name says, whatever its case; null where none does.
[[nodiscard]] const FileFormat* formatFromName(const std::string& path);

/// The names of all formats: "MetaImage, NRRD or DICOM".
[[nodiscard]] std::string namesOfFormats();
/// The same with what their files' names end with: "MetaImage (.mha, .mhd), NRRD (.nrrd, .nhdr)".
[[nodiscard]] std::string namesAndEndingsOfFormats();
/// Patterns of the names of all files that open as volumes, raw and packed ones too, for file dialogs: "*.mha *.nrrd".
[[nodiscard]] std::string namesOfVolumes();

}  // namespace echolucent
