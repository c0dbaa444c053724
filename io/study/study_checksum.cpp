#include "io/study/study_checksum.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <set>

#include "io/files/input_file.h"

namespace echolucent {

namespace {

namespace fs = std::filesystem;
using Digest = std::array<unsigned char, sizeof(XXH128_canonical_t)>;

Digest canonical(const XXH128_hash_t& hash) {
    XXH128_canonical_t bytes;
    XXH128_canonicalFromHash(&bytes, hash);
    Digest digest{};
    std::copy(std::begin(bytes.digest), std::end(bytes.digest), digest.begin());
    return digest;
}

Result<Digest> digestOf(const InputFile& file, const Progress& progress) {
    constexpr std::uint64_t atOnce = std::uint64_t{4} << 20;
    const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state(XXH3_createState(), &XXH3_freeState);
    XXH3_128bits_reset(state.get());
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(std::min(atOnce, file.size())));
    for (std::uint64_t done = 0; done < file.size();) {
        if (progress.cancelled()) return fail(FailureKind::cancelled, {}, {}, "cancelled");
        const std::span part(bytes.data(), static_cast<std::size_t>(std::min(atOnce, file.size() - done)));
        if (auto read = file.readAt(done, part); !read) return tl::unexpected<Failure>(read.error());
        XXH3_128bits_update(state.get(), part.data(), part.size());
        done += part.size();
    }
    return canonical(XXH3_128bits_digest(state.get()));
}

/// The regular files in and below a folder; empty if there are more than `most`.
std::vector<std::string> filesBelow(const fs::path& folder, std::size_t most) {
    std::vector<std::string> files;
    std::error_code error;
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        std::error_code unknown;
        if (entry->is_regular_file(unknown)) files.push_back(entry->path().string());
        if (files.size() > most) return {};
    }
    return files;
}

std::int64_t bytesOfFiles(const std::vector<std::string>& files) {
    std::int64_t bytes = 0;
    for (const std::string& file : files) {
        std::error_code error;
        const auto size = fs::file_size(file, error);
        if (!error) bytes += static_cast<std::int64_t>(size);
    }
    return bytes;
}

/// Checks paths one after the other, each once.
class Search {
public:
    Search(const StudyFile& study, const Progress& progress)
        : m_study(study), m_name(fs::path(study.path).filename()), m_progress(progress) {}

    bool isStudy(const fs::path& path) {
        if (!m_asked.insert(path.lexically_normal().string()).second) return false;
        std::error_code error;
        const fs::file_status status = fs::status(path, error);
        if (error || m_progress.cancelled()) return false;
        if (fs::is_directory(status)) {
            // A header with its voxels is opened by the header, not by the folder.
            if (m_study.files < 2 || fs::is_regular_file(path / m_name, error)) return false;
            return hasItsBytes(filesBelow(path, static_cast<std::size_t>(m_study.files)));
        }
        if (!fs::is_regular_file(status)) return false;
        if (m_study.files > 1) return path.filename() == m_name && isHeaderOfStudy(path);
        return hasItsBytes({path.string()});
    }

    std::optional<std::string> below(const fs::path& folder) {
        constexpr int deepest = 4;
        constexpr int most = 20'000;
        if (isStudy(folder)) return innermost(folder);
        int looked = 0;
        std::error_code error;
        fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
        for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
            if (++looked > most || m_progress.cancelled()) return std::nullopt;
            if (entry.depth() >= deepest) entry.disable_recursion_pending();
            if (isStudy(entry->path())) return innermost(entry->path());
        }
        return std::nullopt;
    }

private:
    /// The innermost of folders that only hold one folder each.
    static std::string innermost(fs::path path) {
        std::error_code error;
        for (fs::directory_iterator only(path, error);
             !error && only != fs::directory_iterator() && only->is_directory(error);
             only = fs::directory_iterator(path, error)) {
            const fs::path inner = only->path();
            if (only.increment(error) != fs::directory_iterator() || error) break;
            path = inner;
        }
        return path.string();
    }

    /// Whether a header and its voxels are the study.
    bool isHeaderOfStudy(const fs::path& header) const {
        std::vector<std::string> ofItsStem{header.string()};
        std::error_code error;
        fs::directory_iterator entry(header.parent_path(), fs::directory_options::skip_permission_denied, error);
        for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
            std::error_code unknown;
            const fs::path& path = entry->path();
            if (path.filename() == header.filename() || !entry->is_regular_file(unknown)) continue;
            if (hasItsBytes({header.string(), path.string()}))
                return true;  // the second of two files may have any name
            if (path.filename().string().starts_with(header.stem().string())) ofItsStem.push_back(path.string());
        }
        return hasItsBytes(ofItsStem);
    }

    bool hasItsBytes(const std::vector<std::string>& files) const {
        if (static_cast<std::int64_t>(files.size()) != m_study.files || bytesOfFiles(files) != m_study.bytes)
            return false;
        const auto checksum = checksumOf(files, m_progress);
        return checksum && checksum->text == m_study.checksum;
    }

    const StudyFile& m_study;
    fs::path m_name;
    const Progress& m_progress;
    std::set<std::string> m_asked;
};

}  // namespace

Result<StudyChecksum> checksumOf(const std::vector<std::string>& files, const Progress& progress) {
    StudyChecksum checksum;
    std::vector<Digest> digests;
    for (const std::string& path : files) {
        const auto file = InputFile::open(path);
        if (!file) return tl::unexpected(file.error());
        const auto digest = digestOf(*file, progress);
        if (!digest) return tl::unexpected(digest.error());
        digests.push_back(*digest);
        checksum.bytes += static_cast<std::int64_t>(file->size());
        ++checksum.files;
    }
    std::ranges::sort(digests);
    const Digest all = digests.size() == 1 ? digests.front()
                                           : canonical(XXH3_128bits(digests.data(), digests.size() * sizeof(Digest)));
    checksum.text = "xxh3-128:";
    for (const unsigned char byte : all) checksum.text += fmt::format("{:02x}", byte);
    return checksum;
}

StudyFile withChecksum(StudyFile study, const StudyChecksum& checksum) {
    study.checksum = checksum.text;
    study.bytes = checksum.bytes;
    study.files = checksum.files;
    return study;
}

std::string changeOf(const StudyFile& study, const StudyChecksum& now) {
    if (study.checksum.empty() || study.checksum == now.text) return {};
    // Checksums of another algorithm cannot be compared, numbers of bytes can.
    const bool comparable = study.checksum.starts_with("xxh3-128:");
    if (study.files > 0 && study.files != now.files)
        return fmt::format("is read from {} files, and was read from {} when the session was saved", now.files,
                           study.files);
    if (study.bytes > 0 && study.bytes != now.bytes)
        return fmt::format("has {} bytes, and had {} when the session was saved", now.bytes, study.bytes);
    return comparable ? "has other bytes than when the session was saved" : "";
}

std::optional<std::string> findStudy(const StudyFile& study, const StudySearch& search, const Progress& progress) {
    if (study.checksum.empty() || study.bytes <= 0 || study.files <= 0) return std::nullopt;
    Search among(study, progress);
    for (const std::string& path : search.paths)
        if (among.isStudy(path)) return path;
    for (const std::string& folder : search.folders)
        if (!folder.empty())
            if (auto found = among.below(folder)) return found;
    return std::nullopt;
}

}  // namespace echolucent
