// Owns and closes open files (descriptors of the operating system), and writes to them.
#pragma once

#include <string_view>

namespace echolucent {

/// An open file. Its destructor closes it.
class Descriptor {
public:
    Descriptor() = default;
    explicit Descriptor(int number) : m_number(number) {}
    ~Descriptor();
    Descriptor(Descriptor&& other) noexcept;
    Descriptor& operator=(Descriptor&& other) noexcept;
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    [[nodiscard]] int number() const { return m_number; }  ///< -1 if it owns none
    [[nodiscard]] explicit operator bool() const { return m_number >= 0; }
    /// Gives up the open file: the caller closes it.
    [[nodiscard]] int release();

private:
    int m_number = -1;
};

/// Writes all bytes, in as many calls as that takes. Returns 0 or an errno.
[[nodiscard]] int writeAll(int descriptor, std::string_view bytes);

}  // namespace echolucent
