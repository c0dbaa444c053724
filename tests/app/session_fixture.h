// The main window with a small volume in a folder of its own, for test classes of sessions.
#pragma once

#include <QFileDialog>
#include <QLineEdit>
#include <QTimer>
#include <atomic>
#include <functional>
#include <thread>

#include "app/sessions/session_keeping.h"
#include "io/document/session_file.h"
#include "tests/app/window_fixture.h"
#include "widgets/controls/message_bar.h"

namespace echolucent {

class SessionFixture : public WindowFixture {
public:
    SessionFixture() : m_small(smallPhantom(PhantomScene::shapes, 5)) {
        lookAtNoPicture();
        lookAlongAssumedBeam();
    }

    /// A window that shows studyFile(), "heart.mha" unless another name is given.
    void begin(const QString& name = QStringLiteral("heart.mha")) {
        m_studyFolder = std::make_unique<QTemporaryDir>();
        m_study = inFolder(name);
        if (!writeMetaImage(m_study.toStdString(), {m_small})) qFatal("%s", qPrintable(m_study));
        show();
        useLook(Look{});
        open(m_study);
    }
    [[nodiscard]] QString studyFile() const { return m_study; }
    [[nodiscard]] QString inFolder(const QString& name) const { return m_studyFolder->filePath(name); }

    [[nodiscard]] const Document& document() { return window().document().document(); }
    [[nodiscard]] MessageBar* message() { return child<MessageBar>("message"); }
    [[nodiscard]] static QByteArray bytesOf(const QString& path) {
        QFile in(path);
        return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
    }
    /// The document without its study's name.
    [[nodiscard]] static Document nameless(Document document) {
        document.study = {};
        return document;
    }
    [[nodiscard]] QStringList autosaves() {
        return QDir(temporaryFolder().filePath("settings-data/autosaves")).entryList({"*.autosave.json"}, QDir::Files);
    }
    /// Changes most kinds of things that a person sets.
    void work() {
        Document next = document();
        next.scene.pose.direction = {.azimuth = 20, .elevation = -8, .roll = 3};
        next.scene.front.depthMm = 4;
        ScalpelStroke stroke{.tool = ScalpelTool::eraser, .places = {{-0.2, 0.1}, {0.2, -0.1}}, .radius = 0.06};
        stroke.camera = {{27, 25, 30}, frameOf(Viewpoint{.azimuthDegrees = 10}), Projection::parallel, 60, 30, 100};
        next.scene.strokes.push_back(stroke);
        next.measurements.push_back({.id = 1, .placesMm = {{10, 12, 14}, {30, 20, 14}}});
        next.scene.look.brightness = 1.3;
        next.curves.linear.lower = 0.2;
        window().document().edit(next, "work");
        QVERIFY(window().sessionKeeping().snapshots().keep("as it was", document()).isEmpty());
        window().motionPlayer().setAngle(7);
        waitUntilIdle();
    }
    /// The open study's session, saved as inFolder(name).
    QString savedSession(const QString& name = QStringLiteral("heart.session.json")) {
        const QString session = inFolder(name);
        waitUntilIdle();
        QSignalSpy saved(&window().sessionKeeping(), &SessionKeeping::saved);
        window().sessionKeeping().saveAs(session);
        if (!saved.wait(patience)) qFatal("nothing was saved");
        waitUntilIdle();
        return session;
    }
    /// Opens the session in the window of another start, with settings of its own.
    void again(const QString& session) {
        close();
        show();
        open(session);
    }
    /// Opens the study inFolder(name). Its checksum waits for release().
    void openHeld(const QString& name) {
        m_held = true;
        window().openStudy().setChecksum([this](const auto& files, const Progress& progress) {
            while (m_held && !progress.cancelled()) std::this_thread::yield();
            return checksumOf(files, progress);
        });
        if (!writeMetaImage(inFolder(name).toStdString(), {smallPhantom(PhantomScene::fetus, 3)})) qFatal("no study");
        QSignalSpy computed(&window().otfs(), &PaneOtfs::computed);
        window().open(inFolder(name));
        QVERIFY(computed.wait(patience));
        QTRY_VERIFY(window().openStudy().takingChecksum());
    }
    void release() { m_held = false; }

    /// Does something to the file dialog that the next event opens. The dialog is then accepted or rejected as by a
    /// program.
    void answerDialog(const std::function<void(QFileDialog&)>& act, bool accept) {
        QTimer::singleShot(0, &window(), [act, accept] {
            QFileDialog& dialog = fileDialog();
            act(dialog);
            static_cast<QDialog&>(dialog).done(accept ? QDialog::Accepted : QDialog::Rejected);
        });
    }
    /// Chooses a file in the dialog that the message's first action opens. Returns the file that the dialog proposed.
    QString chooseInMessage(const QString& path) {
        QString proposed;
        answerDialog(
            [&](QFileDialog& dialog) {
                proposed = dialog.selectedFiles().value(0);
                dialog.selectFile(path);
            },
            true);
        click("message.action.0");
        return proposed;
    }
    /// Types a name and Return into the file dialog that the next event opens.
    void typeIntoDialog(const QString& name) {
        QTimer::singleShot(0, &window(), [name] {
            auto* line = fileDialog().findChild<QLineEdit*>("fileNameEdit");
            if (line == nullptr) qFatal("nothing to type into");
            line->selectAll();
            QTest::keyClicks(line, name);
            QTest::keyClick(line, Qt::Key_Return);
        });
    }
    [[nodiscard]] static QFileDialog& fileDialog() {
        for (QWidget* each : QApplication::topLevelWidgets())
            if (auto* found = qobject_cast<QFileDialog*>(each); found && found->isVisible()) return *found;
        qFatal("there is no dialog");
    }

private:
    std::shared_ptr<const Volume> m_small;
    std::unique_ptr<QTemporaryDir> m_studyFolder;
    QString m_study;
    std::atomic<bool> m_held = false;
};

}  // namespace echolucent
