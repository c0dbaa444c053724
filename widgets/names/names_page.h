// docs/names.md: every name that scripts may use.
#pragma once

#include <QString>
#include <map>
#include <vector>

#include "widgets/names/named_controls.h"

namespace echolucent {

/// Which values of the document a control sets, as paths in one line (docs/document.md#paths); by object name.
using SetPaths = std::map<QString, QString>;

/// The page as Markdown: a table for each place of the controls, in the order of their first. The number of a slider
/// and its reset stand in the slider's row. The tabs that every panel has stand in one table.
[[nodiscard]] QString namesPage(const std::vector<NamedControl>& controls, const SetPaths& paths);

/// The object names of controls in alphabetical order, each once.
[[nodiscard]] QStringList sortedNames(const std::vector<NamedControl>& controls);

}  // namespace echolucent
