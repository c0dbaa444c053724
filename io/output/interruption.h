// What a signal that ends the program leaves: files that are not finished are removed first.
#pragma once

#include <csignal>
#include <string>

namespace echolucent {

/// From here on SIGINT, SIGTERM and SIGHUP remove all files that noteUnfinished() was told of, and then end the process
/// as they do by themselves, so that its parent sees the signal. A signal that is ignored stays ignored. It is called
/// once, where a program begins.
void removeUnfinishedOnSignals();

/// A few system calls that no such signal comes between; a signal waits for their end. Steps of several threads come
/// one after the other. A step never begins within another one of its own thread.
class UninterruptedStep {
public:
    UninterruptedStep();
    ~UninterruptedStep();
    UninterruptedStep(const UninterruptedStep&) = delete;
    UninterruptedStep& operator=(const UninterruptedStep&) = delete;

    /// The file at `name` is removed where a signal ends the program.
    void noteUnfinished(const std::string& name);
    /// It is finished, or no longer there.
    void forgetUnfinished(const std::string& name);

private:
    sigset_t m_signals{};  ///< that were held back before
};

}  // namespace echolucent
