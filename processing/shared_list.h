// A list as a value. Its copies share their values in memory.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace echolucent {

/// The values never change: a change makes a new list, and copies keep the old one. So a copy costs as much as a
/// pointer, two copies of one list are compared without a look at their values, and threads may read copies of one
/// list.
template <typename T>
class SharedList {
public:
    using value_type = T;
    using iterator = typename std::vector<T>::const_iterator;
    using const_iterator = iterator;

    SharedList() = default;
    SharedList(std::vector<T> values) {
        if (!values.empty()) m_values = std::make_shared<const std::vector<T>>(std::move(values));
    }
    SharedList(std::initializer_list<T> values) : SharedList(std::vector<T>(values)) {}

    [[nodiscard]] const std::vector<T>& values() const {
        static const std::vector<T> none;
        return m_values ? *m_values : none;
    }
    operator const std::vector<T>&() const { return values(); }

    [[nodiscard]] iterator begin() const { return values().begin(); }
    [[nodiscard]] iterator end() const { return values().end(); }
    [[nodiscard]] std::size_t size() const { return values().size(); }
    [[nodiscard]] bool empty() const { return !m_values; }
    [[nodiscard]] const T& operator[](std::size_t place) const { return (*m_values)[place]; }
    [[nodiscard]] const T& at(std::size_t place) const { return values().at(place); }
    [[nodiscard]] const T& front() const { return m_values->front(); }
    [[nodiscard]] const T& back() const { return m_values->back(); }

    /// Copies the values and lets `how(std::vector<T>&)` change the copy. This list then has the changed values.
    template <typename Change>
    void change(Change&& how) {
        std::vector<T> next = values();
        how(next);
        *this = SharedList(std::move(next));
    }
    void push_back(T value) {
        std::vector<T> next;
        next.reserve(size() + 1);
        next = values();
        next.push_back(std::move(value));
        *this = SharedList(std::move(next));
    }
    void clear() { m_values.reset(); }

    /// Whether both are unchanged copies of one list, or both are empty.
    [[nodiscard]] bool sharesWith(const SharedList& other) const { return m_values == other.m_values; }
    friend bool operator==(const SharedList& one, const SharedList& other) {
        return one.m_values == other.m_values || one.values() == other.values();
    }

private:
    std::shared_ptr<const std::vector<T>> m_values;  ///< null if there are none
};

}  // namespace echolucent
