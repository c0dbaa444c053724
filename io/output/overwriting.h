// Keeps an output from taking the place of a file that was read.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "processing/result.h"

namespace echolucent {

/// Fails (wrong usage, naming both) if an output is the same file as an input. Files are compared by device and inode,
/// so links and other spellings of a path count. New outputs, an empty path and "-" (standard output) pass. Call it
/// before anything is written.
[[nodiscard]] Result<void> refuseToOverwrite(const std::vector<std::string>& inputs,
                                             const std::vector<std::string>& outputs);

/// Kinds of files that a person opens and saves again under the same name. A file of kind `other` never replaces a file
/// that was read.
enum class OutputKind { other, curve, presets, session, rawLayout };

/// Files that were read. While the object or a copy lives, no output of this process may take the place of one of them:
/// placeOfOutput() fails. Only a file of the same kind may replace one, unless the kind is OutputKind::other.
class KeptFiles {
public:
    KeptFiles() = default;
    explicit KeptFiles(std::vector<std::string> files, OutputKind kind = OutputKind::other);

private:
    std::shared_ptr<const void> m_kept;  ///< copies keep the same files
};

/// Keeps the files until the process ends: a command's inputs stay inputs.
void keepFromOverwriting(std::vector<std::string> files, OutputKind kind = OutputKind::other);

/// Fails as refuseToOverwrite() if a file of this kind at `output` would take the place of a kept one.
[[nodiscard]] Result<void> refuseToOverwriteKept(const std::string& output, OutputKind kind = OutputKind::other);

}  // namespace echolucent
