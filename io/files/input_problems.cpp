#include "io/files/input_problems.h"

#include <array>
#include <cerrno>

#include <fmt/format.h>

namespace echolucent {

std::string inputProblem(int errorNumber) {
    struct Words {
        int errorNumber;
        const char* words;
    };
    static constexpr std::array<Words, 13> table{
        {{ENOENT, "it does not exist"},
         {EACCES, "the permission to read it, or to enter a folder above it, is missing"},
         {EPERM, "the permission to read it, or to enter a folder above it, is missing"},
         {ENOTDIR, "what stands above it in its path is no folder"},
         {EISDIR, "it is a folder"},
         {ELOOP, "its links lead in a circle"},
         {ENAMETOOLONG, "its name is longer than the system allows"},
         {EMFILE, "too many files are open"},
         {ENFILE, "too many files are open"},
         {ENOMEM, "there is not enough memory"},
         {ENXIO, "it is no file that can be read"},
         {EIO, "its disc or the connection to it failed"},
         {ESTALE, "its disc or the connection to it failed"}}};
    for (const Words& row : table)
        if (row.errorNumber == errorNumber) return row.words;
    return fmt::format("the system refuses it (error {})", errorNumber);
}

}  // namespace echolucent
