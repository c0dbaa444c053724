#include "app/study/dropped_files.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QSet>
#include <QStringDecoder>
#include <QStringList>
#include <QSysInfo>
#include <algorithm>
#include <utility>

#include "io/file_formats.h"
#include "io/headers/raw_volume.h"
#include "processing/one_line.h"

namespace echolucent {

namespace {

DroppedFiles refused(const char* sentence, const QString& words = {}) {
    const QString told = QCoreApplication::translate("DroppedFiles", sentence);
    return {.whyNot = words.isEmpty() ? told : told.arg(words)};
}

QString shownOf(const QUrl& url) {
    constexpr std::size_t longest = 160;
    return QString::fromStdString(oneLine(url.toDisplayString().toStdString(), longest));
}

/// Some programs name this computer in the addresses of its files.
bool isHere(const QUrl& url) {
    const QString host = url.host();
    return url.isLocalFile() && (host.isEmpty() || host.compare(QLatin1String("localhost"), Qt::CaseInsensitive) == 0 ||
                                 host.compare(QSysInfo::machineHostName(), Qt::CaseInsensitive) == 0);
}

bool isUtf8(const QUrl& url) {
    QStringDecoder decoder(QStringDecoder::Utf8);
    const QString decoded = decoder(QByteArray::fromPercentEncoding(url.path(QUrl::FullyEncoded).toLatin1()));
    return !decoder.hasError() && !decoded.contains(QChar::ReplacementCharacter);
}

/// The path; the name of a folder ends with no slash.
QString pathOf(QUrl url) {
    url.setHost({});
    return QDir::cleanPath(url.toLocalFile());
}

bool isDocument(const QString& path) { return path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive); }

const FileFormat* formatOf(const QString& path) {
    const QString pair = QFileInfo(path).suffix().toLower();
    return formatFromName(pair == QLatin1String("hdr") ? QStringLiteral("pair.nii").toStdString() : path.toStdString());
}

bool isHeader(const QString& path) {
    const FileFormat* format = formatOf(path);
    return format != nullptr && format->name != std::string_view("DICOM");
}

/// Whether a file may be a DICOM slice: by its ending, or since it has none but a number ("IM0001", "1.2.840.17"). A
/// name without ending and digits ("README", "anna") is rather that of another file or of a folder.
bool maybeSlice(const QString& path) {
    if (const FileFormat* format = formatOf(path)) return format->name == std::string_view("DICOM");
    const auto isDigit = [](QChar letter) { return letter.isDigit(); };
    const QFileInfo file(path);
    const QString ending = file.suffix();
    return ending.isEmpty() ? std::ranges::any_of(file.fileName(), isDigit) : std::ranges::all_of(ending, isDigit);
}

/// The names of files that belong to a volume and are not opened by themselves: the layout of raw voxels lies beside
/// them and is found, and converters of DICOM write side-cars ("v.nii.gz" has "v.json", "v.bval", "v.bvec").
QStringList namesBeside(const QString& volume) {
    QStringList names{QString::fromStdString(rawLayoutPath(volume.toStdString()))};
    for (const char* ending : {".nii", ".nii.gz"}) {
        if (!volume.endsWith(QLatin1String(ending))) continue;
        const QString stem = volume.chopped(QLatin1String(ending).size());
        names << stem + QLatin1String(".json") << stem + QLatin1String(".bval") << stem + QLatin1String(".bvec");
    }
    return names;
}

}  // namespace

DroppedFiles droppedFiles(const QList<QUrl>& urls) {
    QStringList paths;
    for (const QUrl& url : urls) {
        if (!isHere(url))
            return refused(QT_TRANSLATE_NOOP("DroppedFiles",
                                             "%1 is no file of this computer. Copy it here, and then open the copy."),
                           shownOf(url));
        if (!isUtf8(url))
            return refused(QT_TRANSLATE_NOOP("DroppedFiles",
                                             "%1 is named in another coding than UTF-8, which the window cannot open. "
                                             "Rename it, or use echolucent-cli."),
                           shownOf(url));
        paths << pathOf(url);
    }
    paths.removeDuplicates();
    QSet<QString> beside;
    for (const QString& path : std::as_const(paths))
        for (const QString& name : namesBeside(path)) beside.insert(name);
    paths.removeIf([&beside](const QString& path) { return beside.contains(path); });
    if (paths.isEmpty()) return {.whyNot = {}};
    if (paths.size() == 1) return {.path = paths.front()};
    const auto documents = std::ranges::count_if(paths, isDocument);
    if (documents == 1 && paths.size() == 2) {
        const bool first = isDocument(paths.front());
        return {.path = paths[first ? 0 : 1], .study = paths[first ? 1 : 0]};
    }
    const QString folder = QFileInfo(paths.front()).path();
    const bool oneFolder =
        std::ranges::all_of(paths, [&folder](const QString& path) { return QFileInfo(path).path() == folder; });
    if (documents == 0 && oneFolder) {
        const auto headers = std::ranges::count_if(paths, isHeader);
        const auto slices = std::ranges::count_if(paths, maybeSlice);
        if (headers == 1 && slices == 0) return {.path = *std::ranges::find_if(paths, isHeader)};
        if (slices == paths.size()) return {.path = folder, .slices = paths};
    }
    return refused(
        QT_TRANSLATE_NOOP("DroppedFiles",
                          "Several things were dropped, and the window shows one study. Drop one file or one "
                          "folder, or all slices of one folder."));
}

}  // namespace echolucent
