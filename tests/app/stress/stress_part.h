// What one kind of run adds to the actions by chance.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <vector>

#include "tests/app/stress/random_choice.h"

namespace echolucent {

struct StressAction {
    const char* name;
    int weight;  ///< how often it is chosen, against the weights of all others
    /// Returns what was done, for the log; an empty text if there was nothing to do it with.
    std::function<QString(RandomChoice&)> run;
};

/// Actions beside those of every run, and what must hold of them.
class StressPart : public QObject {
public:
    [[nodiscard]] virtual std::vector<StressAction> actions() = 0;
    /// What does not hold while the window rests; it may change the document and take that back. Empty if all holds.
    [[nodiscard]] virtual QString problemAtRest() { return {}; }
    /// The window is about to be made as it was begun.
    virtual void end() {}
    /// The first thing that did not hold, in whatever state the window was. Empty if all held.
    [[nodiscard]] const QString& problem() const { return m_problem; }

protected:
    void fail(const QString& problem) {
        if (m_problem.isEmpty()) m_problem = problem;
    }

private:
    QString m_problem;
};

}  // namespace echolucent
