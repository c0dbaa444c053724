// The memory that this process holds.
#pragma once

#include <malloc.h>
#include <QFile>

namespace echolucent {

/// Bytes of this process in memory, after the allocator has given back what it can.
[[nodiscard]] inline std::size_t residentBytes() {
    malloc_trim(0);
    QFile status("/proc/self/status");
    if (!status.open(QIODevice::ReadOnly)) return 0;
    for (const QByteArray& line : status.readAll().split('\n'))
        if (line.startsWith("VmRSS:")) return line.mid(6).simplified().split(' ').first().toULongLong() * 1024;
    return 0;
}

/// Bytes that were asked for and not given back.
[[nodiscard]] inline std::size_t allocatedBytes() {
    const struct mallinfo2 all = mallinfo2();
    return all.uordblks + all.hblkhd;
}

}  // namespace echolucent
