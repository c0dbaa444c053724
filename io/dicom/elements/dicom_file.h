// One DICOM file, scanned for harm and then parsed by DCMTK.
#pragma once

#include <memory>
#include <string>

#include "io/dicom/elements/dicom_scan.h"
#include "io/files/input_file.h"
#include "processing/progress.h"
#include "processing/result.h"

class DcmDataset;
class DcmFileFormat;

namespace echolucent {

/// A file as DCMTK has parsed it, with the results of the scan before.
class DicomFile {
public:
    /// Scans and parses an opened file. If `headerOnly` is set, parsing stops before the pixel data. `progress` is
    /// polled for cancel between elements. Fails if the file is damaged, if it is no image that can be read, or if the
    /// person cancelled.
    [[nodiscard]] static Result<DicomFile> load(const InputFile& input, bool headerOnly, const Progress& progress);
    /// Opens the file at `path` and does the same.
    [[nodiscard]] static Result<DicomFile> load(const std::string& path, bool headerOnly, const Progress& progress);
    /// Reads what a damaged file still tells: the elements of its header before the damage. Fails if the file is no
    /// DICOM, if it would do harm, or if the person cancelled.
    [[nodiscard]] static Result<DicomFile> loadRest(const InputFile& input, const Progress& progress);
    DicomFile(DicomFile&&) noexcept;
    DicomFile& operator=(DicomFile&&) noexcept;
    ~DicomFile();

    [[nodiscard]] DcmDataset& dataset() const;
    [[nodiscard]] const DicomScan& scan() const { return m_scan; }
    [[nodiscard]] const std::string& path() const { return m_path; }

private:
    DicomFile(std::string path, DicomScan scan);
    std::string m_path;
    DicomScan m_scan;
    std::unique_ptr<DcmFileFormat> m_file;
};

}  // namespace echolucent
