// Files for one test, removed with it.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/study/study.h"

namespace echolucent {

class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "echolucent-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
        m_path = name;
    }
    ~TemporaryFolder() { std::filesystem::remove_all(m_path); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] std::string path() const { return m_path.string(); }
    [[nodiscard]] std::string file(const std::string& name) const { return (m_path / name).string(); }
    std::string write(const std::string& name, const std::string& bytes) const {
        std::ofstream stream(file(name), std::ios::binary);
        stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        return file(name);
    }

private:
    std::filesystem::path m_path;
};

/// The bytes of a file; none if it cannot be read.
inline std::string contentsOf(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Bytes of values in the given order.
template <typename T>
std::string bytesFrom(const std::vector<T>& values, bool bigEndian = false) {
    std::string bytes;
    for (const T& value : values) {
        std::string one(reinterpret_cast<const char*>(&value), sizeof(T));
        if (bigEndian) one = std::string(one.rbegin(), one.rend());
        bytes += one;
    }
    return bytes;
}

/// Takes every voxel as data, so that tests see the voxels without a guessed mask.
inline ReadOptions withoutGuess() {
    ReadOptions options;
    options.guessNoData = false;
    return options;
}

/// The same, with frames over time taken as slices.
inline ReadOptions framesAsSlices() {
    ReadOptions options = withoutGuess();
    options.framesAsSlices = true;
    return options;
}

/// The file's values of all voxels.
inline std::vector<double> storedValues(const Volume& volume) {
    std::vector<double> values;
    for (std::int64_t i = 0; i < volume.geometry().voxelCount(); ++i) values.push_back(volume.fileValue(i));
    return values;
}

/// The value of a fact, or "none".
inline std::string factOf(const Study& study, const std::string& name) {
    for (const ImportFact& fact : study.facts)
        if (fact.name == name) return fact.value;
    return "none";
}

/// Where a fact comes from, or "none".
inline std::string sourceOf(const Study& study, const std::string& name) {
    for (const ImportFact& fact : study.facts)
        if (fact.name == name) return fact.source;
    return "none";
}

inline bool warnsOf(const Study& study, const std::string& words) {
    return std::ranges::any_of(study.warnings,
                               [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
}

}  // namespace echolucent
