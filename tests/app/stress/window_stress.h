// Actions by chance in the real window, and what must hold after any of them.
#pragma once

#include <QElapsedTimer>
#include <QFile>
#include <QObject>
#include <optional>
#include <string>
#include <vector>

#include "app/window/main_window.h"
#include "tests/app/stress/random_choice.h"
#include "tests/app/stress/stress_files.h"
#include "tests/app/stress/stress_part.h"
#include "tests/app/stress/window_checks.h"
#include "tests/app/stress/window_hand.h"

namespace echolucent {

class WindowStress : public QObject {
public:
    /// `log` gets each action's number and name, as it is begun: it is complete even where the program crashes.
    WindowStress(MainWindow& window, const StressFiles& files, std::uint64_t seed, const QString& log);

    /// Adds the actions of a part, which must outlive this object. After so many actions the run waits, and all is
    /// checked.
    void add(StressPart& part, int actionsBetweenRests);
    [[nodiscard]] WindowHand& hand() { return m_hand; }
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
    [[nodiscard]] std::vector<StressAction> actionsOfEveryRun();

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
    QString dragInterrupted(RandomChoice& choice);

    [[nodiscard]] DocumentModel& model() { return m_window.document(); }
    [[nodiscard]] int phases() const;
    /// The document as bytes, without what is no step: without the panes that are only looked at, too.
    [[nodiscard]] std::string bytes() const;
    [[nodiscard]] std::string bytesOf(const Document& document) const {
        return echolucent::bytesOf(m_window, document);
    }
    [[nodiscard]] QString sessionFile(int number) const;
    /// What must hold of the document and what shows it, at rest.
    [[nodiscard]] QString checkRest();
    /// Waits, and checks all that must hold, also of the part.
    void checkAll(RandomChoice& choice);
    /// Notes a problem; the first one counts.
    void fail(const QString& problem);
    void tell(const QString& line);

    MainWindow& m_window;
    StressFiles m_files;
    std::uint64_t m_seed;
    WindowHand m_hand;
    QFile m_log;
    QElapsedTimer m_clock;  ///< since the run began
    QString m_said;         ///< by the bar of messages, after the action before
    std::vector<StressAction> m_actions = actionsOfEveryRun();
    StressPart* m_part = nullptr;
    int m_actionsBetweenRests = 0;
    Document m_first;                 ///< of a first start
    QByteArray m_layout;              ///< of the window
    std::optional<Document> m_begun;  ///< as the open study's document was begun
    bool m_allStepsKept = false;
    QString m_problem;
};

}  // namespace echolucent
