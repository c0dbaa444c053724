#include "io/output/overwriting.h"

#include <sys/stat.h>

#include <map>
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

}  // namespace

Result<void> refuseToOverwrite(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs) {
    std::map<Identity, std::string> present;
    for (const std::string& output : outputs)
        if (const auto identity = identityOf(output)) present.emplace(*identity, output);
    // A folder of slices may hold thousands: they are looked at only where an output is there already.
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

}  // namespace echolucent
