// The reader process from inside: it takes one request, gives up all that could do harm, reads, answers and ends.
#pragma once

namespace echolucent::restricted {

/// How a reader process begins.
struct ReaderStart {
    int socket = 3;  ///< its end of the channel
    /// Whether it loads what reading DICOM needs (the dictionary, tables of characters) while it waits for its request;
    /// else it does so where the request needs it.
    bool loadsAhead = false;
};

/// Serves one request. Returns the process's exit status.
[[nodiscard]] int serveReader(const ReaderStart& start);

/// Gives up all that a reader gives up, then tries what it must not do: to open a file, a socket, to start a process,
/// to write, to map code. Prints a line for each, "opening a file: refused (Operation not permitted)" or "...:
/// POSSIBLE". Returns 0 where all is refused.
[[nodiscard]] int tryWhatIsForbidden();

}  // namespace echolucent::restricted
