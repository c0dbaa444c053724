// The reader process from outside: starting it, talking with it, ending it.
#pragma once

#include <memory>
#include <set>
#include <string>

#include "io/restricted/channel.h"
#include "io/restricted/remote_files.h"
#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent::restricted {

/// A reader process, ended with this object whatever it does.
class ReaderProcess {
public:
    /// Starts one; `loadsAhead` as ReaderStart says. Fails (unreadable) where its program is missing or cannot be run.
    [[nodiscard]] static Result<std::unique_ptr<ReaderProcess>> start(bool loadsAhead);
    ~ReaderProcess();
    ReaderProcess(const ReaderProcess&) = delete;
    ReaderProcess& operator=(const ReaderProcess&) = delete;

    /// Hands the request over. False where the process has ended before.
    [[nodiscard]] bool request(const std::string& bytes);

    /// What serve() came to.
    struct Answer {
        std::string bytes;
        std::vector<Descriptor> files;
        std::set<std::string> asked;      ///< the names of files that the reader could have read (FileBroker::asked())
        bool systemCallsFiltered = true;  ///< whether the kernel held the reader to its filter
    };
    /// Answers the reader's questions until its result is there; the process has ended then. `file` is what the person
    /// opened, which sentences name. Fails (cancelled) within 100 ms where progress.cancel is raised, (unreadable)
    /// where the reader ends without a result, says what is none, or says nothing for minutes.
    [[nodiscard]] Result<Answer> serve(FileBroker& broker, const std::string& file, const Progress& progress);

    /// Whether the reader has begun: it gave up what could do harm. One that waited and ended before could not be at
    /// fault.
    [[nodiscard]] bool hasBegun() const { return m_hasBegun; }
    /// The process's number, for tests that end it.
    [[nodiscard]] int number() const { return m_process; }

private:
    ReaderProcess(int process, Descriptor socket) : m_process(process), m_channel(std::move(socket)) {}
    /// Ends the process and waits until it is gone; returns its status as waitpid() gives it.
    int end(bool kill);
    [[nodiscard]] tl::unexpected<Failure> died(const std::string& file);

    int m_process;
    Channel m_channel;
    std::uint64_t m_baseBytes = 0;
    bool m_hasBegun = false;
};

/// The path of the reader's program: beside this one, else where it is installed. Tests set another.
[[nodiscard]] std::string readerProgram();
void useReaderProgram(const std::string& path);

}  // namespace echolucent::restricted
