#include "io/restricted/confinement.h"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <initializer_list>
#include <memory>
#include <optional>

#include <fmt/format.h>

namespace echolucent::restricted {

namespace {

/// The rules of seccomp; libseccomp compiles them for the kernel. A call without a rule fails with EPERM, so that
/// libraries that only test for it go on.
class SystemCallFilter {
public:
    SystemCallFilter() : m_context(seccomp_init(SCMP_ACT_ERRNO(EPERM)), seccomp_release) {}

    SystemCallFilter& allow(std::initializer_list<int> calls) {
        for (const int call : calls) add(SCMP_ACT_ALLOW, call, {});
        return *this;
    }
    /// Allows a call whose argument `index`, in the bits of `mask`, is `value`.
    SystemCallFilter& allowWhere(int call, unsigned index, std::uint64_t mask, std::uint64_t value) {
        add(SCMP_ACT_ALLOW, call, scmp_arg_cmp{index, SCMP_CMP_MASKED_EQ, mask, value});
        return *this;
    }
    SystemCallFilter& allowWhere(int call, unsigned index, std::uint64_t value) {
        return allowWhere(call, index, ~std::uint64_t{0}, value);
    }
    SystemCallFilter& refuse(int call, int error) {
        add(SCMP_ACT_ERRNO(static_cast<unsigned>(error)), call, {});
        return *this;
    }
    [[nodiscard]] bool load() { return m_good && m_context && seccomp_load(m_context.get()) == 0; }

private:
    void add(std::uint32_t action, int call, const std::optional<scmp_arg_cmp>& argument) {
        // A call that this machine's architecture lacks has a number below 0 and needs no rule.
        if (call < 0 || !m_context) return;
        const int added = argument ? seccomp_rule_add_array(m_context.get(), action, call, 1, &*argument)
                                   : seccomp_rule_add_array(m_context.get(), action, call, 0, nullptr);
        m_good = m_good && added == 0;
    }

    std::unique_ptr<void, decltype(&seccomp_release)> m_context;
    bool m_good = true;
};

bool filterSystemCalls() {
    SystemCallFilter filter;
    filter
        .allow({SCMP_SYS(read), SCMP_SYS(readv), SCMP_SYS(pread64), SCMP_SYS(lseek), SCMP_SYS(close), SCMP_SYS(fstat),
                SCMP_SYS(write), SCMP_SYS(ftruncate), SCMP_SYS(fallocate), SCMP_SYS(memfd_create), SCMP_SYS(sendmsg),
                SCMP_SYS(recvmsg), SCMP_SYS(poll), SCMP_SYS(ppoll)})
        .allow({SCMP_SYS(munmap), SCMP_SYS(mremap), SCMP_SYS(madvise), SCMP_SYS(brk)})
        .allow({SCMP_SYS(futex), SCMP_SYS(sched_yield), SCMP_SYS(sched_getaffinity), SCMP_SYS(set_robust_list),
                SCMP_SYS(rseq), SCMP_SYS(membarrier), SCMP_SYS(getcpu), SCMP_SYS(gettid), SCMP_SYS(getpid)})
        .allow({SCMP_SYS(rt_sigaction), SCMP_SYS(rt_sigprocmask), SCMP_SYS(rt_sigreturn), SCMP_SYS(sigaltstack),
                SCMP_SYS(restart_syscall)})
        .allow({SCMP_SYS(exit), SCMP_SYS(exit_group), SCMP_SYS(getrandom), SCMP_SYS(sysinfo), SCMP_SYS(uname),
                SCMP_SYS(getrusage), SCMP_SYS(clock_gettime), SCMP_SYS(clock_getres), SCMP_SYS(gettimeofday),
                SCMP_SYS(clock_nanosleep), SCMP_SYS(nanosleep), SCMP_SYS(time)});
    // glibc asks for the status of open files with an empty name.
    filter.allowWhere(SCMP_SYS(newfstatat), 3, AT_EMPTY_PATH);
    filter.allowWhere(SCMP_SYS(mmap), 2, PROT_EXEC, 0).allowWhere(SCMP_SYS(mprotect), 2, PROT_EXEC, 0);
    // Threads may start, processes may not. The arguments of clone3 cannot be seen here; glibc falls back to clone.
    filter.allowWhere(SCMP_SYS(clone), 0, CLONE_THREAD, CLONE_THREAD).refuse(SCMP_SYS(clone3), ENOSYS);
    filter.allowWhere(SCMP_SYS(tgkill), 0, static_cast<std::uint64_t>(getpid()));  // abort()
    filter.allowWhere(SCMP_SYS(prctl), 0, PR_SET_NAME);
    for (const int command : {F_GETFL, F_GETFD, F_SETFD}) filter.allowWhere(SCMP_SYS(fcntl), 1, command);
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    // The sanitizers' runtime writes memory into its own pipe to test whether it can be read. Without the pipe it calls
    // good objects broken.
    filter.allow({SCMP_SYS(pipe), SCMP_SYS(pipe2)});
#endif
    return filter.load();
}

/// Gives up the file system by Landlock. Returns its version, 0 if there is none.
int giveUpFiles() {
    const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    if (version < 1) return 0;
    landlock_ruleset_attr rules{};
    // All accesses that Landlock's first version knows; seccomp closes the others.
    rules.handled_access_fs = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;
    const long ruleset = syscall(SYS_landlock_create_ruleset, &rules, sizeof rules, 0);
    if (ruleset < 0) return 0;
    const bool closed = syscall(SYS_landlock_restrict_self, ruleset, 0) == 0;
    close(static_cast<int>(ruleset));
    return closed ? static_cast<int>(version) : 0;
}

}  // namespace

Confinement confine() {
    const rlimit none{0, 0};
    setrlimit(RLIMIT_CORE, &none);  // no crash file holds what was read
    Confinement confinement;
    // Without privileges, a process needs this for Landlock and seccomp.
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return confinement;
    confinement.landlock = giveUpFiles();
    confinement.systemCalls = filterSystemCalls();
    return confinement;
}

std::string inWords(const Confinement& confinement) {
    const std::string calls = confinement.systemCalls
                                  ? "System calls are filtered (seccomp)"
                                  : "System calls are not filtered: the kernel does not let this process do so";
    const std::string files =
        confinement.landlock > 0 ? fmt::format("the file system is closed (Landlock, version {})", confinement.landlock)
                                 : "the kernel has no Landlock";
    return calls + "; " + files + ".";
}

}  // namespace echolucent::restricted
