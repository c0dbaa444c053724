// What the window calls studies and files: their names, or numbers, since names of files can be names of patients.
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

/// Everything in the window that would show the name of a file or a folder asks here. Where numbers are shown, a study
/// is called "Study 3", the same at every start, its sessions "Study 3 (session)", and any other file by its ending
/// alone. Names that were given out are remembered while the program runs, so that shownBefore() knows them.
class StudyNames : public QObject {
    Q_OBJECT

public:
    /// `settings` must outlive this; it remembers the switch and the numbers.
    explicit StudyNames(Settings& settings, QObject* parent = nullptr);

    [[nodiscard]] bool showsNumbers() const { return m_numbers; }
    void showNumbers(bool numbers);

    /// From here on texts are searched for the names of a study at `path` and of the files it was read from. It is to
    /// be called before anything of the study is shown.
    void know(const QString& path, const QStringList& files = {});
    /// The same for a session file: from here on, at every start, it is called by the number of the study at `study`,
    /// which is empty where that is simulated.
    void knowSession(const QString& session, const QString& study);

    /// The name of the file or folder of a study or a session, or "Study 3".
    [[nodiscard]] QString nameOf(const QString& path);
    /// What names of files that belong to a study or a session begin with: the file's own name without its ending, or
    /// "study-3"; "simulated-scan" where the path is empty.
    [[nodiscard]] QString beginningFor(const QString& path) const;
    /// The name of a file that is no study, a curve for example; or nothing of it but the ending, "*.json".
    [[nodiscard]] QString nameOfOther(const QString& path);
    /// A text as it may be shown. Where numbers are shown, those stand for the names of studies that are known, and
    /// whatever else looks like the path of a file is left out.
    [[nodiscard]] QString shown(const QString& text) const;
    /// The same for a text that comes from reading a file, which may name others: where numbers are shown, whatever
    /// looks like the name of a file is left out too.
    [[nodiscard]] QString shownOfFile(const QString& text) const;
    /// The same for a text that stood on the screen while names were shown: those that were given out till now are
    /// replaced wherever they stand alone, though they may be words.
    [[nodiscard]] QString shownBefore(const QString& text) const;
    /// The sentence of a failure that concerns a file which may be no study.
    [[nodiscard]] QString sentenceOf(const Failure& failure);

signals:
    /// Names became numbers, or numbers names.
    void changed();

private:
    /// Where a piece of text is a name: what may stand in a sentence for something else, as words, short ones and
    /// numbers do, is one only where names of files stand.
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
    /// The name, or where numbers are shown what stands for it; remembers both.
    [[nodiscard]] QString given(const QString& name, const QString& instead);

    Settings& m_settings;
    bool m_numbers;
    QHash<QString, int> m_studies, m_files;             ///< the numbers of paths, and of the files read for them
    QHash<QString, QString> m_given;                    ///< what stands for names that were given out
    mutable std::optional<std::vector<Known>> m_known;  ///< longest first; made when it is asked for
};

}  // namespace echolucent
