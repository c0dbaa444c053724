// Damages session files with a seeded generator.
#pragma once

#include <algorithm>
#include <limits>

#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

namespace echolucent {

/// Makes one text after another from a good one, which is JSON, no plain value and not empty. Bits are flipped; parts
/// are cut away, doubled or filled with noise. JSON values are exchanged, removed, renamed, moved and nested. The ten
/// kinds of change follow each other from `first` on.
class Mutations {
public:
    explicit Mutations(std::string good, unsigned seed, int first = 0)
        : m_good(std::move(good)), m_object(nlohmann::ordered_json::parse(m_good)), m_random(seed), m_count(first) {
        collect(m_object, Pointer());
    }

    std::string next() {
        const int kinds = 10;
        switch (m_count++ % kinds) {
            case 0: return flipped(1);
            case 1: return flipped(1 + below(50));
            case 2: return m_good.substr(0, below(m_good.size()));
            case 3: return without();
            case 4: return doubled();
            case 5: return noisy();
            default: return edited(1 + below(3));
        }
    }

private:
    using Pointer = nlohmann::ordered_json::json_pointer;

    std::size_t below(std::size_t end) { return std::uniform_int_distribution<std::size_t>(0, end - 1)(m_random); }

    void collect(const nlohmann::ordered_json& value, const Pointer& place) {
        for (const auto& [key, inner] : value.items()) {
            if (key.empty()) continue;  // contains() takes it for a place in an array too
            m_places.push_back(place / key);
            if (inner.is_structured()) collect(inner, place / key);
        }
    }

    std::string flipped(std::size_t bits) {
        std::string text = m_good;
        for (std::size_t i = 0; i < bits; ++i) text[below(text.size())] ^= static_cast<char>(1 << below(8));
        return text;
    }
    std::string without() {
        const std::size_t from = below(m_good.size());
        return m_good.substr(0, from) + m_good.substr(std::min(m_good.size(), from + 1 + below(200)));
    }
    std::string doubled() {
        const std::size_t from = below(m_good.size());
        return m_good.substr(0, from) + m_good.substr(from, 1 + below(500)) + m_good.substr(from);
    }
    std::string noisy() {
        std::string text = m_good;
        const std::size_t from = below(text.size());
        for (std::size_t i = from; i < std::min(text.size(), from + 40); ++i) text[i] = static_cast<char>(below(256));
        return text;
    }

    /// A value of any kind, extreme ones included.
    nlohmann::ordered_json strange() {
        using nlohmann::ordered_json;
        switch (below(14)) {
            case 0: return nullptr;
            case 1: return -1;
            case 2: return 1e308;
            case 3: return 0;
            case 4: return std::numeric_limits<std::int64_t>::max();
            case 5: return std::numeric_limits<std::uint64_t>::max();
            case 6: return 0.5;
            case 7: return "";
            case 8: return std::string(5000, 'x');
            case 9: return "a\nb\0c";
            case 10: return ordered_json::array();
            case 11: return ordered_json::object();
            case 12: {
                ordered_json nested = 1;
                for (int depth = 0; depth < 200; ++depth) nested = ordered_json::array({nested});
                return nested;
            }
            default: return ordered_json(std::vector<int>(3000, 7));
        }
    }

    std::string edited(std::size_t edits) {
        nlohmann::ordered_json object = m_object;
        for (std::size_t i = 0; i < edits; ++i) {
            const Pointer place = m_places[below(m_places.size())];
            const Pointer other = m_places[below(m_places.size())];
            if (!object.contains(place)) continue;
            auto& parent = object.at(place.parent_pointer());
            switch (below(5)) {
                case 0: object.at(place) = strange(); break;
                case 1:
                    if (object.contains(other)) object.at(place) = nlohmann::ordered_json(object.at(other));
                    break;
                case 2:
                    if (parent.is_object()) parent.erase(place.back());
                    break;
                case 3:
                    if (parent.is_object()) {
                        const nlohmann::ordered_json value = object.at(place);
                        parent.erase(place.back());
                        parent[place.back() + "_"] = value;
                    }
                    break;
                default:
                    if (object.at(place).is_array() && !object.at(place).empty() &&
                        object.at(place).front().is_primitive()) {
                        const nlohmann::ordered_json first = object.at(place).front();
                        for (int more = 0; more < 1500; ++more) object.at(place).push_back(first);
                    } else {
                        object.at(place) = nlohmann::ordered_json::array({object.at(place)});
                    }
            }
        }
        return object.dump();
    }

    std::string m_good;
    nlohmann::ordered_json m_object;
    std::vector<Pointer> m_places;
    std::mt19937 m_random;
    int m_count;
};

}  // namespace echolucent
