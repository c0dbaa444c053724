// Turns values into the bytes of a message between the workstation and its reader process, and back. The same
// description of a type writes and reads it. MessageReader trusts no message: it never reaches beyond the bytes, and
// takes memory only in proportion to their number.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "processing/volume/geometry.h"

namespace echolucent::restricted {

/// A type, or the same type const: describe() takes a value to write or to read.
template <typename Value, typename Type>
concept Described = std::same_as<std::remove_const_t<Value>, Type>;

/// Writes values one after the other.
class MessageWriter {
public:
    [[nodiscard]] const std::string& bytes() const { return m_bytes; }

    template <typename... Values>
    void operator()(const Values&... values) {
        (write(values), ...);
    }
    /// Writes a value of an enumeration, as MessageReader::choice() reads it.
    template <typename Choice>
    void choice(const Choice& value, Choice) {
        write(static_cast<std::int32_t>(value));
    }

private:
    template <typename Value>
    void write(const Value& value) {
        if constexpr (std::is_same_v<Value, bool>)
            raw(static_cast<std::uint8_t>(value));
        else if constexpr (std::is_arithmetic_v<Value>)
            raw(value);
        else
            describe(*this, value);
    }
    void write(const std::string& text) {
        raw(static_cast<std::uint64_t>(text.size()));
        m_bytes += text;
    }
    template <typename Value>
    void write(const std::vector<Value>& values) {
        raw(static_cast<std::uint64_t>(values.size()));
        for (const Value& value : values) write(value);
    }
    template <typename Value>
    void write(const std::optional<Value>& value) {
        write(value.has_value());
        if (value) write(*value);
    }
    template <typename Value, std::size_t count>
    void write(const std::array<Value, count>& values) {
        for (const Value& value : values) write(value);
    }
    void write(const Vec3& vector) { write(std::array{vector[0], vector[1], vector[2]}); }
    void write(const Mat3& matrix) {
        for (const double value : matrix.val) raw(value);
    }
    template <typename Value>
    void raw(Value value) {
        m_bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }

    std::string m_bytes;
};

/// The bytes of values, written one after the other.
template <typename... Values>
[[nodiscard]] std::string messageOf(const Values&... values) {
    MessageWriter writer;
    writer(values...);
    return writer.bytes();
}

/// Reads values in the order in which they were written.
class MessageReader {
public:
    /// The bytes must outlive the object.
    explicit MessageReader(std::span<const std::uint8_t> bytes) : m_rest(bytes) {}

    /// Whether all values were there so far. After the first failure, all further values stay as they are, but lists
    /// and optional values become empty.
    [[nodiscard]] bool good() const { return m_good; }
    /// Whether all values were there, and nothing follows them.
    [[nodiscard]] bool complete() const { return m_good && m_rest.empty(); }
    /// The bytes behind the values that were read.
    [[nodiscard]] std::span<const std::uint8_t> rest() const { return m_rest; }
    /// Marks the message as bad, because a value makes no sense.
    void reject() { m_good = false; }

    template <typename... Values>
    void operator()(Values&... values) {
        (read(values), ...);
    }
    template <typename Choice>
    void choice(Choice& value, Choice last) {
        std::int32_t number = 0;
        read(number);
        if (number < 0 || number > static_cast<std::int32_t>(last)) return reject();
        if (m_good) value = static_cast<Choice>(number);
    }

private:
    template <typename Value>
    void read(Value& value) {
        if constexpr (std::is_same_v<Value, bool>) {
            std::uint8_t byte = 0;
            raw(byte);
            if (byte > 1) return reject();
            if (m_good) value = byte == 1;
        } else if constexpr (std::is_arithmetic_v<Value>) {
            raw(value);
        } else {
            describe(*this, value);
        }
    }
    void read(std::string& text) {
        const std::size_t size = count();
        if (!m_good) return;
        text.assign(reinterpret_cast<const char*>(m_rest.data()), size);
        m_rest = m_rest.subspan(size);
    }
    template <typename Value>
    void read(std::vector<Value>& values) {
        const std::size_t size = count();
        values.clear();
        for (std::size_t index = 0; index < size && m_good; ++index) read(values.emplace_back());
    }
    template <typename Value>
    void read(std::optional<Value>& value) {
        bool has = false;
        read(has);
        value.reset();
        if (m_good && has) read(value.emplace());
    }
    template <typename Value, std::size_t count>
    void read(std::array<Value, count>& values) {
        for (Value& value : values) read(value);
    }
    void read(Vec3& vector) {
        for (double& value : vector.val) raw(value);
    }
    void read(Mat3& matrix) {
        for (double& value : matrix.val) raw(value);
    }
    /// The number of things that follow, each of at least one byte.
    std::size_t count() {
        std::uint64_t number = 0;
        raw(number);
        if (number > m_rest.size()) reject();
        return m_good ? static_cast<std::size_t>(number) : 0;
    }
    template <typename Value>
    void raw(Value& value) {
        if (m_rest.size() < sizeof value) reject();
        if (!m_good) return;
        std::memcpy(&value, m_rest.data(), sizeof value);
        m_rest = m_rest.subspan(sizeof value);
    }

    std::span<const std::uint8_t> m_rest;
    bool m_good = true;
};

}  // namespace echolucent::restricted
