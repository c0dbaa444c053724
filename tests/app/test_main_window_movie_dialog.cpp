// The dialog for movies and series of pictures: what it proposes, what it refuses, and what it replaces.
#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QImage>
#include <QLabel>
#include <QSpinBox>

#include "app/window/theme.h"
#include "tests/app/movie_fixture.h"
#include "tests/app/telling_names.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

class TestMainWindowMovieDialog : public QObject, private MovieFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        wearTheme(Theme::dark);
        writeStudies();
    }
    void init() { showWindow(); }
    void cleanup() { close(); }

    void theSwivelOfAProbeIsWrittenWithItsAngles() {
        open(still());
        child<QAction>("file.saveMovie")->trigger();
        QDialog* dialog = theDialog();
        QVERIFY2(in<QLabel>(dialog, "plays")->text().contains("Rotation from −45° to +45° (screen's vertical)"),
                 qPrintable(in<QLabel>(dialog, "plays")->text()));
        QCOMPARE(in<QDoubleSpinBox>(dialog, "rate")->value(), motionDegreesPerSecond);
        QCOMPARE(in<QComboBox>(dialog, "lengthUnit")->itemText(0), QString("loops"));
        QCOMPARE(in<QLabel>(dialog, "sentence")->text(), QString("180 frames, 6.0 s"));
        QTest::keyClick(dialog, Qt::Key_Escape);
        QTRY_VERIFY(window().findChild<QDialog*>("movieDialog") == nullptr);
        QVERIFY(window().idle());
    }

    void theLengthIsBeatsOrTurnsOrSeconds() {
        open(moving());
        playThePhases();
        child<QAction>("file.saveMovie")->trigger();
        QDialog* dialog = theDialog();
        auto* length = in<QDoubleSpinBox>(dialog, "length");
        auto* unit = in<QComboBox>(dialog, "lengthUnit");
        const auto sentence = [dialog] { return in<QLabel>(dialog, "sentence")->text(); };
        QCOMPARE(unit->itemText(0), QString("loops"));
        type(length, "5");
        QCOMPARE(sentence(), QString("20 frames, 1.0 s"));
        unit->setCurrentIndex(1);
        QCOMPARE(length->value(), 1.0);  // the movie is as long as it was
        type(length, "2.5");
        QCOMPARE(sentence(), QString("50 frames, 2.5 s"));
        type(in<QDoubleSpinBox>(dialog, "rate"), "10");
        QCOMPARE(sentence(), QString("25 frames, 2.5 s"));
        unit->setCurrentIndex(0);
        QCOMPARE(length->value(), 6.0);  // whole beats
        QCOMPARE(sentence(), QString("24 frames, 2.4 s"));
        type(in<QSpinBox>(dialog, "width"), "32");
        type(in<QSpinBox>(dialog, "height"), "32");
        write(in<QLineEdit>(dialog, "path"), out().filePath("heart.mp4"));
        QVERIFY(save(dialog));
        // The length is proposed again, and a series of pictures has none.
        QTRY_VERIFY(window().findChild<QDialog*>("movieDialog") == nullptr);
        child<QAction>("file.saveMovie")->trigger();
        QCOMPARE(in<QDoubleSpinBox>(theDialog(), "length")->value(), 6.0);
        QTest::keyClick(theDialog(), Qt::Key_Escape);
        QTRY_VERIFY(window().findChild<QDialog*>("movieDialog") == nullptr);
        child<QAction>("file.savePictureSeries")->trigger();
        QVERIFY(!in<QDoubleSpinBox>(theDialog(), "length")->isVisible());
        QVERIFY(!in<QComboBox>(theDialog(), "lengthUnit")->isVisible());
        QCOMPARE(in<QLabel>(theDialog(), "sentence")->text(), QString("4 pictures"));
        QTest::keyClick(theDialog(), Qt::Key_Escape);
        QTRY_VERIFY(window().findChild<QDialog*>("movieDialog") == nullptr);
    }

    void theDialogRefusesWhatCannotBeWritten() {
        open(moving());
        playThePhases();
        child<QAction>("file.saveMovie")->trigger();
        QDialog* dialog = theDialog();
        auto* path = in<QLineEdit>(dialog, "path");
        auto* save = in<QPushButton>(dialog, "save");
        const auto says = [&](const QString& file, const QString& word) {
            write(path, file);
            return !save->isEnabled() && in<QLabel>(dialog, "sentence")->text().contains(word);
        };
        QVERIFY(says(out().filePath("heart.webm"), ".avi, .mp4 or .mkv"));
        QVERIFY(says(out().filePath("heart"), "does not say by its ending"));
        QVERIFY(says(out().filePath("none/heart.mp4"), "folder is not there"));
        QVERIFY(says("", "Give the file a name"));
        // A link to the study is the study.
        QVERIFY(QFile::link(moving(), out().filePath("link.mp4")));
        QVERIFY(says(out().filePath("link.mp4"), "would overwrite"));
        QVERIFY(!in<QCheckBox>(dialog, "replace")->isVisible());
        QVERIFY(QFile::remove(out().filePath("link.mp4")));
        // What is there is replaced only where that is ticked.
        QFile old(out().filePath("old.mp4"));
        QVERIFY(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
        old.close();
        QVERIFY(says(old.fileName(), "old.mp4 is there already"));
        tick(in<QCheckBox>(dialog, "replace"));
        QVERIFY(save->isEnabled());
        write(path, out().filePath("old.mp4"));
        QVERIFY2(!save->isEnabled(), "the tick was meant for another name");
        write(path, out().filePath("heart.MP4"));
        QVERIFY(save->isEnabled());
        QTest::keyClick(dialog, Qt::Key_Escape);
        QTRY_VERIFY(window().findChild<QDialog*>("movieDialog") == nullptr);
        QCOMPARE(QDir(out().path()).entryList(QDir::Files), QStringList{"old.mp4"});
    }

    void numbersStandForNamesInTheDialogAndInWhatIsSaid() {
        // In a folder and a study that are called after a person.
        QVERIFY(QDir(out().path()).mkdir("Anna Muster"));
        const QString folder = out().filePath("Anna Muster");
        const QString study = folder + "/Anna Muster.mha";
        QVERIFY(QFile::copy(moving(), study));
        open(study);
        playThePhases();
        child<QAction>("view.numbersForNames")->trigger();
        const auto told = [&] { return allWords().filter("Anna") + allWords().filter("Muster"); };
        const auto choiceOf = [&](const QString& name) {
            return MovieChoice{.path = folder + '/' + name, .size = {32, 32}};
        };
        window().movieFiles().begin(FrameOutput::movie, choiceOf("Anna Muster.mp4"));
        QVERIFY(ended());
        QCOMPARE(message()->text(), "*.mp4 was saved.");
        window().movieFiles().begin(FrameOutput::series, choiceOf("Anna Muster.png"));
        QVERIFY(ended());
        QCOMPARE(message()->text(), "*.png were saved.");
        QCOMPARE(told(), QStringList());
        // The dialog proposes that folder, and tells of what stands in the way there.
        child<QAction>("file.saveMovie")->trigger();
        QDialog* dialog = theDialog();
        QCOMPARE(in<QLineEdit>(dialog, "path")->text(), "study-1-movie.mp4");
        QCOMPARE(told(), QStringList());
        QVERIFY(QFile::link(study, folder + "/link.mp4"));
        write(in<QLineEdit>(dialog, "path"), "link.mp4");
        QVERIFY(in<QLabel>(dialog, "sentence")->text().contains("would overwrite"));
        QCOMPARE(told(), QStringList());
        write(in<QLineEdit>(dialog, "path"), "heart.mp4");
        QVERIFY(save(dialog));
        QVERIFY(QFile::exists(folder + "/heart.mp4"));
        // Nor is the folder told where something cannot be written.
        window().movieFiles().begin(FrameOutput::movie, choiceOf("none of it/Anna Muster.mp4"));
        QVERIFY(!message()->text().isEmpty());
        QCOMPARE(told(), QStringList());
    }

    void aSeriesReplacesOnlyWhereThatIsWanted() {
        open(moving());
        playThePhases();
        QFile old(out().filePath("heart-0002.png"));
        QVERIFY(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
        old.close();
        child<QAction>("file.savePictureSeries")->trigger();
        QDialog* dialog = theDialog();
        write(in<QLineEdit>(dialog, "path"), out().filePath("heart.jpg"));
        QVERIFY(in<QLabel>(dialog, "sentence")->text().contains("ends in .png"));
        write(in<QLineEdit>(dialog, "path"), out().filePath("heart.png"));
        QCOMPARE(in<QLabel>(dialog, "sentence")->text(),
                 QString("Of heart-0001.png to heart-0004.png, one is there already."));
        QVERIFY(!in<QPushButton>(dialog, "save")->isEnabled());
        type(in<QSpinBox>(dialog, "width"), "32");
        type(in<QSpinBox>(dialog, "height"), "32");
        tick(in<QCheckBox>(dialog, "replace"));
        QVERIFY(save(dialog));
        QCOMPARE(QImage(old.fileName()).size(), QSize(32, 32));
    }

    void aShorterSeriesLeavesNoneOfALongerOne() {
        open(moving());
        playThePhases();
        // A series of six pictures, and what is none of its.
        const QStringList longer{"heart-0001.png", "heart-0002.png", "heart-0003.png",
                                 "heart-0004.png", "heart-0005.png", "heart-0006.png"};
        const QStringList others{"heart-0008.png", "heart-0005.jpg", "lung-0005.png", "heart-5.png"};
        for (const QString& name : longer + others) {
            QFile file(out().filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write("old") == 3);
        }
        child<QAction>("file.savePictureSeries")->trigger();
        QDialog* dialog = theDialog();
        auto* sentence = in<QLabel>(dialog, "sentence");
        type(in<QSpinBox>(dialog, "width"), "32");
        type(in<QSpinBox>(dialog, "height"), "32");
        write(in<QLineEdit>(dialog, "path"), out().filePath("heart.png"));
        QCOMPARE(sentence->text(),
                 QString("Of heart-0001.png to heart-0004.png, 4 are there already. "
                         "Replacing also removes heart-0005.png to heart-0006.png, which a longer series left."));
        QVERIFY(!in<QPushButton>(dialog, "save")->isEnabled());
        for (int frame = 1; frame <= 4; ++frame)
            QVERIFY(QFile::remove(out().filePath(QStringLiteral("heart-000%1.png").arg(frame))));
        write(in<QLineEdit>(dialog, "path"), out().filePath("heart.png"));
        QCOMPARE(sentence->text(), QString("A longer series left heart-0005.png to heart-0006.png there. "
                                           "Replacing removes what it left."));
        QVERIFY(!in<QPushButton>(dialog, "save")->isEnabled());
        tick(in<QCheckBox>(dialog, "replace"));
        QVERIFY(save(dialog));
        QStringList expected = longer.first(4) + others;
        expected.sort();
        QCOMPARE(QDir(out().path()).entryList(QDir::Files, QDir::Name), expected);
    }
};

ECHOLUCENT_TEST_CLASS(TestMainWindowMovieDialog)

#include "test_main_window_movie_dialog.moc"
