#include "io/program_beside.h"

#include <filesystem>
#include <system_error>

namespace echolucent {

std::string programBeside(const std::string& name) {
    std::error_code error;
    const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
    if (error) return "/" + name;  // never a program of the working folder
    const std::filesystem::path beside = here / name;
    if (std::filesystem::exists(beside, error)) return beside.string();
    return (here / ECHOLUCENT_LIBRARY_FOLDER / name).lexically_normal().string();
}

}  // namespace echolucent
