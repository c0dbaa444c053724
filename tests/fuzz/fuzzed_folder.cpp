#include "fuzzed_folder.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

namespace echolucent {

namespace {

std::filesystem::path folderInMemory() {
    if (const char* named = std::getenv("ECHOLUCENT_FUZZ_FOLDER")) return named;
    const char* memory = "/dev/shm";
    return access(memory, W_OK) == 0 ? memory : std::filesystem::temp_directory_path();
}

}  // namespace

FuzzedFolder::FuzzedFolder() {
    std::string name = (folderInMemory() / "echolucent-fuzz-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder in memory");
    m_path = name;
}

FuzzedFolder::~FuzzedFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
}

std::string FuzzedFolder::write(const std::string& name, std::string_view bytes) const {
    std::string path = (m_path / name).string();
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (file < 0) throw std::runtime_error("no file in memory: " + path);
    const bool written = ::write(file, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
    close(file);
    if (!written) throw std::runtime_error("a file in memory could not be written: " + path);
    return path;
}

}  // namespace echolucent
