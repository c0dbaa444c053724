// What a process gives up before it reads a stranger's first byte: opening files, writing, the network, other
// processes.
#pragma once

#include <string>

namespace echolucent::restricted {

/// What the kernel enforces on this process.
struct Confinement {
    /// Whether system calls are filtered (seccomp). The process can then open nothing, start no process, make no socket
    /// and map no code. It can write only to what it has open for writing already, such as the channel, and to shared
    /// memory without a name.
    bool systemCalls = false;
    int landlock = 0;  ///< version of the kernel's Landlock, a second lock on the file system; 0: none
    friend bool operator==(const Confinement&, const Confinement&) = default;
};

/// Confines the calling process for ever. Call it while the process has one thread. Threads can still be started.
[[nodiscard]] Confinement confine();

/// A sentence on the confinement: "System calls are filtered; the kernel has no Landlock, ...".
[[nodiscard]] std::string inWords(const Confinement& confinement);

}  // namespace echolucent::restricted
