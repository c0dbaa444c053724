// What a person does in a lesson, by chance.
#pragma once

#include <optional>
#include <string>

#include "app/settings/face.h"
#include "app/window/main_window.h"
#include "tests/app/stress/stress_files.h"
#include "tests/app/stress/stress_part.h"
#include "tests/app/stress/window_hand.h"

namespace echolucent {

/// The lessons that come with the program, on small scans: entered, played, left, and whatever a class does meanwhile.
/// Whenever a lesson is left, the person's own document, steps, snapshots and session are as they were, byte for byte.
class LessonActions : public StressPart {
public:
    /// Window and hand must outlive this object.
    LessonActions(MainWindow& window, WindowHand& hand, const StressFiles& files);

    [[nodiscard]] std::vector<StressAction> actions() override;
    [[nodiscard]] QString problemAtRest() override;
    void end() override;

private:
    QString enter(RandomChoice& choice);
    QString open(RandomChoice& choice);
    QString answer(RandomChoice& choice);
    QString leave(RandomChoice& choice);
    QString closePanel(RandomChoice& choice);
    QString chooseFace(RandomChoice& choice);
    QString compare(RandomChoice& choice);
    QString showFigure(RandomChoice& choice);
    QString keepSnapshot(RandomChoice& choice);
    QString switchFullScreen(RandomChoice& choice);
    QString chooseTubeCore(RandomChoice& choice);

    /// A person's own work, as the window has it now.
    struct Own {
        const Study* study = nullptr;  ///< compared by address only
        Document document;
        std::string bytes;
        int steps = 0, index = 0;
        std::size_t snapshots = 0;
        QString session;
        friend bool operator==(const Own&, const Own&) = default;
    };
    [[nodiscard]] Own ownNow();
    void checkWhatCameBack();

    MainWindow& m_window;
    WindowHand& m_hand;
    QStringList m_studies;
    std::optional<Own> m_leaving;  ///< before the study that replaces it is there
    std::optional<Own> m_own;      ///< before the lesson that is played
    int m_rests = 0;               ///< so far
};

}  // namespace echolucent
