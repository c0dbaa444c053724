// Actions by chance in the real window, and what must hold after any of them.
#pragma once

#include <QFile>
#include <QObject>
#include <QStringList>
#include <optional>
#include <string>
#include <vector>

#include "app/window/main_window.h"
#include "tests/app/stress/random_choice.h"
#include "tests/app/stress/window_hand.h"

namespace echolucent {

/// What is opened meanwhile.
struct StressFiles {
    QStringList studies;   ///< that can be opened
    QStringList failures;  ///< that are missing or broken
    QString folder;        ///< for sessions, pictures and pages that are saved
};

class WindowStress : public QObject {
public:
    /// `log` gets each action's number and name, as it is begun: it is complete even where the program crashes.
    WindowStress(MainWindow& window, const StressFiles& files, std::uint64_t seed, const QString& log);

    /// All steps since the last opening are kept: undo leads to its document then.
    void expectAllSteps() { m_allStepsKept = true; }
    /// Does these actions. The problem found, or an empty text.
    [[nodiscard]] QString run(int first, int end);
    /// Pauses what plays, and waits until the window is at rest. The problem, or an empty text.
    [[nodiscard]] QString rest();
    /// Undoes and does again all steps. The problem, or an empty text.
    [[nodiscard]] QString checkSteps();
    /// Makes the window as it was begun: no comparison, no dialog, the simulated scan with the document of a first
    /// start, without steps.
    [[nodiscard]] QString beginAnew();

private:
    struct Action {
        const char* name;
        int weight;
        QString (WindowStress::*run)(RandomChoice&);
    };
    static const std::vector<Action>& actions();

    QString edit(RandomChoice& choice);
    QString preview(RandomChoice& choice);
    QString undo(RandomChoice& choice);
    QString redo(RandomChoice& choice);
    QString jump(RandomChoice& choice);
    QString showPhase(RandomChoice& choice);
    QString play(RandomChoice& choice);
    QString compare(RandomChoice& choice);
    QString open(RandomChoice& choice);
    QString openWhatFails(RandomChoice& choice);
    QString openSession(RandomChoice& choice);
    QString openSimulatedScan(RandomChoice& choice);
    QString cancel(RandomChoice& choice);
    QString saveSession(RandomChoice& choice);
    QString saveOther(RandomChoice& choice);
    QString waitForRest(RandomChoice& choice);
    QString undoAll(RandomChoice& choice);
    QString drag(RandomChoice& choice) { return m_hand.drag(choice); }
    QString dragInterrupted(RandomChoice& choice);
    QString turnWheel(RandomChoice& choice) { return m_hand.turnWheel(choice); }
    QString doubleClick(RandomChoice& choice) { return m_hand.doubleClick(choice); }
    QString pressKeys(RandomChoice& choice) { return m_hand.pressKeys(choice); }
    QString turnControl(RandomChoice& choice) { return m_hand.turnControl(choice); }
    QString raisePanel(RandomChoice& choice) { return m_hand.raisePanel(choice); }
    QString triggerAction(RandomChoice& choice) { return m_hand.triggerAction(choice); }
    QString askAndDismiss(RandomChoice& choice) { return m_hand.askAndDismiss(choice); }

    [[nodiscard]] DocumentModel& model() { return m_window.document(); }
    [[nodiscard]] int phases() const;
    /// The document as bytes, without what is no step: without the panes that are only looked at, too.
    [[nodiscard]] std::string bytes() const;
    [[nodiscard]] std::string bytesOf(Document document) const;
    [[nodiscard]] QString sessionFile(int number) const;
    [[nodiscard]] QString underWay() const;
    /// What must hold of the document and what shows it, at rest.
    [[nodiscard]] QString checkRest();
    /// Whether the document is the same once it was written and read.
    [[nodiscard]] QString checkReading() const;
    /// Notes a problem; the first one counts.
    void fail(const QString& problem);
    void tell(const QString& line);

    MainWindow& m_window;
    StressFiles m_files;
    std::uint64_t m_seed;
    WindowHand m_hand;
    QFile m_log;
    Document m_first;                 ///< of a first start
    QByteArray m_layout;              ///< of the window
    std::optional<Document> m_begun;  ///< as the open study's document was begun
    bool m_allStepsKept = false;
    QString m_problem;
};

}  // namespace echolucent
