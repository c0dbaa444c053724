// What Escape ends, and in which order.
#pragma once

#include <functional>
#include <map>
#include <vector>

namespace echolucent {

/// In the order in which one press of Escape after the other ends them. A control that has the focus is asked before.
enum class EscapeStep { drag, lasso, maximisedPane, fullScreen };

/// Ends the first of what goes on. Whoever begins something that Escape ends adds how it ends.
class EscapeOrder {
public:
    /// `end` returns whether there was anything to end. What it refers to outlives this.
    void add(EscapeStep step, std::function<bool()> end) { m_ends[step].push_back(std::move(end)); }
    /// False where nothing was to be ended.
    bool endFirst() {
        for (const auto& [step, ends] : m_ends)
            for (const std::function<bool()>& end : ends)
                if (end()) return true;
        return false;
    }

private:
    std::map<EscapeStep, std::vector<std::function<bool()>>> m_ends;
};

}  // namespace echolucent
