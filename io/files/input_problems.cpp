#include "io/files/input_problems.h"

#include <algorithm>
#include <array>
#include <cerrno>

#include <fmt/format.h>

namespace echolucent {

std::string inputProblem(int errorNumber) {
    struct Words {
        int errorNumber;
        const char* words;
    };
    static constexpr std::array<Words, 11> table{
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
         {ENXIO, "it is no file that can be read"}}};
    for (const Words& row : table)
        if (row.errorNumber == errorNumber) return row.words;
    if (isDiscFailure(errorNumber)) return "its disc or the connection to it failed";
    return fmt::format("the system refuses it (error {})", errorNumber);
}

bool isDiscFailure(int errorNumber) {
    static constexpr std::array failures{EIO,         ESTALE,     ENOTCONN,  ENODEV,       ENOMEDIUM,
                                         EREMOTEIO,   ETIMEDOUT,  EHOSTDOWN, EHOSTUNREACH, ENETDOWN,
                                         ENETUNREACH, ECONNRESET, ESHUTDOWN, ECONNABORTED, ENOLINK};
    return std::ranges::find(failures, errorNumber) != failures.end();
}

}  // namespace echolucent
