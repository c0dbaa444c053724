// The reader process from inside: it takes one request, confines itself, reads, answers and ends.
#pragma once

namespace echolucent::restricted {

struct ReaderStart {
    int socket = 3;  ///< the reader's end of the channel
    /// Whether the reader loads what DICOM needs (the dictionary, tables of characters) while it waits for the request.
    /// Else it loads them when the request needs them.
    bool loadsAhead = false;
};

/// Serves one request and then ends the process. Returns the process's exit status only if it read nothing: 0 if no
/// request came, another number if the request made no sense or the workstation was gone.
[[nodiscard]] int serveReader(const ReaderStart& start);

/// Confines the process, then tries what it must not do: open or create a file, open a socket, signal or start a
/// process, run a program, map code. Prints a line for each, "opening a file: refused (Operation not permitted)" or
/// "...: POSSIBLE". Returns 0 if all is refused.
[[nodiscard]] int tryWhatIsForbidden();

}  // namespace echolucent::restricted
