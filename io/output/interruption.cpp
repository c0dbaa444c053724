#include "io/output/interruption.h"

#include <pthread.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <ctime>
#include <set>

namespace echolucent {

namespace {

constexpr std::array endingSignals{SIGINT, SIGTERM, SIGHUP};

/// The thread that has set it may read and change unfinished(), and holds signals back. So a signal handler only ever
/// waits for another thread.
std::atomic_flag stepUnderWay = ATOMIC_FLAG_INIT;
pid_t owningProcess = 0;

/// Never destroyed, because a signal may come while the process ends.
std::set<std::string>& unfinished() {
    static auto& names = *new std::set<std::string>;
    return names;
}

void beginStep() {
    constexpr timespec moment{.tv_sec = 0, .tv_nsec = 50'000};
    while (stepUnderWay.test_and_set(std::memory_order_acquire)) nanosleep(&moment, nullptr);
}

/// Calls only what a signal handler may call. No step begins after it.
void endBySignal(int signal) {
    // A forked child has its parent's handler and a copy of its names, but must not remove its files.
    if (getpid() == owningProcess) {
        beginStep();
        for (const std::string& name : unfinished()) unlink(name.c_str());
    }
    struct sigaction byItself {};
    byItself.sa_handler = SIG_DFL;
    sigaction(signal, &byItself, nullptr);
    sigset_t only;
    sigemptyset(&only);
    sigaddset(&only, signal);
    raise(signal);
    pthread_sigmask(SIG_UNBLOCK, &only, nullptr);
}

}  // namespace

void removeUnfinishedOnSignals() {
    owningProcess = getpid();
    (void)unfinished();
    for (const int signal : endingSignals) {
        struct sigaction before {};
        if (sigaction(signal, nullptr, &before) != 0 || before.sa_handler == SIG_IGN) continue;
        struct sigaction handled {};
        handled.sa_handler = &endBySignal;
        sigfillset(&handled.sa_mask);
        sigaction(signal, &handled, nullptr);
    }
}

UninterruptedStep::UninterruptedStep() {
    sigset_t held;
    sigemptyset(&held);
    for (const int signal : endingSignals) sigaddset(&held, signal);
    pthread_sigmask(SIG_BLOCK, &held, &m_signals);
    beginStep();
}

UninterruptedStep::~UninterruptedStep() {
    stepUnderWay.clear(std::memory_order_release);
    pthread_sigmask(SIG_SETMASK, &m_signals, nullptr);
}

void UninterruptedStep::noteUnfinished(const std::string& name) { unfinished().insert(name); }

void UninterruptedStep::forgetUnfinished(const std::string& name) { unfinished().erase(name); }

}  // namespace echolucent
