// What takes long in the window, and which of it the status line shows.
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace echolucent {

class RunStatus;

/// Works in the order of what a person waits for most: of several that run, the status line shows the first, with its
/// progress, and its cancel ends that one.
class LongWorks : public QObject {
    Q_OBJECT

public:
    struct Work {
        std::function<bool()> busy;
        std::function<QString()> words;  ///< what is done, as "loading"
        std::function<void()> cancel;
    };

    /// The status line outlives this.
    explicit LongWorks(RunStatus& status, QObject* parent = nullptr);

    /// Adds a work that is shown where none of those added before it runs, and returns its number. What its functions
    /// refer to outlives this.
    std::size_t add(Work work);
    /// To be called whenever something begins or ends.
    void follow();
    /// How much of a work is done, a share from 0 to 1.
    void setProgress(std::size_t work, double share);

private:
    [[nodiscard]] std::optional<std::size_t> shown() const;

    RunStatus& m_status;
    std::vector<Work> m_works;
};

}  // namespace echolucent
