// The reader process from inside: it takes one request, confines itself, reads, answers and ends.
#pragma once

namespace echolucent::restricted {

struct ReaderStart {
    int socket = 3;  ///< its end of the channel
    /// Whether it loads what DICOM needs (the dictionary, tables of characters) while it waits. Else it loads them when
    /// the request needs them.
    bool loadsAhead = false;
};

/// Serves one request. Returns the process's exit status.
[[nodiscard]] int serveReader(const ReaderStart& start);

/// Confines itself, then tries what it must not do: open a file or a socket, start a process, write, map code. Prints a
/// line for each, "opening a file: refused (Operation not permitted)" or "...: POSSIBLE". Returns 0 if all is refused.
[[nodiscard]] int tryWhatIsForbidden();

}  // namespace echolucent::restricted
