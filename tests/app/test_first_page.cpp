// What of a report's texts stands on its first page: it fits, and nothing is lost.
#include <QTest>
#include <algorithm>
#include <cmath>
#include <random>

#include "app/report/case_report.h"
#include "app/report/first_page.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

namespace {

std::string words(int count, const std::string& word = "finding") {
    std::string text;
    for (int i = 0; i < count; ++i) text += (i > 0 ? " " : "") + word;
    return text;
}

std::vector<FirstPageRow> rowsOf(int count, const std::string& comment = {}) {
    std::vector<FirstPageRow> rows;
    for (int i = 1; i <= count; ++i) rows.push_back({"FL " + std::to_string(i), "30.2", "mm", comment});
    return rows;
}

/// Of the sheet's column and of the table's, at 4.6 mm a line and 1.4 mm beside each row.
double heightOf(const FirstPageTexts& texts) {
    double height = 0.0;
    for (const FirstPageText* text : {&texts.impression, &texts.comment})
        if (!text->text.empty()) height += 4.6 * static_cast<double>(endsOfLines(text->text, 84).size());
    for (const FirstPageRow& row : texts.rows)
        height += 1.4 + 4.6 * static_cast<double>(
                                  std::max(endsOfLines(row.name, 20).size(), endsOfLines(row.comment, 44).size()));
    return height;
}

}  // namespace

class TestFirstPage : public QObject {
    Q_OBJECT

private slots:
    void linesEndAtBlanksAndAreNoLongerThanTheirWidth() {
        const auto linesOf = [](std::string_view text, int width) {
            std::vector<std::string> lines;
            std::size_t begin = 0;
            for (const std::size_t end : endsOfLines(text, width)) {
                lines.emplace_back(text.substr(begin, end - begin));
                begin = end;
                if (begin < text.size() && (text[begin] == ' ' || text[begin] == '\n')) ++begin;
            }
            return lines;
        };
        using Lines = std::vector<std::string>;
        QCOMPARE(linesOf("", 10), Lines{""});
        QCOMPARE(linesOf("a heart that beats", 8), (Lines{"a heart", "that", "beats"}));
        QCOMPARE(linesOf("a heart\n\nbeats", 10), (Lines{"a heart", "", "beats"}));
        QCOMPARE(linesOf("ends here\n", 10), (Lines{"ends here", ""}));
        QCOMPARE(linesOf("abcdefgh", 3), (Lines{"abc", "def", "gh"}));
        QCOMPARE(linesOf("äöü äöü", 3), (Lines{"äöü", "äöü"}));
        QCOMPARE(linesOf("心臓心臓", 4), (Lines{"心臓", "心臓"}));
    }

    void shortTextsStandWhole() {
        const FirstPageTexts texts = textsOfFirstPage(rowsOf(6), "No finding.", "Seen\ntwice.");
        QCOMPARE(texts.rows, rowsOf(6));
        QCOMPARE(texts.leftOut, 0U);
        QVERIFY(texts.rowsAreWhole && texts.impression.isWhole && texts.comment.isWhole);
        QCOMPARE(texts.impression.text, std::string("No finding."));
        QCOMPARE(texts.comment.text, std::string("Seen\ntwice."));
        QVERIFY(std::abs(texts.heightMm - (6 * 6.0 + 4.6 + 2 * 4.6)) < 1e-9);
        QVERIFY(textsOfFirstPage({}, "", "").rows.empty());
        QCOMPARE(textsOfFirstPage({}, "", "").heightMm, 0.0);
    }

    void whateverIsTypedFits() {
        std::mt19937 random(34);
        const auto upTo = [&random](int most) { return static_cast<int>(random() % static_cast<unsigned>(most + 1)); };
        for (int i = 0; i < 200; ++i) {
            const char* word = i % 3 == 0 ? "心臓の四腔断面" : i % 3 == 1 ? "four-chamber" : "a\n";
            const std::string impression = words(upTo(i), word), comment = words(upTo(2 * i));
            const auto rows = rowsOf(upTo(30), words(upTo(20), word));
            const FirstPageTexts texts = textsOfFirstPage(rows, impression, comment);
            QVERIFY(texts.heightMm <= 100.0 + 1e-9);
            // The mark of a cut may take a line more.
            QVERIFY2(heightOf(texts) <= 100.0 + 2 * 4.6, qPrintable(QString::number(heightOf(texts))));
            QCOMPARE(texts.rows.size() + texts.leftOut, rows.size());
            QCOMPARE(texts.impression.isWhole, texts.impression.text == impression);
            QCOMPARE(texts.comment.isWhole, texts.comment.text == comment);
            for (const FirstPageText* text : {&texts.impression, &texts.comment})
                QCOMPARE(text->isWhole, !QString::fromStdString(text->text).endsWith(u'…'));
        }
    }

    void eachTextHasItsShareAndTakesWhatOthersLeave() {
        const std::string much = words(600);
        const FirstPageTexts all = textsOfFirstPage(rowsOf(40), much, much);
        QVERIFY(all.rows.size() >= 4 && all.leftOut > 0);
        const std::size_t share = endsOfLines(all.impression.text, 84).size();
        QVERIFY(share >= 7);
        QVERIFY(endsOfLines(all.comment.text, 84).size() >= 7);
        const FirstPageTexts alone = textsOfFirstPage({}, much, "");
        QVERIFY(endsOfLines(alone.impression.text, 84).size() > 2 * share);
        QVERIFY(textsOfFirstPage(rowsOf(40), "", "").rows.size() > 3 * all.rows.size());
        const FirstPageTexts commented = textsOfFirstPage(rowsOf(2, much), "", "");
        QCOMPARE(commented.rows.size(), std::size_t{2});
        QVERIFY(!commented.rowsAreWhole);
        // The longest name in wide letters, beside as much text as there can be.
        std::string wide;
        for (int i = 0; i < 80; ++i) wide += "\xE6\xB8\xAC";
        const FirstPageTexts named =
            textsOfFirstPage({{.name = wide, .value = "4", .unit = "mm", .comment = {}}}, much, much);
        QCOMPARE(named.rows.size(), std::size_t{1});
        QVERIFY(!named.rowsAreWhole);
    }

    void aReportOfSeveralVolumesCallsThemVolumes() {
        CaseReport report;
        report.withAppendix = true;
        report.geometry = {.size = {60, 60, 60}};
        report.phases = 2;
        report.document.measurements = {{.id = 1, .placesMm = {{1, 1, 1}, {1, 1, 11}}, .phase = 1}};
        const QString page = QString::fromStdString(caseReportPage(report));
        QVERIFY(page.contains("distance 1, volume 2"));
        QVERIFY(page.contains(">volume</th>"));
        QVERIFY(!page.contains("phase 2") && !page.contains(">phase</th>"));
    }

    void whatHasNoRoomStandsInTheAppendixWhole() {
        CaseReport report;
        report.study = "heart.nrrd";
        report.withAppendix = true;
        report.geometry = {.size = {60, 60, 60}};
        report.comment = words(400) + " last word of the comment";
        report.impression = "short";
        for (int i = 1; i <= 40; ++i) {
            Measurement next{.id = i, .placesMm = {{1, 1, 1}, {1, 1, 11}}, .name = "name" + std::to_string(i)};
            if (i == 1) next.comment = words(60) + " last word of a measurement";
            report.document.measurements.push_back(next);
        }
        const QString page = QString::fromStdString(caseReportPage(report));
        const QStringList parts = page.split("<section class=\"appendix\">");
        QCOMPARE(parts.size(), 2);
        const auto rows = parts[0].count("<td>mm</td>");
        QVERIFY(rows >= 4 && rows < 40);
        QVERIFY2(parts[0].contains(QStringLiteral("Continued in the appendix: %1 more of 40 measurements, comments on "
                                                  "measurements, the comment.")
                                       .arg(40 - rows)),
                 qPrintable(parts[0].right(400)));
        for (const char* end : {"last word of the comment", "last word of a measurement"}) {
            QVERIFY(!parts[0].contains(end));
            QCOMPARE(parts[1].count(end), 1);
        }
        for (int i = 1; i <= 40; ++i) QCOMPARE(parts[1].count(QStringLiteral("<td>name%1</td>").arg(i)), 1);
        QVERIFY(!parts[1].contains("Impression"));
        QVERIFY(parts[0].contains("Not a medical device") && parts[1].contains("Not a medical device"));
    }
};

ECHOLUCENT_TEST_CLASS(TestFirstPage)
#include "test_first_page.moc"
