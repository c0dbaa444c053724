// The reader process from outside: starting it, talking with it and ending it.
#pragma once

#include <memory>
#include <set>
#include <string>

#include "io/restricted/channel.h"
#include "io/restricted/remote_files.h"
#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent::restricted {

/// A reader process. It ends with this object, whatever it does.
class ReaderProcess {
public:
    /// Starts a reader process; `loadsAhead` is as in ReaderStart. Fails (unreadable) if its program is missing or
    /// cannot be run.
    [[nodiscard]] static Result<std::unique_ptr<ReaderProcess>> start(bool loadsAhead);
    ~ReaderProcess();
    ReaderProcess(const ReaderProcess&) = delete;
    ReaderProcess& operator=(const ReaderProcess&) = delete;

    /// Hands the request over. False if the process has already ended or takes nothing for 5 s.
    [[nodiscard]] bool request(const std::string& bytes);

    struct Answer {
        std::string bytes;
        std::vector<Descriptor> files;
        std::set<std::string> asked;      ///< the names of files that the reader may have read (FileBroker::asked())
        bool systemCallsFiltered = true;  ///< whether the kernel held the reader to its filter
    };
    /// Answers the reader's questions until its result is there; the process has ended then. Sentences name `file`,
    /// which the person opened. Fails (cancelled) within 100 ms after progress.cancel is raised; (unreadable) if the
    /// reader ends without a result, sends nonsense, or says nothing for minutes.
    [[nodiscard]] Result<Answer> serve(FileBroker& broker, const std::string& file, const Progress& progress);

    /// Whether the reader has said that it confined itself and begins. If a process ended before, while it waited, the
    /// file did not end it.
    [[nodiscard]] bool hasBegun() const { return m_hasBegun; }
    /// The process's number; below 0 once it has ended. Tests end the process by this number.
    [[nodiscard]] int number() const { return m_process; }

private:
    ReaderProcess(int process, Descriptor socket) : m_process(process), m_channel(std::move(socket)) {}
    /// Ends the process and waits until it is gone. Returns its status as waitpid() gives it.
    int end(bool kill);
    [[nodiscard]] tl::unexpected<Failure> died(const std::string& file);

    int m_process;
    Channel m_channel;
    std::uint64_t m_baseBytes = 0;
    bool m_hasBegun = false;
};

/// The path of the reader's program: beside this program, else where it is installed. Tests set another.
[[nodiscard]] std::string readerProgram();
void useReaderProgram(const std::string& path);

}  // namespace echolucent::restricted
