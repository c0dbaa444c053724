// Open files as the operating system numbers them: who closes one, and how all bytes get into it.
#pragma once

#include <string_view>

namespace echolucent {

/// An open file, closed with its owner.
class Descriptor {
public:
    Descriptor() = default;
    explicit Descriptor(int number) : m_number(number) {}
    ~Descriptor();
    Descriptor(Descriptor&& other) noexcept;
    Descriptor& operator=(Descriptor&& other) noexcept;
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    [[nodiscard]] int number() const { return m_number; }  ///< -1 where it owns none
    [[nodiscard]] explicit operator bool() const { return m_number >= 0; }
    /// Hands the open file over.
    [[nodiscard]] int release();

private:
    int m_number = -1;
};

/// Writes all bytes, however many calls that takes. Gives 0, or the errno of what went wrong.
[[nodiscard]] int writeAll(int descriptor, std::string_view bytes);

}  // namespace echolucent
