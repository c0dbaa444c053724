// Files of a fuzz target in memory.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace echolucent {

/// A folder in memory that goes with the process; each target has one of its own. It lies in the folder that
/// ECHOLUCENT_FUZZ_FOLDER in the environment names, else in /dev/shm where that is there.
class FuzzedFolder {
public:
    FuzzedFolder();
    ~FuzzedFolder();
    FuzzedFolder(const FuzzedFolder&) = delete;
    FuzzedFolder& operator=(const FuzzedFolder&) = delete;

    [[nodiscard]] std::string path() const { return m_path.string(); }
    /// Writes a file in the place of the one before, and names it. Throws where that fails.
    [[nodiscard]] std::string write(const std::string& name, std::string_view bytes) const;

private:
    std::filesystem::path m_path;
};

}  // namespace echolucent
