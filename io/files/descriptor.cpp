#include "io/files/descriptor.h"

#include <unistd.h>

#include <cerrno>
#include <utility>

namespace echolucent {

Descriptor::~Descriptor() {
    if (m_number >= 0) close(m_number);
}

Descriptor::Descriptor(Descriptor&& other) noexcept : m_number(other.release()) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
    if (this != &other) {
        if (m_number >= 0) close(m_number);
        m_number = other.release();
    }
    return *this;
}

int Descriptor::release() { return std::exchange(m_number, -1); }

int writeAll(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return count < 0 ? errno : EIO;
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return 0;
}

}  // namespace echolucent
