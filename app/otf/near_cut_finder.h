// Looks for the place at which a front opens the fluid, makes the front, tells of it, and offers the way back.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <optional>

#include "app/study/open_study.h"
#include "processing/near_cut/near_cut.h"
#include "widgets/controls/message_bar.h"
#include "widgets/document/document_model.h"
#include "widgets/threads/newest_wins_thread.h"

namespace echolucent {

class NearCutFinder : public QObject {
    Q_OBJECT

public:
    struct Parts {
        DocumentModel& model;
        OpenStudy& openStudy;
        Works& works;
        MessageBar& messages;
    };
    explicit NearCutFinder(const Parts& parts, QObject* parent = nullptr);

    /// Looks in the view that the document shows at the time of the call. Does nothing if no study is open.
    void find();
    /// Tilts the front so that it lies across the view shown, and keeps its depth in the middle of the picture. If
    /// there is none, looks for one: find().
    void fromHere();
    void takeAway();
    /// Tells of the front made on opening, with the way back. Tells nothing if the front is not the one found, or if
    /// another message is shown.
    void tellOpening(const NearCutFinding& finding);
    /// Whether a search runs, in its own thread.
    [[nodiscard]] bool busy() const { return m_thread.busy(); }
    void cancel() { m_thread.cancel(); }

    /// The search function. Tests put in one that ends on command.
    using Search = std::function<std::optional<NearCutFinding>(const Volume&, const Viewpoint&, const Progress&)>;
    void setSearch(Search search) { m_search = std::move(search); }

private:
    /// What a message about a front offers beside itself.
    struct WaysOn {
        std::optional<CutSurface> bowed{};  ///< a bowed front instead
        std::optional<Front> before{};      ///< the front to go back to; empty: there is no way back
        std::optional<int> step{};          ///< place of the step that made the front; empty: it came on opening
    };
    void look();
    void take(const NearCutFinding& finding);
    [[nodiscard]] QList<MessageAction> actions();
    /// Whether going back undoes the step that made the front: no step has been made since.
    [[nodiscard]] bool goesBackByUndo() const;
    void goBack();
    void tell(MessageKind kind, const QString& text, WaysOn ways);
    void showTold();
    /// What a message about a front is true of: it is taken back once any of these values changes.
    struct CutPicture {
        StudyReference study;
        int phase = 0;
        Front front;
        friend bool operator==(const CutPicture&, const CutPicture&) = default;
    };
    [[nodiscard]] CutPicture presentPicture() const;
    void takeBackWhatIsNoLongerTrue();
    /// The place of the newest step among all that were ever made.
    [[nodiscard]] int newestStep() const;
    /// Names the way back anew if it undoes the front's step no more, or does so again.
    void nameWayBack();
    void setFront(const Front& front, const ViewDirection& side);

    Parts m_parts;
    Viewpoint m_looksFrom;
    Front m_frontBefore;  ///< when the newest search began
    Search m_search;
    std::shared_ptr<const Volume> m_searched;  ///< the volume of the newest search
    bool m_told = false;  ///< whether the newest message, true of m_toldPicture, may still be shown
    MessageKind m_toldKind = MessageKind::info;
    QString m_toldText;
    WaysOn m_ways;          ///< of the newest message
    bool m_undoes = false;  ///< whether its way back was shown as an undo
    CutPicture m_toldPicture;
    // Last, so that its thread has ended before anything above is destroyed.
    NewestWinsThread m_thread;
};

}  // namespace echolucent
