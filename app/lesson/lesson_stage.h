// What of the window a lesson uses, and gives back: places of panels, letters, layout, and state that no document
// holds.
#pragma once

#include <QList>
#include <QObject>
#include <QPointer>
#include <optional>

#include "processing/theory/contrast_course.h"
#include "widgets/larger_letters.h"
#include "widgets/lesson/kept_in_sight.h"
#include "widgets/lesson/lesson_outline.h"
#include "widgets/planes/pane_grid.h"

class QAbstractButton;
class QDockWidget;
class QMainWindow;

namespace echolucent {

class LessonsPanel;
class TheoryPanel;
class TubeCoreChoice;

/// While a lesson is played, its panel stands left of the picture, so that its words are seen beside any other panel.
/// On the full screen the panel stays, in letters that the last row of a class can read, and beside it stand only the
/// picture, the bars below it, and the panel that the step looks at, in such letters too.
class LessonStage : public QObject {
    Q_OBJECT

public:
    struct Parts {
        QMainWindow& window;
        LessonsPanel& panel;
        PaneGrid& panes;
        TubeCoreChoice& tubeCore;
        TheoryPanel& theory;
        QAbstractButton& insets;  ///< whether each compared pane shows its OTF
        QList<QWidget*> bars;     ///< below the picture; the full screen hides them, and a lesson speaks of them
        QWidget& controls;        ///< the panel that is in front beside a lesson, until a step looks at another one
    };
    /// What the parts refer to must outlive this object.
    explicit LessonStage(const Parts& parts, QObject* parent = nullptr);

    /// A lesson begins: keeps what it may change, and sets that as at a first start.
    void enter();
    /// The lesson has ended. Gives back what enter() kept, and puts the panel back beside the others.
    void leave();

    /// A step begins: brings the control that it looks at into view, with the panel that it stands in, and outlines it.
    /// An empty name, or one that nothing has, outlines nothing.
    void beginStep(const QString& lookAt);
    /// Sets what no document holds as it was when the step began.
    void resetStep();
    /// The window is about to leave the full screen: all gets the letters that it had before.
    void leaveFullScreen();
    /// The window shows the picture alone on the whole screen, or no longer.
    void fullScreenChanged(bool full);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// Where the panel was before the lesson.
    struct Place {
        Qt::DockWidgetArea area = Qt::RightDockWidgetArea;
        bool hidden = false;
        QPointer<QDockWidget> beside;  ///< a panel behind whose tab it was
    };
    /// Not in the document.
    struct Before {
        PaneLayout layout = PaneLayout::only3d;
        bool tubeCoresShown = false;
        TheorySetting theory;
        bool insets = false;
        int columnWidth = 0;  ///< of the panels beside the picture, pixels
    };
    void lookAt(const QString& name);
    void standAside();
    void standBack();
    void takeLentBut(const QWidget* target);
    void setWidth();
    void fitLetters();
    [[nodiscard]] QDockWidget* dock() const;
    [[nodiscard]] QDockWidget* lookedAt() const;

    Parts m_parts;
    std::optional<Place> m_place;
    std::optional<Before> m_before;
    TheorySetting m_stepTheory;             ///< when the step began
    QList<QPointer<QDockWidget>> m_opened;  ///< panels that a step has shown, and that were closed before
    QList<QPointer<QWidget>> m_lent;        ///< what a step shows on the full screen, beside the picture
    bool m_fullScreen = false;
    LessonOutline m_outline;
    KeptInSight m_sight;
    LargerLetters m_letters, m_lookedAtLetters;  ///< of the lesson's panel, and of the one that the step looks at
    double m_sizedFor = 0.0;                     ///< letters for which panels have their widths; 0: none
    QPointer<QDockWidget> m_sizedBeside;         ///< the panel beside the picture that has its width
};

}  // namespace echolucent
