// docs/keys.md is what the table of keys says. The program writes the page itself:
//   ECHOLUCENT_WRITE_PAGES=1 QT_QPA_PLATFORM=offscreen build/release/bin/test_widgets TestKeyTable
#include <QFile>
#include <QTest>

#include "tests/qt_program/test_classes.h"
#include "widgets/key_table.h"

using namespace echolucent;

class TestKeyTable : public QObject {
    Q_OBJECT

private slots:
    void thePageHoldsTheTableByteForByte() {
        const QByteArray expected = keysPage().toUtf8();
        QFile page(ECHOLUCENT_SOURCE_DIR "/docs/keys.md");
        if (qEnvironmentVariableIsSet("ECHOLUCENT_WRITE_PAGES")) {
            QVERIFY(page.open(QIODevice::WriteOnly | QIODevice::Truncate));
            QCOMPARE(page.write(expected), expected.size());
            page.close();
        }
        QVERIFY2(page.open(QIODevice::ReadOnly), qPrintable(page.fileName() + " cannot be read"));
        QVERIFY2(page.readAll() == expected,
                 "docs/keys.md differs from widgets/key_table.cpp: tests/widgets/test_key_table.cpp says how to write "
                 "it anew");
    }

    void everyRowStandsOnceUnderItsPlace() {
        const QStringList sections = keysPage().split(QStringLiteral("\n## "));
        QCOMPARE(sections.size(), 1 + static_cast<qsizetype>(allKeyPlaces.size()));
        for (std::size_t i = 0; i < allKeyPlaces.size(); ++i) {
            const QString& section = sections[static_cast<qsizetype>(i) + 1];
            QVERIFY2(section.startsWith(titleOf(allKeyPlaces[i]) + '\n'), qPrintable(section));
            qsizetype rows = 0;
            for (const KeyRow& row : keyTable()) {
                if (row.place != allKeyPlaces[i]) continue;
                ++rows;
                QCOMPARE(section.count(QStringLiteral("| %1 | %2 |\n").arg(row.keys, row.meaning)), 1);
                // A bar would end the cell early.
                QVERIFY2(!row.keys.contains('|') && !row.meaning.contains('|'), qPrintable(row.keys));
            }
            QVERIFY(rows > 0);
            QCOMPARE(section.count('\n'), rows + 3);  // its title and the two lines of the table's head
        }
    }
};

ECHOLUCENT_TEST_CLASS(TestKeyTable)
#include "test_key_table.moc"
