#include "io/output/overwriting.h"

#include <sys/stat.h>

#include <map>
#include <mutex>
#include <optional>
#include <utility>

namespace echolucent {

namespace {

using Identity = std::pair<dev_t, ino_t>;

std::optional<Identity> identityOf(const std::string& path) {
    struct stat status {};
    if (path.empty() || path == "-" || stat(path.c_str(), &status) != 0) return std::nullopt;
    return Identity(status.st_dev, status.st_ino);
}

struct Kept {
    std::vector<std::string> files;
    OutputKind kind = OutputKind::other;
};

/// The kept files of the process, for all threads.
struct AllKept {
    std::mutex mutex;
    std::vector<std::weak_ptr<const Kept>> list;
};

AllKept& allKept() {
    static AllKept all;
    return all;
}

}  // namespace

Result<void> refuseToOverwrite(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs) {
    std::map<Identity, std::string> present;
    for (const std::string& output : outputs)
        if (const auto identity = identityOf(output)) present.emplace(*identity, output);
    // There may be thousands of inputs, slices in a folder. They are compared only if an output exists already.
    if (present.empty()) return {};
    for (const std::string& input : inputs) {
        const auto identity = identityOf(input);
        if (!identity) continue;
        if (const auto same = present.find(*identity); same != present.end())
            return fail(FailureKind::wrongUsage, same->second, "",
                        "would overwrite \"" + input + "\", which is an input", "Give the output a name of its own.");
    }
    return {};
}

KeptFiles::KeptFiles(std::vector<std::string> files, OutputKind kind) {
    const auto kept = std::make_shared<const Kept>(Kept{std::move(files), kind});
    m_kept = kept;
    AllKept& all = allKept();
    const std::lock_guard lock(all.mutex);
    std::erase_if(all.list, [](const auto& entry) { return entry.expired(); });
    all.list.push_back(kept);
}

void keepFromOverwriting(std::vector<std::string> files, OutputKind kind) {
    // Never destroyed, because a thread may write until the process ends.
    static auto& forGood = *new std::vector<KeptFiles>;
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    forGood.emplace_back(std::move(files), kind);
}

Result<void> refuseToOverwriteKept(const std::string& output, OutputKind kind) {
    std::vector<std::shared_ptr<const Kept>> present;
    {
        AllKept& all = allKept();
        const std::lock_guard lock(all.mutex);
        for (const auto& entry : all.list)
            if (auto kept = entry.lock()) present.push_back(std::move(kept));
    }
    for (const auto& kept : present) {
        if (kind != OutputKind::other && kept->kind == kind) continue;
        if (auto allowed = refuseToOverwrite(kept->files, {output}); !allowed) return allowed;
    }
    return {};
}

}  // namespace echolucent
