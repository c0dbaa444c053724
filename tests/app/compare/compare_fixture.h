// The window compares panes of a small simulated scan, for tests.
#pragma once

#include <QComboBox>
#include <QMouseEvent>

#include "app/compare/compare_room.h"
#include "processing/document/panes.h"
#include "tests/app/window_fixture.h"
#include "widgets/compare/compare_grid.h"
#include "widgets/compare/compare_panel.h"

namespace echolucent {

/// One test's window at a time, as WindowFixture.
class CompareFixture : protected WindowFixture {
protected:
    void makeFiles() {
        m_file = file("still.mha", {smallPhantom(PhantomScene::shapes, 5)});
        m_moving =
            file("moving.mha", {smallPhantom(PhantomScene::shapes, 5), smallPhantom(PhantomScene::shapes, 5, 0.5)});
    }
    /// The window compares the still scan, converged: these panes, or the four standard ones.
    void begin(const std::vector<Pane>& panes = {}) {
        show();
        useLook(Look{});
        open(m_file);
        // Panes of its own would show the comparison, and open() waits for the 3D picture.
        if (!panes.empty()) window().document().begin(withPanes(document(), panes));
        window().compareRoom().setShown(true);
        waitForFrame();
    }
    [[nodiscard]] const Document& document() { return window().document().document(); }
    CompareGrid& grid() { return *child<CompareGrid>("compare.panes"); }
    [[nodiscard]] const std::vector<QImage>& images() { return window().compareRoom().views().images(); }
    ComparePanel& panel() { return *child<ComparePanel>("compare"); }
    void waitForFrame() {
        const auto& views = window().compareRoom().views();
        QTRY_VERIFY_WITH_TIMEOUT(window().idle() && views.frame() && views.frame()->converged(), 30000);
    }
    void waitUntilRest() { QTRY_VERIFY_WITH_TIMEOUT(window().idle(), 60000); }
    static void choose(QComboBox* box, int index) {
        box->setCurrentIndex(index);
        emit box->activated(index);
    }
    static void sendMove(QWidget& widget, const QPoint& place, Qt::MouseButton button,
                         Qt::KeyboardModifiers modifiers = {}) {
        QMouseEvent move(QEvent::MouseMove, place, widget.mapToGlobal(place), Qt::NoButton, button, modifiers);
        QApplication::sendEvent(&widget, &move);
    }
    static void drag(QWidget& widget, const QPoint& from, const QPoint& by, Qt::MouseButton button,
                     Qt::KeyboardModifiers modifiers = {}) {
        QTest::mousePress(&widget, button, modifiers, from);
        for (int part = 1; part <= 4; ++part) sendMove(widget, from + by * part / 4, button, modifiers);
        QTest::mouseRelease(&widget, button, modifiers, from + by);
    }

    QString m_file, m_moving;
};

}  // namespace echolucent
