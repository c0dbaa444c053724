// How each file of a folder opens, or why it does not: the table of docs/formats-read.md.
#pragma once

#include <string>

#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent::cli {

/// The row of a file in a Markdown table, without the end of the line: its name, "opens" or "refused", and what was
/// read or why not. If its frames can be taken as slices, the row also says what comes of that.
[[nodiscard]] std::string fileRow(const std::string& path, const std::string& shownName);

/// A Markdown table of all files in a folder and its subfolders, sorted by name. Leaves out files whose name begins
/// with a dot. Fails (unreadable) if the folder cannot be read. Fails (wrong usage) before it reads any file if
/// `output`, the file for the table, is one of the files. Fails (cancelled) if `progress` is cancelled.
[[nodiscard]] Result<std::string> fileTable(const std::string& folder, const Progress& progress,
                                            const std::string& output = {});

}  // namespace echolucent::cli
