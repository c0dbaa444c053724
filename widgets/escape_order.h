// What Escape ends, and in which order.
#pragma once

#include <functional>
#include <map>
#include <vector>

namespace echolucent {

/// The steps, in the order in which one press of Escape after the other ends them. A control that has the focus is
/// asked before.
enum class EscapeStep { drag, lasso, maximisedPane, fullScreen };

/// Ends the first thing that goes on, in the order of EscapeStep. Whoever begins something that Escape ends says by
/// add() how it is ended.
class EscapeOrder {
public:
    /// `end` ends something and returns true, or returns false if there was nothing to end. What `end` refers to
    /// outlives this object.
    void add(EscapeStep step, std::function<bool()> end) { m_ends[step].push_back(std::move(end)); }
    /// False if there was nothing to end.
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
