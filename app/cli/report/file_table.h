// How each file of a folder opens, or why it does not: the table of docs/formats-read.md.
#pragma once

#include <string>

#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent::cli {

/// The row of a file in a Markdown table, without the end of the line: its name, "opens" or "refused", and what was
/// read or why it was not. Where frames can be taken as slices, the row says what comes of it.
[[nodiscard]] std::string fileRow(const std::string& path, const std::string& shownName);

/// A Markdown table of all files in a folder and the folders in it, sorted by name; files whose name begins with a dot
/// are left out. Fails (unreadable) where the folder cannot be read, and (wrong usage), before any of them is read,
/// where `output`, which the table is to be written to, is one of them.
[[nodiscard]] Result<std::string> fileTable(const std::string& folder, const Progress& progress,
                                            const std::string& output = {});

}  // namespace echolucent::cli
