// Files of a fuzz target in memory.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace echolucent {

/// A folder in memory that goes with the process; each target has its own. It lies in the folder that the environment's
/// ECHOLUCENT_FUZZ_FOLDER names, else in /dev/shm if that exists.
class FuzzedFolder {
public:
    FuzzedFolder();
    ~FuzzedFolder();
    FuzzedFolder(const FuzzedFolder&) = delete;
    FuzzedFolder& operator=(const FuzzedFolder&) = delete;

    [[nodiscard]] std::string path() const { return m_path.string(); }
    /// Writes a file in place of the one before and returns its path. Throws if that fails.
    [[nodiscard]] std::string write(const std::string& name, std::string_view bytes) const;

private:
    std::filesystem::path m_path;
};

}  // namespace echolucent
