// What the window calls studies and files: names, or numbers, since names of files can be names of patients.
#pragma once

#include <QHash>
#include <QObject>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "processing/result.h"

namespace echolucent {

class Settings;

/// All of the window asks here before it shows the name of a file or a folder. If numbers are shown, a study is called
/// "Study 3", the same at every start, and its sessions "Study 3 (session)". Any other file is called by its ending
/// alone. Names that were given out are remembered while the program runs, for shownBefore().
class StudyNames : public QObject {
    Q_OBJECT

public:
    /// `settings` must outlive this object; it remembers the switch and the numbers.
    explicit StudyNames(Settings& settings, QObject* parent = nullptr);

    [[nodiscard]] bool showsNumbers() const { return m_numbers; }
    void showNumbers(bool numbers);

    /// From here on, texts are searched for the names of the study at `path` and of the files it was read from. Call it
    /// before anything of the study is shown.
    void know(const QString& path, const QStringList& files = {});
    /// know() for a session file. At every start the session is called by the number of the study at `study`; `study`
    /// is empty for a simulated scan.
    void knowSession(const QString& session, const QString& study);

    /// The name of the file or folder of a study or a session, or "Study 3".
    [[nodiscard]] QString nameOf(const QString& path);
    /// nameOf() for a study that is only asked for: while names are shown, this gives it no number.
    [[nodiscard]] QString nameOfAsked(const QString& path);
    /// The beginning for names of files of a study or a session: the file's own name without its ending, or "study-3";
    /// "simulated-scan" if the path is empty.
    [[nodiscard]] QString beginningFor(const QString& path) const;
    /// The name of a file that is not a study, a curve for example; or its ending only, "*.json".
    [[nodiscard]] QString nameOfOther(const QString& path);
    /// A text as it may be shown. If numbers are shown, they replace the names of known studies, and anything else that
    /// looks like a path is left out.
    [[nodiscard]] QString shown(const QString& text) const;
    /// shown() for a text from reading a file, which may name other files. If numbers are shown, anything that looks
    /// like a file name is replaced by its ending.
    [[nodiscard]] QString shownOfFile(const QString& text) const;
    /// shownOfFile() for a text from a time when names were shown. If numbers are shown, names that were given out are
    /// replaced wherever they stand alone, even if they may be words.
    [[nodiscard]] QString shownBefore(const QString& text) const;
    /// The sentence of a failure whose file may not be a study.
    [[nodiscard]] QString sentenceOf(const Failure& failure);

signals:
    /// Names became numbers, or numbers names.
    void changed();

private:
    /// Where a piece of text counts as a name. Words in small letters, short names and short numbers may stand in a
    /// sentence for something else. They count only within names of files or paths.
    enum class Standing { anywhere, inNames, inPaths };
    [[nodiscard]] static Standing standingOf(const QString& name);
    /// A piece of text that names a study.
    struct Known {
        QString name;
        int study = 0;
        Standing standing = Standing::anywhere;
    };
    [[nodiscard]] const std::vector<Known>& known() const;
    [[nodiscard]] QString numbered(QString text) const;
    [[nodiscard]] QString numberOf(const QString& path);
    /// The name, or `instead` if numbers are shown. A name is remembered with its replacement.
    [[nodiscard]] QString given(const QString& name, const QString& instead);

    Settings& m_settings;
    bool m_numbers;
    QHash<QString, int> m_studies, m_files;             ///< the numbers of paths, and of the files read for them
    QHash<QString, QString> m_given;                    ///< replacements of the names that were given out
    mutable std::optional<std::vector<Known>> m_known;  ///< longest first; made on demand
};

}  // namespace echolucent
