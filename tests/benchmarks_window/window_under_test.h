// The workstation's real window with a 3D view of exactly the size to measure, and the hand that moves it.
#pragma once

#include <QList>

#include "tests/benchmarks_window/measures.h"
#include "tests/benchmarks_window/open_window.h"
#include "widgets/panels/motion_panel.h"

namespace echolucent::bench {

class WindowUnderTest : private OpenWindow {
public:
    /// Opens the volume in the window with a picture of edge x edge device pixels. The volume fills two thirds of it.
    WindowUnderTest(const QString& volume, int edge, bool shaded);

    [[nodiscard]] OpacityCurve adaptiveCurve() const;
    /// Shows a curve and waits for the converged picture.
    void showCurve(const OpacityCurve& curve);

    /// Turns the view by a degree with each mouse event. There is always one event more than pictures on the screen,
    /// because the hand does not wait.
    [[nodiscard]] Row orbit(const Amount& amount);
    /// Shows another curve for each picture on the screen. The camera rests.
    [[nodiscard]] Row edit(const OpacityCurve& curve, const Amount& amount);
    /// Moves the light with each mouse event, as orbit() moves the view.
    [[nodiscard]] Row turnLight(const Amount& amount);
    /// Moves a slider of the panels to and fro in the middle of its range, as orbit() moves the view. The document, and
    /// with it the curve that it shows, follows.
    [[nodiscard]] Row slide(const QString& slider, const QString& action, const Amount& amount);
    /// Times the way from a jump to another view to the high-quality picture on the screen.
    [[nodiscard]] Row highQuality(const Amount& amount);
    /// Edits the manual curve of the document, which the 3D view shows, and undoes it, so many times: each from the
    /// edit, or the undo, of a picture at rest to the first drawn picture that has it. "edit in document", "undo in
    /// document".
    [[nodiscard]] QList<Row> editDocument(int edits);
    [[nodiscard]] int phases() const;
    /// Plays a 4D study, each phase with its own OTF, as fast as it goes. "first turn" is the first time round, from
    /// the first phase on. "later turns" last until every picture is kept and fine. "from memory" is measured from then
    /// on. Rates are those of phases on the screen.
    [[nodiscard]] QList<Row> playPhases(const Amount& amount);
    /// The pictures of the motion in memory when playPhases() ended.
    [[nodiscard]] const KeptMotion& kept() const { return m_kept; }
    /// Saves what is on the screen in motion and at rest.
    void takePictures(const QString& folder, const QString& name);

private:
    void setPictureEdge(int edge);
    void fillTwoThirds();
    template <typename Change>
    Row follow(const Amount& amount, const Change& change);
    template <typename Enough>
    Row record(const Enough& enough);
    /// Drags on and on: the hand does not wait for the picture.
    Row drag(Qt::KeyboardModifiers keys, const Amount& amount);
    void moveHand(Qt::KeyboardModifiers keys);
    /// Milliseconds from the beginning of a change to the first drawn picture that has it; rests then.
    template <typename Change>
    double timeToPicture(const Change& change);

    QPointF m_hand;
    KeptMotion m_kept;
};

}  // namespace echolucent::bench
