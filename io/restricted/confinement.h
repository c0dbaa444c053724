// What a process that reads strangers' bytes gives up before it reads the first: opening files, writing, the network,
// other processes.
#pragma once

#include <string>

namespace echolucent::restricted {

/// What the kernel holds this process to.
struct Confinement {
    /// Whether system calls are filtered (seccomp): nothing can be opened, no process started, no socket made, no code
    /// be mapped; only shared memory without a name can be written to.
    bool systemCalls = false;
    int landlock = 0;  ///< version of the kernel's Landlock that closes the file system a second time; 0: it has none
    friend bool operator==(const Confinement&, const Confinement&) = default;
};

/// Confines the process that calls it, for ever. To be called while it has one thread. Threads can still be started.
[[nodiscard]] Confinement confine();

/// A sentence on what holds: "System calls are filtered; the kernel has no Landlock, ...".
[[nodiscard]] std::string inWords(const Confinement& confinement);

}  // namespace echolucent::restricted
