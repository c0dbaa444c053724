// What a person does in the comparison, by chance.
#pragma once

#include "app/window/main_window.h"
#include "tests/app/stress/stress_files.h"
#include "tests/app/stress/stress_part.h"
#include "tests/app/stress/window_hand.h"

namespace echolucent {

/// Panes and their parameters, figures, captions, insets, tube cores, motions, snapshots, files and the full screen.
class CompareActions : public StressPart {
public:
    /// Window and hand must outlive this object.
    CompareActions(MainWindow& window, WindowHand& hand, const StressFiles& files);

    [[nodiscard]] std::vector<StressAction> actions() override;
    /// A snapshot, a session's file and each figure come back byte for byte.
    [[nodiscard]] QString problemAtRest() override;
    void end() override;

private:
    QString show(RandomChoice& choice);
    QString changePanes(RandomChoice& choice);
    QString open(RandomChoice& choice);
    QString showFigure(RandomChoice& choice);
    QString answerMessage(RandomChoice& choice);
    QString focusPane(RandomChoice& choice);
    QString explain(RandomChoice& choice);
    QString turnMotion(RandomChoice& choice);
    QString chooseTubeCore(RandomChoice& choice);
    QString compareWithoutIt(RandomChoice& choice);
    QString saveFile(RandomChoice& choice);
    QString keepSnapshot(RandomChoice& choice);
    QString returnToSnapshot(RandomChoice& choice);
    QString switchFullScreen(RandomChoice& choice);
    QString chooseFace(RandomChoice& choice);

    [[nodiscard]] QString problemOfSnapshots();
    [[nodiscard]] QString problemOfSession();
    [[nodiscard]] QString problemOfFigure();

    MainWindow& m_window;
    WindowHand& m_hand;
    QStringList m_studies;
    QString m_folder;
    int m_rests = 0;  ///< so far
};

}  // namespace echolucent
