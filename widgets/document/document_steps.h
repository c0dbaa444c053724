// The steps from one document to the next that can be undone and done again.
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <deque>
#include <functional>

#include "processing/document/document.h"

namespace echolucent {

/// A chain of states: the first is as the document was begun, and each step leads to one more. Step i, counted from 0,
/// leads from state i to state i + 1. Each state keeps one document, and documents share the lists that did not change.
/// States that take more than their bytes lose the oldest step, again and again; the newest step always stays.
class DocumentSteps : public QObject {
    Q_OBJECT

public:
    /// Makes a kept document the present one.
    using Restore = std::function<void(const Document& document)>;
    /// Some ten thousand steps of all that is small, or sixteen bowed surfaces of the most nodes that a file may have
    /// (1024 by 1024): less than the voxels of a small study.
    static constexpr std::size_t mostBytesKept = 64'000'000;

    explicit DocumentSteps(Restore restore, std::size_t mostBytes = mostBytesKept);

    [[nodiscard]] int count() const { return static_cast<int>(m_states.size()) - 1; }
    /// Of the state shown: so many steps can be undone. From 0 to count().
    [[nodiscard]] int index() const { return m_index; }
    /// Shows the state of an index. An index that is out of range is taken for the nearest one.
    void setIndex(int index);
    void undo() { setIndex(m_index - 1); }
    void redo() { setIndex(m_index + 1); }
    [[nodiscard]] bool canUndo() const { return m_index > 0; }
    [[nodiscard]] bool canRedo() const { return m_index < count(); }
    /// What step i does. An i that is out of range has no text.
    [[nodiscard]] QString text(int step) const;
    [[nodiscard]] QString undoText() const { return text(m_index - 1); }
    [[nodiscard]] QString redoText() const { return text(m_index); }

    /// How many of the oldest steps were dropped since begin(). Then the first state is not as the document was begun.
    [[nodiscard]] int dropped() const { return m_dropped; }
    /// The bytes that all states keep (bytesBeside()), and the most that they may; more only with a single step.
    [[nodiscard]] std::size_t bytes() const { return m_bytes; }
    [[nodiscard]] std::size_t mostBytes() const { return m_mostBytes; }

    /// Forgets all steps: the first state is the one shown.
    void clear();

    // What the model calls. These emit nothing: it shows the document first, and emits changed() then.
    /// Forgets all steps: the first state is `document`.
    void begin(const Document& document);
    /// Adds a step from the state shown, which is now `before`, to `after`; what was undone is forgotten. It becomes
    /// one with the step before it if both have the same text and gesture, and is no step if it leads back to where
    /// that began. Gesture 0 stands alone.
    void push(const Document& before, const Document& after, const QString& what, int gesture);

signals:
    /// Steps were added, undone, done again, forgotten or dropped. The document is that of the state shown.
    void changed();

private:
    struct State {
        Document document;
        QString what;           ///< the step that led here; none led to the first
        int gesture = 0;        ///< of that step
        std::size_t bytes = 0;  ///< beside the state before it
    };
    [[nodiscard]] State& shown() { return m_states[static_cast<std::size_t>(m_index)]; }
    void removeLast();
    /// Measures the last state anew.
    void measureLast();
    void dropOldest();

    Restore m_restore;
    std::size_t m_mostBytes;
    std::deque<State> m_states;  ///< at least one
    int m_index = 0;
    std::size_t m_bytes = 0;
    int m_dropped = 0;
};

}  // namespace echolucent
