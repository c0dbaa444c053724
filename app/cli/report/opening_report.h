// What opening a study found, and what a result was made of: for stderr, and for the JSON reports.
#pragma once

#include <string>

#include "app/cli/options/document_study.h"
#include "app/cli/options/invocation.h"
#include "app/cli/report/report_json.h"

namespace echolucent::cli {

/// What openStudy() found and chose, one short sentence a line: beam, side, front, speckle reduction, voxels without
/// data. It does not repeat options. `opened` must have `finds`.
[[nodiscard]] std::string findsText(const DocumentStudy& opened);

/// What a result was made of: program, command, document and study with their checksums, and what opening found. It
/// names no folder, not even the study's own. Fails if the document or a file of the study cannot be read again.
[[nodiscard]] Result<Json> madeOf(const Invocation& invocation, const DocumentStudy& opened);

/// The study's name as it may be shown: that of its file without a folder, or that of a simulated scan. Empty if the
/// study is a folder, whose name may be a patient's.
[[nodiscard]] std::string shownStudyName(const DocumentStudy& opened);

/// An argument with files by their names alone: "manual:/home/jane/curve.json" becomes "manual:curve.json". An argument
/// that ends in a slash names a folder: the name is left out.
[[nodiscard]] std::string withoutFolders(const std::string& argument);

}  // namespace echolucent::cli
