// What keeps an output from taking the place of a file that was read.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "processing/result.h"

namespace echolucent {

/// Fails (wrong usage, naming both files) where one of the `outputs` is the same file as one of the `inputs`. Files are
/// compared by device and inode, so that links and other spellings of a path count. An output that does not exist yet,
/// an empty path and "-" (standard output) pass. It is to be asked before anything is written.
[[nodiscard]] Result<void> refuseToOverwrite(const std::vector<std::string>& inputs,
                                             const std::vector<std::string>& outputs);

/// Kinds of files that a person opens and saves again under the same name. Any other file never takes the place of one
/// that was read.
enum class OutputKind { other, curve, presets, session, rawLayout };

/// Files that were read. While this lives, every file that this process writes asks whether it would take the place of
/// one of them (placeOfOutput()), and fails then; only a file of the same kind may, where that is not
/// OutputKind::other.
class KeptFiles {
public:
    KeptFiles() = default;
    explicit KeptFiles(std::vector<std::string> files, OutputKind kind = OutputKind::other);

private:
    std::shared_ptr<const void> m_kept;  ///< copies keep the same files
};

/// Keeps the files for as long as the process lives: for a command, whose inputs stay inputs until it ends.
void keepFromOverwriting(std::vector<std::string> files, OutputKind kind = OutputKind::other);

/// Fails as refuseToOverwrite() does where a file of this kind at `output` would take the place of one that is kept.
[[nodiscard]] Result<void> refuseToOverwriteKept(const std::string& output, OutputKind kind = OutputKind::other);

}  // namespace echolucent
