// The real main window for a test class: phantoms in files, opening, waiting for the picture, finding controls.
#pragma once

#include <QAbstractButton>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QWindow>
#include <memory>

#include "app/settings/settings.h"
#include "app/window/main_window.h"
#include "io/writers/meta_image_writer.h"
#include "processing/phantom/phantom.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/controls/message_bar.h"
#include "widgets/otf_editor/otf_editor.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

inline std::shared_ptr<const Volume> smallPhantom(PhantomScene scene, std::uint64_t seed, double phase = 0) {
    PhantomConfig config = defaultPhantom(scene);
    config.size = {60, 56, 58};
    config.spacing = Vec3(1.4, 1.4, 1.4);
    config.seed = seed;
    config.phase = phase;
    return std::make_shared<const Volume>(*makePhantom(config));
}

/// Turns the window's document to another direction, as if by hand.
inline void lookFrom(MainWindow& window, const Viewpoint& view) {
    Document next = window.document().document();
    next.scene.pose.direction = directionOf(view);
    window.document().edit(next, "turn view");
}

class WindowFixture {
public:
    /// Writes a study of these phases and returns its file.
    QString file(const QString& name, const std::vector<std::shared_ptr<const Volume>>& phases) {
        const QString path = m_folder.filePath(name);
        if (!writeMetaImage(path.toStdString(), phases)) qFatal("%s", qPrintable(path));
        return path;
    }
    /// Shows the window of a first start with the given look. A plain look neither reduces speckle nor adds light, so
    /// that pictures come to rest sooner. A person gets lookAtStart().
    void show(const Look& look = {}) {
        QFile::remove(settingsFile());
        QDir(temporaryFolder().filePath("settings-data")).removeRecursively();
        if (look != lookAtStart()) Settings(settingsFile()).setLook(look);
        if (m_teaches) Settings(settingsFile()).setFace(Face::teach);
        if (m_looksAlongAssumedBeam) Settings(settingsFile()).setSideTaken("MetaImage", "side-1");
        Settings(settingsFile()).setSidesShown(m_seesSides);
        showAgain();
    }
    /// Shows the window of another start, with the present settings and what the start before left.
    void showAgain() { showWithSettings(settingsFile()); }
    void showWithSettings(const QString& settings) {
        m_window = std::make_unique<MainWindow>(settings);
        m_window->resize(m_looksAtNoPicture ? QSize(800, 560) : QSize(1000, 700));
        // On a busy machine a test may look at a message later than a person would.
        child<MessageBar>("message")->setConfirmationMilliseconds(600'000);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        // A virtual display has no window manager to activate the window.
        QApplication::setActiveWindow(m_window.get());
    }
    /// Replaces the look that the window starts with. Look{} neither reduces speckle nor adds light.
    void useLook(const Look& look) {
        Document next = window().document().document();
        next.scene.look = look;
        window().document().begin(next);
    }
    void close() {
        keepPictureOfFailure();
        if (m_window) m_window->otfEditor().setManualSaved();
        m_window.reset();
    }
    void open(const QString& path) {
        QSignalSpy computed(&window().otfs(), &PaneOtfs::computed);
        window().open(path);
        QVERIFY(computed.wait(patience));
        waitUntilIdle();
    }
    void waitUntilIdle() {
        QTRY_VERIFY_WITH_TIMEOUT(window().idle() && (!m_waitsForFinePictures || window().volumeView().pictureIsFine()),
                                 30000);
        if (m_looksAtNoPicture) m_waitsForFinePictures = false;
    }
    /// For a class that looks at no picture: its windows have a small one. From now on only the next waitUntilIdle()
    /// waits until the picture is fine.
    void lookAtNoPicture() { m_looksAtNoPicture = true; }
    /// For a class that looks at the strip of sides, whose pictures take their time: from now on show() shows it.
    void seeSides() { m_seesSides = true; }
    /// For a class that looks at what Teach alone shows: from now on show() begins in Teach, and not in Review.
    void teach() { m_teaches = true; }
    /// For a class that is about other things than opening: windows shown from now on open MetaImage files whose beam
    /// is not sure from side 1, along +z, as if a person had taken that side last.
    void lookAlongAssumedBeam() { m_looksAlongAssumedBeam = true; }
    [[nodiscard]] MainWindow& window() { return *m_window; }
    [[nodiscard]] const QTemporaryDir& temporaryFolder() const { return m_folder; }
    [[nodiscard]] QString settingsFile() const { return m_folder.filePath("settings.ini"); }
    template <typename Widget = QWidget>
    Widget* child(const QString& name) {
        auto* found = window().findChild<Widget*>(name);
        if (found == nullptr) qFatal("no %s", qPrintable(name));
        return found;
    }
    /// The OpenGL window of the 3D view, which receives the mouse.
    QWindow* pictureWindow() { return window().windowHandle()->findChild<QWindow*>("view3d.surface"); }
    void click(const QString& name) { QTest::mouseClick(child<QAbstractButton>(name), Qt::LeftButton); }

private:
    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
    bool m_waitsForFinePictures = true, m_looksAtNoPicture = false, m_looksAlongAssumedBeam = false, m_teaches = false,
         m_seesSides = false;
};

}  // namespace echolucent
