// The steps from one document to the next, with undo and redo.
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>

#include "processing/document/document.h"

namespace echolucent {

/// A chain of states. The first is the document at the beginning, each step leads to one more: step i, counted from 0,
/// leads from state i to state i + 1. Each state keeps one document. Documents share the lists that did not change. If
/// the states take too many bytes, the oldest steps are dropped. The newest step always stays.
class DocumentSteps : public QObject {
    Q_OBJECT

public:
    /// Makes a kept document the present one: also the shown phase and the motion's frame, if `withFrame`.
    using Restore = std::function<void(const Document& document, bool withFrame)>;
    /// Enough for some ten thousand steps without large lists, or for fifteen curved cuts with the most nodes that a
    /// file may have (1024 by 1024). Less than the voxels of a small study.
    static constexpr std::size_t mostBytesKept = 64'000'000;

    explicit DocumentSteps(Restore restore, std::size_t mostBytes = mostBytesKept);

    [[nodiscard]] int count() const { return static_cast<int>(m_states.size()) - 1; }
    /// Index of the state shown, from 0 to count(). It is also the number of steps that can be undone.
    [[nodiscard]] int index() const { return m_index; }
    /// Shows the state of an index, or the nearest state if `index` is out of range. On the way over steps that have
    /// set the frame (push()), phase and frame come back as they were beyond the last of these.
    void setIndex(int index);
    void undo() { setIndex(m_index - 1); }
    void redo() { setIndex(m_index + 1); }
    [[nodiscard]] bool canUndo() const { return m_index > 0; }
    [[nodiscard]] bool canRedo() const { return m_index < count(); }
    /// What step i does; empty if i is out of range.
    [[nodiscard]] QString text(int step) const;
    [[nodiscard]] QString undoText() const { return text(m_index - 1); }
    [[nodiscard]] QString redoText() const { return text(m_index); }

    /// The number of steps dropped since begin() or clear(). If above 0, the first state is not the document at the
    /// beginning.
    [[nodiscard]] int dropped() const { return m_dropped; }
    /// The bytes of all states (bytesBeside()), and their limit. Only a single step may exceed the limit.
    [[nodiscard]] std::size_t bytes() const { return m_bytes; }
    [[nodiscard]] std::size_t mostBytes() const { return m_mostBytes; }
    /// Limits the bytes from the next step on. Tests of a whole window use it.
    void setMostBytes(std::size_t bytes) { m_mostBytes = bytes; }

    /// Forgets all steps. The shown state becomes the first.
    void clear();

    /// All steps, to come back to them.
    struct Kept;
    [[nodiscard]] std::shared_ptr<const Kept> keep() const;

    // Only the model calls begin(), comeBack() and push(). They emit nothing: the model shows the document first, then
    // emits changed().
    /// Forgets all steps. `document` becomes the first state.
    void begin(const Document& document);
    /// The steps become those that keep() gave.
    void comeBack(const Kept& kept);
    /// Adds a step to `after`. The state shown becomes `before`. Steps that were undone are forgotten. If the step that
    /// led to the shown state has the same text and gesture, both become one, from where that step began. If they then
    /// change nothing but phase and frame, the step is dropped. A step with gesture 0 is never joined. `setsFrame`:
    /// undo and redo bring back the shown phase and the motion's frame too.
    void push(const Document& before, const Document& after, const QString& what, int gesture, bool setsFrame = false);

signals:
    /// Steps were added, undone, redone, forgotten or dropped. The document is already that of the shown state.
    void changed();

private:
    struct State {
        Document document;
        QString what;            ///< name of the step that led here; empty for the first
        int gesture = 0;         ///< of that step
        std::size_t bytes = 0;   ///< bytesBeside() the state before it
        bool setsFrame = false;  ///< whether that step has set the shown phase and the motion's frame
    };
    [[nodiscard]] State& shown() { return m_states[static_cast<std::size_t>(m_index)]; }
    void removeLast();
    void measureLast();
    void dropOldest();

    Restore m_restore;
    std::size_t m_mostBytes;
    std::deque<State> m_states;  ///< at least one
    int m_index = 0;
    std::size_t m_bytes = 0;
    int m_dropped = 0;
};

struct DocumentSteps::Kept {
    std::deque<State> states;
    int index = 0;
    std::size_t bytes = 0;
    int dropped = 0;
};

}  // namespace echolucent
