// What was found when a study was opened, and what a result was made of: for stderr, and for the JSON reports.
#pragma once

#include <string>

#include "app/cli/document_study.h"
#include "app/cli/report/report_json.h"

namespace echolucent::cli {

/// What openStudy() found and what follows, a short sentence a line: beam, side, front, speckle reduction, voxels
/// without data. What an option said is not repeated.
[[nodiscard]] std::string findsText(const DocumentStudy& opened);

/// What a result was made of: program, command, study with its checksum, and what was found on opening. No folder
/// stands in it, not even the study's own. Fails if a file of the study cannot be read again.
[[nodiscard]] Result<Json> madeOf(const Invocation& invocation, const DocumentStudy& opened);

/// An argument with files by their names alone: "manual:/home/jane/curve.json" is "manual:curve.json". What ends in a
/// slash names a folder: its name is left out.
[[nodiscard]] std::string withoutFolders(const std::string& argument);

}  // namespace echolucent::cli
