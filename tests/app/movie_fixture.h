// Movies and series of pictures in the real main window: their studies, their dialog, and a folder to write to.
#pragma once

#include <QCheckBox>
#include <QDialog>
#include <QLineEdit>
#include <QPushButton>
#include <vector>

#include "app/motion/movie_files.h"
#include "tests/app/window_fixture.h"
#include "widgets/controls/message_bar.h"

namespace echolucent {

class MovieFixture : public WindowFixture {
public:
    static constexpr int phaseCount = 4;

    void writeStudies() {
        for (int i = 0; i < phaseCount; ++i)
            m_phases.push_back(smallPhantom(PhantomScene::fetus, static_cast<std::uint64_t>(7 + i), 0.25 * i));
        m_moving = file("moving.mha", m_phases);
        m_still = file("still.mha", {m_phases.front()});
    }
    /// Shows the window, and makes an empty folder beside it.
    void showWindow() {
        m_out = std::make_unique<QTemporaryDir>();
        QVERIFY(m_out->isValid());
        show();
        window().resize(1280, 720);
        useLook(Look{});
    }
    [[nodiscard]] const std::vector<std::shared_ptr<const Volume>>& phases() const { return m_phases; }
    [[nodiscard]] const QString& moving() const { return m_moving; }
    /// The first phase alone, whose swivel has 180 frames.
    [[nodiscard]] const QString& still() const { return m_still; }
    [[nodiscard]] const QTemporaryDir& out() const { return *m_out; }
    void playThePhases() {
        Document next = window().document().document();
        next.motion.scenario = MotionScenario::object;
        next.motion.otf = MotionOtf::eachView;
        window().document().edit(next, "what moves");
        waitUntilIdle();
    }
    QDialog* theDialog() {
        auto* dialog = window().findChild<QDialog*>("movieDialog");
        if (dialog == nullptr || !QTest::qWaitForWindowExposed(dialog)) qFatal("no dialog");
        // A virtual display has no window manager to activate the dialog, but fields have a focus only in the active
        // window.
        QApplication::setActiveWindow(dialog);
        return dialog;
    }
    template <typename Widget>
    static Widget* in(QDialog* dialog, const char* name) {
        auto* found = dialog->findChild<Widget*>(QStringLiteral("movieDialog.") + name);
        if (found == nullptr) qFatal("no %s", name);
        return found;
    }
    template <typename SpinBox>
    static void type(SpinBox* box, const QString& value) {
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, value);
        QTest::keyClick(box, Qt::Key_Tab);
    }
    static void write(QLineEdit* field, const QString& text) {
        field->setFocus();
        field->selectAll();
        QTest::keyClick(field, Qt::Key_Delete);
        QTest::keyClicks(field, text);
    }
    static void tick(QCheckBox* box) { QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2)); }
    /// Clicks Save and waits until all is written.
    bool save(QDialog* dialog) {
        QSignalSpy told(&window().movieFiles(), &MovieFiles::ended);
        QTest::mouseClick(in<QPushButton>(dialog, "save"), Qt::LeftButton);
        return (told.count() > 0 || told.wait(60000)) && told.first().first().toBool();
    }
    /// Waits until writing has ended, and returns whether the files were written.
    bool ended() {
        QSignalSpy told(&window().movieFiles(), &MovieFiles::ended);
        return told.wait(60000) && told.first().first().toBool();
    }
    MessageBar* message() { return child<MessageBar>("message"); }

private:
    std::vector<std::shared_ptr<const Volume>> m_phases;
    QString m_moving, m_still;
    std::unique_ptr<QTemporaryDir> m_out;
};

}  // namespace echolucent
