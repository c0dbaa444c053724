// Removes unfinished files if a signal ends the program.
#pragma once

#include <csignal>
#include <string>

namespace echolucent {

/// From this call on, SIGINT, SIGTERM and SIGHUP first remove all files of noteUnfinished(). Then the signal ends the
/// process as usual, so that its parent sees the signal. Ignored signals stay ignored. Call it once, when a program
/// begins.
void removeUnfinishedOnSignals();

/// A few system calls that SIGINT, SIGTERM and SIGHUP do not interrupt: a signal waits until the object is destroyed.
/// Only one thread at a time has a step; the constructor waits for the others. A thread must not begin a step within
/// its own step.
class UninterruptedStep {
public:
    UninterruptedStep();
    ~UninterruptedStep();
    UninterruptedStep(const UninterruptedStep&) = delete;
    UninterruptedStep& operator=(const UninterruptedStep&) = delete;

    /// A signal that ends the program removes the file at `name`.
    void noteUnfinished(const std::string& name);
    /// The file is finished, or no longer there.
    void forgetUnfinished(const std::string& name);

private:
    sigset_t m_signals{};  ///< the signals held back before
};

}  // namespace echolucent
