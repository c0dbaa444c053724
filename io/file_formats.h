// The file formats of volumes. A new format is its reader and its row in the list of file_formats.cpp.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/stored/stored_volume.h"
#include "io/study/study.h"

namespace echolucent {

/// One format: the names of its files, how to recognise them, and their reader.
struct FileFormat {
    /// Reads and checks the header of an opened file, without voxels. If `framesAsSlices` is set, 2D frames over time
    /// are accepted as slices at an unknown distance.
    using HeaderReader = Result<StoredVolume> (*)(const InputFile& file, bool framesAsSlices, const Progress& progress);
    /// Reads an opened file from its header to its voxels.
    using StudyReader = Result<Study> (*)(const InputFile& file, const ReadOptions& options, const Progress& progress);

    std::string_view name;       ///< in lists: "NRRD"; its heading in docs/formats-read.md begins with it
    std::string_view oneOfThem;  ///< in sentences: "an NRRD file"
    /// Lower-case endings, without ".gz" behind them. If the content tells nothing, a file with such an ending is of
    /// this format.
    std::vector<std::string_view> endings;
    /// Patterns of other names that such files, or those beside them, often have. Only dialogs use them.
    std::vector<std::string_view> otherNames;
    /// Whether a file that begins with these bytes is of this format. `beginning` holds its first 4096 bytes, or all of
    /// a shorter file.
    bool (*isBegunBy)(std::string_view beginning);
    /// Whether the bytes of a whole, short file are a cut beginning of this format. Asked only if isBegunBy() said no.
    bool (*mayBeCutAt)(std::string_view whole);
    /// The reader. If it is a HeaderReader, readStoredVolume() reads the voxels: in the file's order, and coarse voxels
    /// first if they are wanted.
    std::variant<HeaderReader, StudyReader> reader;
    bool needsDicomTables = false;  ///< whether DCMTK's dictionary and tables of characters must be loaded before
    std::string_view mimeType;      ///< for desktops; empty if there is none
    bool definesMimeType = false;   ///< whether we define this MIME type, because the system's list lacks it
    std::string_view mimeMagic;     ///< the first bytes of all its files; empty if there are none
};

/// All formats, in the order in which refusals name them. If bytes fit several formats, the first counts.
[[nodiscard]] std::span<const FileFormat> fileFormats();

/// The format of a file by its first 4096 bytes, or all of a shorter file; null if they fit none.
[[nodiscard]] const FileFormat* formatFromContent(std::string_view beginning);
/// The format by the ending of a name, in any case, without ".gz" behind it; null if no format has that ending.
[[nodiscard]] const FileFormat* formatFromName(const std::string& path);

/// The names of all formats: "MetaImage, NRRD or DICOM".
[[nodiscard]] std::string namesOfFormats();
/// The names with the endings of their files: "MetaImage (.mha, .mhd), NRRD (.nrrd, .nhdr)".
[[nodiscard]] std::string namesAndEndingsOfFormats();
/// Patterns of the names of all files that open as volumes, also raw and packed ones, for file dialogs: "*.mha *.nrrd".
[[nodiscard]] std::string namesOfVolumes();

}  // namespace echolucent
