#include "io/files/files_below.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/files/input_problems.h"
#include "processing/one_line.h"

namespace echolucent {

namespace {

constexpr std::size_t mostFiles = 50000;
constexpr std::size_t mostEntries = 4 * mostFiles;

/// A name in quotes, fit for a sentence in any script: at most 80 bytes of it, without what no line may hold.
std::string nameInQuotes(const std::string& name) {
    constexpr std::size_t longest = 80;
    return "\"" + oneLine(name, longest) + "\"";
}

/// Counts entries that were left out, for one sentence.
class LeftOut {
public:
    void add(const std::filesystem::path& entry) {
        if (m_count++ == 0) m_first = entry.filename().string();
    }
    void say(const std::string& what, std::vector<std::string>& warnings, const std::string& remedy = "") const {
        if (m_count > 0)
            warnings.push_back(fmt::format("{} {}, {} among them.{}", m_count, what, nameInQuotes(m_first), remedy));
    }

private:
    std::size_t m_count = 0;
    std::string m_first;
};

/// Whether `path` lies in `folder` or below it. Both must be free of links.
bool liesBelow(const std::filesystem::path& folder, const std::filesystem::path& path) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

class Walk {
public:
    Walk(const std::string& folder, int deepest) : m_folder(folder), m_deepest(deepest) {
        std::error_code unknown;
        m_linkFree = std::filesystem::canonical(folder, unknown);
    }

    FilesBelow run(const Progress& progress) {
        std::error_code error;
        if (const std::filesystem::directory_iterator own(m_folder, error); error) {
            m_found.warnings.push_back(
                fmt::format("The folder could not be looked into: {}.", inputProblem(error.value())));
            return std::move(m_found);
        }
        std::filesystem::recursive_directory_iterator entry(
            m_folder, std::filesystem::directory_options::skip_permission_denied, error);
        std::size_t entries = 0;
        for (; !error && !progress.cancelled() && entry != std::filesystem::recursive_directory_iterator();
             entry.increment(error)) {
            if (m_found.paths.size() == mostFiles || ++entries > mostEntries) {
                m_found.warnings.push_back(fmt::format(
                    "There are more than {} files; the others were not looked at. Open a folder further down.",
                    m_found.paths.size() == mostFiles ? mostFiles : mostEntries));
                break;
            }
            take(entry);
        }
        m_deeper.say(fmt::format("folder(s) deeper than {} were not looked into", m_deepest), m_found.warnings,
                     " Open a folder further down.");
        m_closed.say("folder(s) could not be opened: the permission to read them is missing", m_found.warnings);
        m_filesOutside.say("link(s) lead to files out of the folder and were not followed", m_found.warnings,
                           " Copy the files themselves into the folder if they belong here.");
        m_foldersOutside.say("link(s) lead to folders out of this one and were not followed", m_found.warnings,
                             " Copy what they lead to into the folder if it belongs here.");
        m_dangling.say("link(s) lead nowhere", m_found.warnings);
        m_special.say("pipe(s), socket(s) or device(s) were left out", m_found.warnings);
        if (error)
            m_found.warnings.push_back(
                fmt::format("The folder was not read to its end: {}.", inputProblem(error.value())));
        std::sort(m_found.paths.begin(), m_found.paths.end());
        return std::move(m_found);
    }

private:
    void take(std::filesystem::recursive_directory_iterator& entry) {
        std::error_code unknown;
        if (entry->is_symlink(unknown)) {
            takeLink(entry->path());
        } else if (entry->is_directory(unknown)) {
            const std::filesystem::directory_iterator inside(entry->path(), unknown);
            if (unknown) m_closed.add(entry->path());
            if (entry.depth() < m_deepest) return;
            entry.disable_recursion_pending();
            if (!unknown && inside != std::filesystem::directory_iterator()) m_deeper.add(entry->path());
        } else if (entry->is_regular_file(unknown)) {
            m_found.paths.push_back(entry->path().string());
        } else {
            m_special.add(entry->path());
        }
    }

    void takeLink(const std::filesystem::path& link) {
        std::error_code error;
        const std::filesystem::path target = std::filesystem::canonical(link, error);
        if (error) return m_dangling.add(link);
        if (liesBelow(m_linkFree, target)) return;
        if (std::filesystem::is_directory(target, error)) return m_foldersOutside.add(link);
        if (!std::filesystem::is_regular_file(target, error)) return m_special.add(link);
        m_filesOutside.add(link);
    }

    std::string m_folder;
    std::filesystem::path m_linkFree;
    int m_deepest;
    FilesBelow m_found;
    LeftOut m_deeper, m_closed, m_filesOutside, m_foldersOutside, m_dangling, m_special;
};

}  // namespace

FilesBelow walkFilesBelow(const std::string& folder, int deepest, const Progress& progress) {
    return Walk(folder, deepest).run(progress);
}

std::string filesInWords(const std::vector<std::string>& paths) {
    constexpr std::size_t mostNames = 3;
    std::vector<std::string> names;
    for (const std::string& path : paths)
        if (names.size() < mostNames) names.push_back(nameInQuotes(std::filesystem::path(path).filename().string()));
    const std::size_t more = paths.size() - names.size();
    return fmt::format("{}{}", fmt::join(names, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
}

}  // namespace echolucent
