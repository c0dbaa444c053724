#include "widgets/names/names_page.h"

#include <QRegularExpression>
#include <algorithm>
#include <set>

namespace echolucent {

namespace {

/// One row of a table, of one or several controls.
struct Row {
    NamedControl control;
    QStringList names;  ///< of all that the row stands for
    QString paths;
};

/// The panel's own name left out: every panel has these.
QString ofEveryPanel(const QString& name) {
    static const QRegularExpression tab(QStringLiteral("^dock\\.\\w+\\.(tab\\.\\w+|close)$"));
    return tab.match(name).hasMatch() ? QStringLiteral("dock.PANEL.") + tab.match(name).captured(1) : QString();
}

QString cell(QString words) { return words.replace(u'|', QLatin1String("\\|")); }

/// "`view.brightness`, `.value`, `.reset`".
QString namesCell(const Row& row) {
    QString words = QStringLiteral("`%1`").arg(row.names.front());
    for (qsizetype i = 1; i < row.names.size(); ++i)
        words += QStringLiteral(", `%1`").arg(row.names[i].mid(row.names.front().size()));
    return words;
}

std::vector<Row> rowsOf(const std::vector<NamedControl>& controls, const SetPaths& paths) {
    std::vector<Row> rows;
    std::map<QString, std::size_t> sliders;
    std::set<QString> seen;
    for (NamedControl control : controls) {
        if (const QString name = ofEveryPanel(control.name); !name.isEmpty()) {
            control.name = name;
            control.place = QStringLiteral("Every panel");
        }
        if (!seen.insert(control.name).second) continue;
        // What a text says changes all the time, and so does its tool tip.
        if (control.role == QStringLiteral("text")) control.description.clear();
        const QString of = control.name.section(u'.', 0, -2), last = control.name.section(u'.', -1);
        if (const auto slider = sliders.find(of);
            slider != sliders.end() && (last == QStringLiteral("value") || last == QStringLiteral("reset"))) {
            rows[slider->second].names << control.name;
            continue;
        }
        if (control.role == QStringLiteral("slider") || control.role == QStringLiteral("number"))
            sliders.emplace(control.name, rows.size());
        const auto path = paths.find(control.name);
        rows.push_back({control, {control.name}, path != paths.end() ? path->second : QString()});
    }
    return rows;
}

}  // namespace

QString namesPage(const std::vector<NamedControl>& controls, const SetPaths& paths) {
    const std::vector<Row> rows = rowsOf(controls, paths);
    QStringList places;
    for (const Row& row : rows)
        if (!places.contains(row.control.place)) places << row.control.place;
    QString page = QStringLiteral(
        "# Names\n\n"
        "Every control, panel, pane and action of the window has an object name. Tests and scripts find it by that "
        "name, "
        "and screen\n"
        "readers say its label. A name that stands here stays: `tests/app/names/` holds the names of each version, and "
        "TestNames fails if\n"
        "one of them is gone. *Sets* names the values of the document that a control changes\n"
        "([paths](document.md#paths)). What it says was measured by using the control. If the cell is empty, the "
        "control "
        "changes what is\n"
        "shown, opens something, writes a file, or was disabled. `.value` is the number beside a slider, `.reset` the "
        "button behind it.\n\n"
        "<!-- The program writes this page, and tests/app/test_names.cpp says how. Nobody edits it by hand. -->\n");
    for (const QString& place : places) {
        page +=
            QStringLiteral("\n## %1\n| name | role | label | what it does | sets | key |\n|---|---|---|---|---|---|\n")
                .arg(place);
        for (const Row& row : rows)
            if (row.control.place == place)
                page += QStringLiteral("| %1 | %2 | %3 | %4 | %5 | %6 |\n")
                            .arg(namesCell(row), row.control.role, cell(row.control.label),
                                 cell(row.control.description), row.paths, row.control.key);
    }
    return page;
}

QStringList sortedNames(const std::vector<NamedControl>& controls) {
    QStringList names;
    for (const NamedControl& control : controls) names << control.name;
    std::sort(names.begin(), names.end());
    names.removeDuplicates();
    return names;
}

}  // namespace echolucent
