// The steps from one document to the next that can be undone and done again.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <vector>

#include "processing/document/document.h"

namespace echolucent {

/// A chain of states: the first is as the document was begun, and each step leads to one more. Step i, counted from 0,
/// leads from state i to state i + 1, and each state keeps one document.
class DocumentSteps : public QObject {
    Q_OBJECT

public:
    /// Makes a kept document the present one.
    using Restore = std::function<void(const Document& document)>;

    explicit DocumentSteps(Restore restore, QObject* parent = nullptr);

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

    /// Forgets all steps: the first state is `document`.
    void begin(const Document& document);
    /// Forgets all steps: the first state is the one shown.
    void clear() { begin(Document(m_states[static_cast<std::size_t>(m_index)].document)); }
    /// Adds a step from the state shown, which is now `before`, to `after`; what was undone is forgotten. It becomes
    /// one with the step before it if both have the same text and gesture, and is no step if it leads back to where
    /// that began. Gesture 0 stands alone. Emits nothing: whoever pushes shows `after` first and emits changed() then.
    void push(const Document& before, const Document& after, const QString& what, int gesture);

signals:
    /// Steps were added, undone, done again or forgotten. The document is that of the state shown.
    void changed();

private:
    struct State {
        Document document;
        QString what;     ///< the step that led here; none led to the first
        int gesture = 0;  ///< of that step
    };

    Restore m_restore;
    std::vector<State> m_states{State{}};
    int m_index = 0;
};

}  // namespace echolucent
